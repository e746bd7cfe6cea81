// SPDX-License-Identifier: MIT
// closest_points(a, b) and distance(a, b).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <graze/query/proximity.hpp>

#include "exact.hpp"
#include "exam/pair_question.hpp"
#include "query/distance_judgement.hpp"
#include "query/proximities.hpp"
#include "query/regressions.hpp"

namespace graze::exam {

template <Dim N, class T>
class DistanceQuestion : public PairQuestion<N, T> {
 public:
  using Any = AnyShape<N, T>;
  using Case = test::AnyPair<N, T>;
  using Truth = test::ExactVerdict;
  using Asked = AskedPair<N, T>;
  static constexpr std::string_view name = "distance";
  static constexpr std::size_t Settings::*limit = &Settings::distances;
  static constexpr std::uint64_t seeds_apart = 4000;
  static constexpr auto& rivals = distance_rivals<T>;

  using PairQuestion<N, T>::PairQuestion;
  static std::vector<Subject> subjects() { return pair_subjects(" at a distance"); }

  static Judged<Truth> judge(const Case& pair, Figures& figures) {
    const auto& [a, b] = pair;
    const Truth truth = test::exact_verdict<N, T>(a, b);
    const test::DistanceErrors errors = test::distance_errors<N, T>(a, b, truth);
    const bool is_apart = truth.relation == Relation::apart;
    figures.share("apart", is_apart);
    figures.keep("distance", errors.distance, By::space);
    figures.keep("points", is_apart ? errors.points : 0);
    return {truth, errors.judgement};
  }

  static std::string row(const Case& pair, const Truth& truth) {
    return test::regression_row<N, T>("distance", pair.first, pair.second, test::number_text(std::max(0.0, truth.gap)));
  }

  static Separation own_answer(const Asked& asked) {
    const Proximity<N, T> own = test::closest_points_of<N, T>(asked.pair.first, asked.pair.second);
    return {own.relation != Relation::apart, static_cast<double>(own.distance), Vec<3, double>(own.point_a),
            Vec<3, double>(own.point_b)};
  }

  static void mark(const Asked& asked, const Separation& answer, Figures& figures) {
    const bool is_measured = asked.is_clear() && !asked.overlaps() && !answer.meets;
    const double error = is_measured ? error_of(asked.truth.gap, answer) : 0;
    const double points = is_measured ? error_of_points(asked, answer) : 0;
    asked.count_verdict(answer.meets, figures);
    figures.count("measured", is_measured);
    figures.count("slightly_off", !(error <= asked.given(fine_share)));
    figures.count("points_off", !(points <= asked.given(fair_share)));
    asked.count_error(error, figures);
  }

 private:
  static double error_of(double gap, const Separation& answer) {
    return std::isfinite(answer.distance) ? std::fabs(answer.distance - gap) : std::numeric_limits<double>::infinity();
  }

  static double off(const Vec<N, double>& point, const Any& shape) {
    if (!is_finite(Vec<N, T>(point))) return std::numeric_limits<double>::infinity();
    return std::max(0.0, test::exact_verdict<N, T>(Any(Vec<N, T>(point)), shape, test::Measure::distance).gap);
  }

  /// How far the points are from their shapes, or how far their distance is from the true one, whichever is more.
  static double error_of_points(const Asked& asked, const Separation& answer) {
    const double between = length(answer.point_b - answer.point_a);
    return std::max({off(answer.point_a, asked.pair.first), off(answer.point_b, asked.pair.second),
                     std::fabs(between - asked.truth.gap)});
  }
};

}  // namespace graze::exam
