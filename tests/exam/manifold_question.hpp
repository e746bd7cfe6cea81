// SPDX-License-Identifier: MIT
// manifold(a, b).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <graze/query/manifold.hpp>

#include "exact.hpp"
#include "exam/pair_question.hpp"
#include "query/manifold_judgement.hpp"
#include "query/manifolds.hpp"
#include "query/regressions.hpp"

namespace graze::exam {

template <Dim N, class T>
class ManifoldQuestion : public PairQuestion<N, T> {
 public:
  using Any = AnyShape<N, T>;
  using Case = test::AnyPair<N, T>;
  using Truth = test::ExactVerdict;
  using Asked = AskedPair<N, T>;
  static constexpr std::string_view name = "manifold";
  static constexpr std::size_t Settings::*limit = &Settings::manifolds;
  static constexpr std::uint64_t seeds_apart = 5000;
  static constexpr auto& rivals = manifold_rivals<T>;

  using PairQuestion<N, T>::PairQuestion;
  static std::vector<Subject> subjects() { return pair_subjects(" by manifold"); }

  static Judged<Truth> judge(const Case& pair, Figures& figures) {
    const auto& [a, b] = pair;
    const Truth truth = test::exact_verdict<N, T>(a, b);
    const test::ManifoldErrors errors = test::manifold_errors<N, T>(a, b, truth);
    figures.share("meet", truth.relation != Relation::apart);
    figures.keep("depth", errors.depth, By::space);
    figures.keep("points", errors.points);
    return {truth, errors.judgement};
  }

  static std::string row(const Case& pair, const Truth& truth) {
    return test::regression_row<N, T>("manifold", pair.first, pair.second, test::number_text(truth.gap));
  }

  static ContactPatch own_answer(const Asked& asked) {
    const Manifold<N, T> found = test::manifold_of<N, T>(asked.pair.first, asked.pair.second);
    ContactPatch patch;
    for (const ManifoldPoint<N, T>& point : found.contacts())
      patch.push_back({Vec<3, double>(point.point), static_cast<double>(point.depth)});
    return patch;
  }

  static void mark(const Asked& asked, const ContactPatch& patch, Figures& figures) {
    const bool is_measured = asked.is_clear() && asked.overlaps() && !patch.empty();
    const double points = is_measured ? error_of_points(asked, patch) : 0;
    asked.count_verdict(!patch.empty(), figures);
    figures.count("measured", is_measured);
    figures.count("points_off", !(points <= asked.given(fair_share)));
    figures.share("points", is_measured ? patch.size() : 0, is_measured);
    asked.count_error(is_measured ? error_of(asked, patch) : 0, figures);
  }

 private:
  /// Of the deepest point.
  static double error_of(const Asked& asked, const ContactPatch& patch) {
    double deepest = 0;
    for (const PatchPoint& point : patch) deepest = std::max(deepest, point.depth);
    return std::isfinite(deepest) ? std::fabs(deepest + asked.truth.gap) : std::numeric_limits<double>::infinity();
  }

  static double error_of_points(const Asked& asked, const ContactPatch& patch) {
    double farthest = 0;
    for (const PatchPoint& point : patch)
      farthest = std::max({farthest, beside(point, asked.pair.first), beside(point, asked.pair.second)});
    return farthest;
  }

  /// How much farther a point is from a shape than it may be: a point of one shape is as far from the other as it is
  /// deep.
  static double beside(const PatchPoint& point, const Any& shape) {
    const Vec<N, T> place(point.place);
    if (!is_finite(place) || !std::isfinite(point.depth)) return std::numeric_limits<double>::infinity();
    const double gap = test::exact_verdict<N, T>(Any(place), shape, test::Measure::distance).gap;
    return gap - std::max(0.0, point.depth);
  }
};

}  // namespace graze::exam
