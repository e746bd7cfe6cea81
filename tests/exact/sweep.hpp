// SPDX-License-Identifier: MIT
// The region swept by a moving shape, exactly: how far the shape is from another at a time, and the maximum depth until
// then. The region swept by a convex shape is convex, so the first contact needs no search: a time is too early if the
// shape is apart then, and too late if the swept region overlaps.
#pragma once

#include <optional>
#include <type_traits>
#include <variant>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact/kinds.hpp"
#include "exact/numbers.hpp"
#include "exact/parting.hpp"
#include "exact/solid.hpp"
#include "exact/unbounded.hpp"
#include "exact/verdict.hpp"
#include "exact/verdict_instances.hpp"

namespace graze::test {

/// `solid` moved along `way`.
template <Dim N>
Solid<N> moved_solid(Solid<N> solid, const RationalVec<N>& way) {
  for (RationalVec<N>& corner : solid.corners) corner = corner + way;
  return solid;
}

/// The region swept by `solid` along `way`.
template <Dim N>
Solid<N> swept_solid(Solid<N> solid, const RationalVec<N>& way) {
  const Solid<N> there = moved_solid<N>(solid, way);
  solid.corners.insert(solid.corners.end(), there.corners.begin(), there.corners.end());
  solid.edges.push_back(way);
  return solid;
}

/// The verdict on a solid and a shape that is bounded and convex, or a plane or half-space; none for others.
template <Dim N, class T>
std::optional<ExactVerdict> solid_verdict_with(const Solid<N>& solid_a, const AnyShape<N, T>& b) {
  return std::visit(
      [&solid_a](const auto& held) -> std::optional<ExactVerdict> {
        using S = std::decay_t<decltype(held)>;
        if constexpr (is_plane_or_half_space<S>) {
          return level_verdict(level(held), solid_a);
        } else if constexpr (is_bounded_and_convex<S>) {
          return solid_verdict(solid_a, solid(held), Measure::depth);
        } else {
          return std::nullopt;
        }
      },
      b);
}

/// The progress of a moving shape.
struct ExactPassage {
  ExactVerdict there;   ///< At the time.
  ExactVerdict so_far;  ///< For the region swept until then.
};

/// a has moved by motion * t. None unless a is bounded and convex, and so is b, or b is a plane or half-space.
template <Dim N, class T>
std::optional<ExactPassage> exact_passage(const AnyShape<N, T>& a, const Vec<N, T>& motion, double t,
                                          const AnyShape<N, T>& b) {
  const std::optional<Solid<N>> start = bounded_solid<N, T>(a);
  if (!start) return std::nullopt;
  const RationalVec<N> way = exact(motion) * exact(t);
  const std::optional<ExactVerdict> there = solid_verdict_with<N, T>(moved_solid<N>(*start, way), b);
  const std::optional<ExactVerdict> so_far = solid_verdict_with<N, T>(swept_solid<N>(*start, way), b);
  if (!there || !so_far) return std::nullopt;
  return ExactPassage{*there, *so_far};
}

}  // namespace graze::test
