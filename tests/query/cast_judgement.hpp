// SPDX-License-Identifier: MIT
// Finds errors of shape_cast(a, motion, b): compares the time of impact with the oracle's answers for the shapes at
// that time and for the region swept by a, according to the contract of shape_cast.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/status.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact.hpp"
#include "exact/sweep.hpp"
#include "exact/verdict.hpp"
#include "query/pairs.hpp"
#include "query/regressions.hpp"
#include "query/shape_casts.hpp"
#include "query/verdict_band.hpp"

namespace graze::test {

/// A shape, its motion, and an obstacle.
template <Dim N, class T>
struct Cast {
  AnyShape<N, T> a;
  Vec<N, T> motion;
  AnyShape<N, T> b;
};

/// The errors of one answer, in epsilon of double times the size that shape_cast.hpp names.
struct CastErrors {
  Judgement judgement = Judgement::right;  ///< Never `within_band`.
  std::string_view fault;                  ///< The first fault; empty if there is none.
  double gap = 0;                          ///< The gap at the impact, or the previous depth of a in b.
  double claimed = 0;                      ///< The error reported with the impact.
};

/// "A few epsilon" of sums of up to three coordinates each, if GJK reports convergence; smaller contacts may be missed.
inline constexpr double most_claimed_of_casts = 4096;
inline constexpr double most_overlooked = 64;

template <Dim N, class T>
class CastJudge {
 public:
  /// `start` is the verdict before anything moves, with gap and sizes. `exact_passage` must support the cast.
  CastJudge(const Cast<N, T>& cast, const ExactVerdict& start)
      : cast_(cast), start_(start), size_(size_of_cast(cast, start)) {}

  CastErrors run() {
    const bool underflows = start_.relation == Relation::apart && start_.gap < least_size;
    if (!(size_ > least_size) || start_.is_nearly_parallel || underflows) {
      errors_.judgement = Judgement::outside_range;
      return errors_;
    }
    const std::optional<Impact<N, T>> impact = impact_of<N, T>(cast_.a, cast_.motion, cast_.b);
    const std::optional<detail::CastHit<N>> cast_hit = cast_hit_of<N, T>(cast_.a, cast_.motion, cast_.b);
    expect(impact.has_value() == cast_hit.has_value(), "the rounded answer does not match");
    if (!impact || !cast_hit) {
      judge_miss();
    } else if (start_.relation != Relation::apart) {
      expect(impact->t == T(0), "shapes that intersect at the start must have t = 0");
    } else {
      judge_hit(*cast_hit);
      expect(static_cast<double>(impact->t) <= cast_hit->t, "the time is not rounded down");
    }
    return errors_;
  }

  /// The largest coordinate that the contract names, including the motion.
  static double size_of_cast(const Cast<N, T>& cast, const ExactVerdict& start) {
    const double size = documented_size(start.own_size, start.largest, cast.a.index(), cast.b.index());
    return std::max(size, start.own_size) + static_cast<double>(sum_abs(cast.motion));
  }

 private:
  void expect(bool holds, std::string_view fault) {
    if (holds || !errors_.fault.empty()) return;
    errors_.judgement = Judgement::wrong;
    errors_.fault = fault;
  }

  void judge_miss() {
    const ExactPassage passage = *exact_passage<N, T>(cast_.a, cast_.motion, 1.0, cast_.b);
    const double depth = -passage.so_far.gap;
    expect(depth <= most_overlooked * tolerance::epsilon * size_, "the shapes pass through each other");
  }

  void judge_hit(const detail::CastHit<N>& cast_hit) {
    const ExactPassage passage = *exact_passage<N, T>(cast_.a, cast_.motion, cast_hit.t, cast_.b);
    const double unit = tolerance::epsilon * size_;
    expect(passage.there.gap <= cast_hit.error, "the time is too early, or there is no hit");
    expect(-passage.so_far.gap <= cast_hit.error, "the time is too late");
    expect(cast_hit.error <= most_claimed_of_casts * unit || cast_hit.status == Status::best_bound,
           "the reported error is too large");
    const bool meets_at_start = relation_of<N, T>(cast_.a, cast_.b) != Relation::apart;  // up to its band
    expect(std::fabs(dot(cast_hit.normal, cast_hit.normal) - 1) <= 16 * tolerance::epsilon || meets_at_start,
           "the normal is not a unit vector");
    errors_.gap = std::max(passage.there.gap, -passage.so_far.gap) / unit;
    errors_.claimed = cast_hit.error / unit;
  }

  const Cast<N, T>& cast_;
  const ExactVerdict& start_;
  double size_;
  CastErrors errors_;
};

/// `start` is the verdict before anything moves, with gap and sizes.
template <Dim N, class T>
CastErrors cast_errors(const Cast<N, T>& cast, const ExactVerdict& start) {
  return CastJudge<N, T>(cast, start).run();
}

/// A row of regressions.hpp: the first shape is followed by the word `by` and its motion.
template <Dim N, class T>
std::string cast_row(const Cast<N, T>& cast, std::string_view expected) {
  std::string text = "shape_cast," + space_text<N, T>() + "," + shape_text<N, T>(cast.a) + " by";
  for (Dim i = 0; i < N; ++i) text += " " + number_text(cast.motion[i]);
  return text + "," + shape_text<N, T>(cast.b) + "," + std::string(expected);
}

template <Dim N, class T>
Cast<N, T> cast_from(const Regression& row) {
  std::istringstream words(row.a);
  Cast<N, T> cast{read_shape<N, T>(words), {}, shape_from<N, T>(row.b)};
  std::string by;
  words >> by;
  for (Dim i = 0; i < N; ++i) cast.motion[i] = read_number<T>(words);
  return cast;
}

}  // namespace graze::test
