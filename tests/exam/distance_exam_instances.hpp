// SPDX-License-Identifier: MIT
// The definition of examine_distances, for the files that instantiate it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include <graze/math/vec.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "exam/distance_exam.hpp"
#include "exam/distance_rival.hpp"
#include "exam/rigid.hpp"
#include "exam/stopwatch.hpp"
#include "query/case_maker.hpp"
#include "query/case_variations.hpp"
#include "query/distance_judgement.hpp"
#include "query/proximities.hpp"
#include "query/regressions.hpp"

namespace graze::exam {

template <Dim N, class T>
class DistanceExam {
 public:
  using Any = AnyShape<N, T>;
  using Pair = test::AnyPair<N, T>;

  DistanceExam(std::size_t a, std::size_t b, RegressionLog& regressions) : regressions_(regressions) {
    tally_.space = space_name<N, T>();
    tally_.pair = pair_name(a, b);
  }

  /// Puts a case to graze, and returns the truth.
  test::ExactVerdict put(const Pair& pair) {
    const auto& [a, b] = pair;
    const test::ExactVerdict truth = test::exact_verdict<N, T>(a, b);
    const test::DistanceErrors errors = test::distance_errors<N, T>(a, b, truth);
    ++tally_.cases;
    if (truth.relation == Relation::apart) ++tally_.hits;
    if (errors.judgement == test::Judgement::outside_range) ++tally_.outside;
    if (errors.judgement == test::Judgement::wrong) {
      ++tally_.wrong;
      regressions_.add_failure(
          test::regression_row<N, T>("distance", a, b, test::number_text(std::max(0.0, truth.gap))));
    }
    tally_.worst = std::max(tally_.worst, errors.distance);
    if (truth.relation == Relation::apart) tally_.worst_second = std::max(tally_.worst_second, errors.points);
    return truth;
  }

  /// The same for the rivals, in space.
  void put_to_rivals(const Pair& pair, const test::ExactVerdict& truth) {
    if constexpr (N == 3) {
      const auto& [a, b] = pair;
      if (!is_rigid<T>(a) || !is_rigid<T>(b)) return;
      if (truth.is_nearly_parallel || !(truth.own_size < 1e100) || std::isinf(truth.gap)) return;
      bool is_asked = false;
      for (const DistanceRival<T>& rival : distance_rivals<T>()) {
        const std::optional<Separation> answer = rival.answer(a, b);
        if (!answer) continue;
        is_asked = true;
        count(tally_.rivals[rival.name], pair, truth, *answer);
      }
      if (!is_asked) return;
      const Proximity<N, T> own = test::closest_points_of<N, T>(a, b);
      count(tally_.rivals["graze"], pair, truth,
            {own.relation != Relation::apart, static_cast<double>(own.distance), Vec<3, double>(own.point_a),
             Vec<3, double>(own.point_b)});
    }
  }

  const MeasuredPair& tally() const { return tally_; }

 private:
  static double off(const Vec<N, double>& point, const Any& shape) {
    if (!is_finite(Vec<N, T>(point))) return std::numeric_limits<double>::infinity();
    return std::max(0.0, test::exact_verdict<N, T>(Any(Vec<N, T>(point)), shape, test::Measure::distance).gap);
  }

  /// How far the points are from their shapes, or their own distance from the true one, whichever is more.
  static double error_of_points(const Pair& pair, double gap, const Separation& answer) {
    const double between = length(answer.point_b - answer.point_a);
    return std::max({off(answer.point_a, pair.first), off(answer.point_b, pair.second), std::fabs(between - gap)});
  }

  void count(MeasureTally& tally, const Pair& pair, const test::ExactVerdict& truth, const Separation& answer) {
    ++tally.cases;
    const double size = std::max(truth.own_size, truth.largest);
    if (truth.relation == Relation::touching || std::fabs(truth.gap) <= fair_gap<T> * size) return;
    const bool is_apart = truth.relation == Relation::apart;
    if (answer.meets == is_apart) ++(answer.meets ? tally.false_yes : tally.false_no);
    if (answer.meets || !is_apart) return;
    ++tally.measured;
    const double error = std::isfinite(answer.distance) ? std::fabs(answer.distance - truth.gap)
                                                        : std::numeric_limits<double>::infinity();
    const double given = fair_gap<T> * size;
    const double own_size = truth.own_size > 0 ? truth.own_size : truth.largest;
    if (!(error <= fair_share * own_size + given)) ++tally.off;
    if (!(error <= fine_share * own_size + given)) ++tally.slightly_off;
    if (!(error_of_points(pair, truth.gap, answer) <= fair_share * own_size + given)) ++tally.points_off;
    tally.worst = std::max(tally.worst, error / size);
  }

  RegressionLog& regressions_;
  MeasuredPair tally_;
};

/// A case that was made with care is worth as many cheap relatives, for graze alone.
inline constexpr std::size_t distance_variations_of_each = 1;

template <Dim N, class T>
MeasuredPair examine_distances(std::size_t a, std::size_t b, const Settings& settings, RegressionLog& regressions) {
  constexpr std::uint64_t seeds_apart = 4000;  // not those of the verdicts
  const std::uint64_t seed = settings.seed * seeds_apart + a * shape_type_names.size() + b;
  DistanceExam<N, T> exam(a, b, regressions);
  test::CaseMaker<N, T> maker(a, b, seed);
  test::CaseVariations<N, T> variations(seed);
  const Stopwatch watch;
  for (std::size_t turn = 0; exam.tally().cases < settings.distances && watch.is_within(settings.seconds); ++turn) {
    const auto kind = static_cast<test::CaseKind>(turn % test::case_kind_count);
    for (const test::AnyPair<N, T>& pair : maker.make(kind)) {
      exam.put_to_rivals(pair, exam.put(pair));
      for (std::size_t i = 0; i < distance_variations_of_each; ++i) exam.put(variations.vary(pair));
    }
  }
  return exam.tally();
}

}  // namespace graze::exam
