// SPDX-License-Identifier: MIT
// Laws of every cast, with and without options. `Cases` is a CastCases.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <graze/math/tolerance.hpp>
#include <graze/query/impact.hpp>

#include "catalogue.hpp"
#include "query/cast_cases.hpp"
#include "query/ray_casts.hpp"

namespace graze::test {

template <class Cases>
using CastHitOf = std::optional<detail::CastHit<Cases::dimension>>;

/// At the impact the shapes are as near as the target, and before it they are not; without an impact never.
template <class Cases>
void check_gaps(const typename Cases::Case& drawn, double target, const CastHitOf<Cases>& found) {
  const double slack = Cases::place_error(drawn) + 32 * tolerance::epsilon * target;
  if (!found) {
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) RC_ASSERT(Cases::gap_at(drawn, t) - target >= -slack);
    return;
  }
  const double error = found->error + slack;
  const double over = Cases::gap_at(drawn, found->t) - target;
  RC_LOG() << "farther by " << over << ", allowed " << error << "\n";
  RC_ASSERT(over <= error);
  if (found->t == 0) return;
  RC_ASSERT(found->status == Status::best_bound ||
            found->error <= 4096 * tolerance::epsilon * (Cases::size(drawn) + target));
  RC_ASSERT(over >= -error);
  for (const double share : {0.25, 0.75, 0.999}) {
    RC_ASSERT(Cases::gap_at(drawn, found->t * share) - target >= -error);
  }
}

/// The point is on the second shape, and the target away from one of the first, along the normal. For slivers, GJK may
/// return a point beside them, see closest_points.hpp.
template <class Cases>
void check_point(const typename Cases::Case& drawn, double target, const CastHitOf<Cases>& found) {
  constexpr Dim N = Cases::dimension;
  using T = typename Cases::Number;
  if (!found || found->t == 0) return;
  const double slack = 4 * (found->error + Cases::place_error(drawn)) + 1e-9 * (Cases::size(drawn) + target);
  RC_LOG() << "point " << to_source<N, double>(AnyShape<N, double>(found->point)) << "\n";
  const Vec<N, double> on_a = found->point - found->normal * target - wide<N, T>(drawn.motion) * found->t;
  const double from_a = height_of<N, T>(drawn.a, on_a);
  const double from_b = height_of<N, T>(drawn.b, found->point);
  RC_LOG() << from_a << " and " << from_b << " off, allowed " << slack << "\n";
  RC_ASSERT(std::fabs(length(found->normal) - 1) <= 8 * tolerance::epsilon);
  RC_ASSERT(std::fabs(from_a) <= slack);
  RC_ASSERT(std::fabs(from_b) <= slack);
}

/// A compound is hit when its first part is, at the start by its deepest one. `cast` is that of a case.
template <class Cases, class Cast>
void check_first_part(const typename Cases::Case& drawn, const Cast& cast) {
  constexpr Dim N = Cases::dimension;
  using T = typename Cases::Number;
  auto second = drawn;
  second.b = *any_shape<N, T>();
  auto both = drawn;
  both.b = compound_of<N, T>({drawn.b, second.b});
  const CastHitOf<Cases> one = cast(drawn);
  const CastHitOf<Cases> two = cast(second);
  const CastHitOf<Cases> first = cast(both);
  RC_ASSERT(first.has_value() == (one || two));
  if (!first) return;
  for (const auto& found : {one, two, first}) {
    if (found && found->status == Status::best_bound) return;  // a bound may be better for a shorter motion
  }
  const double never = 2;
  RC_ASSERT(first->t == std::min(one ? one->t : never, two ? two->t : never));
  if (first->t > 0) return;
  RC_ASSERT(first->depth ==
            std::max(one && one->t == 0 ? one->depth : -HUGE_VAL, two && two->t == 0 ? two->depth : -HUGE_VAL));
}

}  // namespace graze::test
