// SPDX-License-Identifier: MIT
// Finds errors of time_of_impact(a, motion_a, b, motion_b): compares with the oracle's answers for both shapes at the
// impact and at many times before it, according to the contract of time_of_impact.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include <graze/math/motion.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/status.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact.hpp"
#include "exact/verdict.hpp"
#include "query/moving_gap.hpp"
#include "query/pairs.hpp"
#include "query/regressions.hpp"
#include "query/times_of_impact.hpp"
#include "query/verdict_band.hpp"

namespace graze::test {

/// The errors of one answer, in units of the target of time_of_impact.hpp: 2^-36 of the pair's size and motion.
struct ImpactErrors {
  Judgement judgement = Judgement::right;  ///< Never `within_band`.
  std::string_view fault;                  ///< The first fault; empty if there is none.
  bool hits = false;
  double t = 1;                ///< Of the impact, if there is one.
  bool is_unfinished = false;  ///< The steps ran out before.
  double gap = 0;              ///< The gap at the impact.
  double claimed = 0;          ///< The error reported with an impact, if it converged.
};

inline constexpr double impact_target = 0x1p-36;

template <Dim N, class T>
class ImpactJudge {
 public:
  explicit ImpactJudge(const Moving<N, T>& moving)
      : moving_(moving), size_(size_of_way(moving)), rounding_(rounding_of_way(moving)) {}

  ImpactErrors run() {
    constexpr double largest_size = 1e140;
    const ExactVerdict start = exact_verdict<N, T>(moving_.a, moving_.b, Measure::depth);
    const bool underflows = start.relation == Relation::apart && start.gap < least_size;
    if (!(size_ > least_size && size_ < largest_size) || start.is_nearly_parallel || underflows) {
      errors_.judgement = Judgement::outside_range;
      return errors_;
    }
    const std::optional<Impact<N, T>> impact = impact_of(moving_);
    errors_.hits = impact.has_value();
    if (impact) errors_.t = static_cast<double>(impact->t);
    // Other judges check whether they rightly intersect.
    if (relation_of<N, T>(moving_.a, moving_.b) != Relation::apart) {
      expect(impact && impact->t == T(0), "shapes that intersect at the start must have t = 0");
      return errors_;
    }
    const std::optional<detail::CastHit<N>> cast_hit = cast_hit_of(moving_);
    expect(impact.has_value() == cast_hit.has_value(), "the rounded answer does not match");
    judge_way(cast_hit ? cast_hit->t : 1.0);
    if (!impact || !cast_hit) return errors_;
    judge_hit(*cast_hit);
    expect(errors_.t <= cast_hit->t, "the time is not rounded down");
    return errors_;
  }

 private:
  void expect(bool holds, std::string_view fault) {
    if (holds || !errors_.fault.empty()) return;
    errors_.judgement = Judgement::wrong;
    errors_.fault = fault;
  }

  void judge_way(double end) {
    expect(least_gap(moving_, 0, end) >= -rounding_, "the shapes meet before");
    for (const double share : {0.99, 0.9999, 1.0}) {
      expect(gap_at(moving_, end * share) >= -rounding_, "the shapes meet shortly before");
    }
  }

  void judge_hit(const detail::CastHit<N>& cast_hit) {
    constexpr double most_promised = 64;  // a few epsilon of the largest coordinate, if that is more than the target
    const double gap = gap_at(moving_, cast_hit.t);
    const double unit = impact_target * size_;
    errors_.is_unfinished = cast_hit.status == Status::best_bound;
    expect(gap <= cast_hit.error + rounding_, "the gap exceeds the reported error");
    // Two nearly parallel rays may touch far from their origins.
    const bool are_rays = moving_.a.index() == ray_type && moving_.b.index() == ray_type;
    const double reached = are_rays ? impact_target * std::max(size_, max_abs(cast_hit.point)) : unit;
    expect(cast_hit.error <= most_promised * reached || errors_.is_unfinished, "the reported error is too large");
    expect(std::fabs(dot(cast_hit.normal, cast_hit.normal) - 1) <= 16 * tolerance::epsilon,
           "the normal is not a unit vector");
    if (errors_.is_unfinished) return;
    errors_.gap = std::max(0.0, gap) / unit;
    errors_.claimed = cast_hit.error / unit;
  }

  const Moving<N, T>& moving_;
  double size_;
  double rounding_;
  ImpactErrors errors_;
};

template <Dim N, class T>
ImpactErrors impact_errors(const Moving<N, T>& moving) {
  return ImpactJudge<N, T>(moving).run();
}

// ---- Rows of regressions.hpp: each shape is followed by the word `by`, its translation, its rotation and the center
// of that.

template <Dim N, class T, class Take>
void for_each_number_of(Motion<N, T>& motion, const Take& take) {
  for (Dim i = 0; i < N; ++i) take(motion.linear[i]);
  if constexpr (N == 2) {
    take(motion.angular);
  } else {
    for (Dim i = 0; i < N; ++i) take(motion.angular[i]);
  }
  for (Dim i = 0; i < N; ++i) take(motion.center[i]);
}

template <Dim N, class T>
std::string motion_text(Motion<N, T> motion) {
  std::string text = " by";
  for_each_number_of<N, T>(motion, [&text](const T& x) { text += " " + number_text(x); });
  return text;
}

/// `expected`: "touch" or "miss".
template <Dim N, class T>
std::string impact_row(const Moving<N, T>& moving, std::string_view expected) {
  return "time_of_impact," + space_text<N, T>() + "," + shape_text<N, T>(moving.a) + motion_text(moving.motion_a) +
         "," + shape_text<N, T>(moving.b) + motion_text(moving.motion_b) + "," + std::string(expected);
}

template <Dim N, class T>
Moving<N, T> moving_from(const Regression& row) {
  Moving<N, T> moving;
  const auto read = [](const std::string& text, AnyShape<N, T>& shape, Motion<N, T>& motion) {
    std::istringstream words(text);
    shape = read_shape<N, T>(words);
    std::string by;
    words >> by;
    for_each_number_of<N, T>(motion, [&words](T& x) { x = read_number<T>(words); });
  };
  read(row.a, moving.a, moving.motion_a);
  read(row.b, moving.b, moving.motion_b);
  return moving;
}

}  // namespace graze::test
