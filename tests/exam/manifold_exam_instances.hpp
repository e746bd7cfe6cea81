// SPDX-License-Identifier: MIT
// The definition of examine_manifolds, for the files that instantiate it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "exam/manifold_exam.hpp"
#include "exam/manifold_rival.hpp"
#include "exam/rigid.hpp"
#include "exam/stopwatch.hpp"
#include "query/case_maker.hpp"
#include "query/case_variations.hpp"
#include "query/manifold_judgement.hpp"
#include "query/manifolds.hpp"
#include "query/regressions.hpp"

namespace graze::exam {

template <Dim N, class T>
class ManifoldExam {
 public:
  using Any = AnyShape<N, T>;
  using Pair = test::AnyPair<N, T>;

  ManifoldExam(std::size_t a, std::size_t b, RegressionLog& regressions) : regressions_(regressions) {
    tally_.space = space_name<N, T>();
    tally_.pair = pair_name(a, b);
  }

  /// Puts a case to graze, and returns the truth.
  test::ExactVerdict put(const Pair& pair) {
    const auto& [a, b] = pair;
    const test::ExactVerdict truth = test::exact_verdict<N, T>(a, b);
    const test::ManifoldErrors errors = test::manifold_errors<N, T>(a, b, truth);
    ++tally_.cases;
    if (truth.relation != Relation::apart) ++tally_.hits;
    if (errors.judgement == test::Judgement::outside_range) ++tally_.outside;
    if (errors.judgement == test::Judgement::wrong) {
      ++tally_.wrong;
      regressions_.add_failure(test::regression_row<N, T>("manifold", a, b, test::number_text(truth.gap)));
    }
    tally_.worst = std::max(tally_.worst, errors.depth);
    tally_.worst_second = std::max(tally_.worst_second, errors.points);
    return truth;
  }

  /// The same for the rivals, in space.
  void put_to_rivals(const Pair& pair, const test::ExactVerdict& truth) {
    if constexpr (N == 3) {
      const auto& [a, b] = pair;
      if (!is_rigid<T>(a) || !is_rigid<T>(b)) return;
      if (truth.is_nearly_parallel || !(truth.own_size < 1e100) || std::isinf(truth.gap)) return;
      bool is_asked = false;
      for (const ManifoldRival<T>& rival : manifold_rivals<T>()) {
        const std::optional<ContactPatch> answer = rival.answer(a, b);
        if (!answer) continue;
        is_asked = true;
        count(tally_.rivals[rival.name], pair, truth, *answer);
      }
      if (is_asked) count(tally_.rivals["graze"], pair, truth, own_patch(a, b));
    }
  }

  const MeasuredPair& tally() const { return tally_; }

 private:
  static ContactPatch own_patch(const Any& a, const Any& b) {
    const Manifold<N, T> found = test::manifold_of<N, T>(a, b);
    ContactPatch patch;
    for (const ManifoldPoint<N, T>& point : found.contacts())
      patch.push_back({Vec<3, double>(point.point), static_cast<double>(point.depth)});
    return patch;
  }

  /// How much farther a place is from a shape than it may be: a point of one shape is as far from the other as it is
  /// deep.
  static double beside(const PatchPoint& point, const Any& shape) {
    const Vec<N, T> place(point.place);
    if (!is_finite(place) || !std::isfinite(point.depth)) return std::numeric_limits<double>::infinity();
    const double gap = test::exact_verdict<N, T>(Any(place), shape, test::Measure::distance).gap;
    return gap - std::max(0.0, point.depth);
  }

  void count(MeasureTally& tally, const Pair& pair, const test::ExactVerdict& truth, const ContactPatch& patch) {
    ++tally.cases;
    const double size = std::max(truth.own_size, truth.largest);
    if (truth.relation == Relation::touching || std::fabs(truth.gap) <= fair_gap<T> * size) return;
    const bool is_deep = truth.relation == Relation::overlapping;
    if (patch.empty() == is_deep) ++(is_deep ? tally.false_no : tally.false_yes);
    if (patch.empty() || !is_deep) return;
    ++tally.measured;
    tally.points += patch.size();
    double deepest = 0;
    double farthest = 0;
    for (const PatchPoint& point : patch) {
      deepest = std::max(deepest, point.depth);
      farthest = std::max({farthest, beside(point, pair.first), beside(point, pair.second)});
    }
    const double own_size = truth.own_size > 0 ? truth.own_size : truth.largest;  // levels have none
    const double given = fair_share * own_size + fair_gap<T> * size;
    const double error =
        std::isfinite(deepest) ? std::fabs(deepest + truth.gap) : std::numeric_limits<double>::infinity();
    if (!(error <= given)) ++tally.off;
    if (!(farthest <= given)) ++tally.points_off;
    tally.worst = std::max(tally.worst, error / size);
  }

  RegressionLog& regressions_;
  MeasuredPair tally_;
};

/// A case that was made with care is worth as many cheap relatives, for graze alone.
inline constexpr std::size_t manifold_variations_of_each = 1;

template <Dim N, class T>
MeasuredPair examine_manifolds(std::size_t a, std::size_t b, const Settings& settings, RegressionLog& regressions) {
  constexpr std::uint64_t seeds_apart = 5000;  // not those of the verdicts
  const std::uint64_t seed = settings.seed * seeds_apart + a * shape_type_names.size() + b;
  ManifoldExam<N, T> exam(a, b, regressions);
  test::CaseMaker<N, T> maker(a, b, seed);
  test::CaseVariations<N, T> variations(seed);
  const Stopwatch watch;
  for (std::size_t turn = 0; exam.tally().cases < settings.manifolds && watch.is_within(settings.seconds); ++turn) {
    const auto kind = static_cast<test::CaseKind>(turn % test::case_kind_count);
    for (const test::AnyPair<N, T>& pair : maker.make(kind)) {
      exam.put_to_rivals(pair, exam.put(pair));
      for (std::size_t i = 0; i < manifold_variations_of_each; ++i) exam.put(variations.vary(pair));
    }
  }
  return exam.tally();
}

}  // namespace graze::exam
