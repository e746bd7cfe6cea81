// SPDX-License-Identifier: MIT
// Which faces may be on the way from a point along x. Include winding_number.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <graze/math/lanes/sixteen.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/ray/triangle_lanes.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/parts/box_block.hpp>
#include <graze/shape/parts/triangle_block.hpp>

namespace graze::detail {

template <Dim N, class T>
class MayBeOnWayInside;

/// For `visit_parts`: whether a box meets the ray from a point along x; in 2D, whether it contains the point.
template <Dim N, class T>
struct MayBeOnWay {
  bool operator()(const Aabb<N, T>& box) const { return boxes_overlap(box, way()); }
  /// The same for boxes in this one, and for faces in it, each up to `error` away from where the point sees it.
  MayBeOnWayInside<N, T> inside(const Aabb<N, T>& box, double error) const {
    return MayBeOnWayInside<N, T>(*this, box, error);
  }

  Aabb<N, T> way() const {
    Aabb<N, T> box{point, point};
    if constexpr (N == 3) box.max[0] = std::numeric_limits<T>::infinity();
    return box;
  }

  Vec<N, T> point;
};

template <Dim N, class T>
class MayBeOnWayInside {
 public:
  MayBeOnWayInside(const MayBeOnWay<N, T>& on_way, [[maybe_unused]] const Aabb<N, T>& around,
                   [[maybe_unused]] double error)
      : way_(on_way.way()) {
#ifdef GRAZE_HAS_LANES
    if constexpr (N == 3) {
      double size = 0;
      for (Dim i = 0; i < N; ++i) {
        const double at = static_cast<double>(on_way.point[i]);
        size += std::max(std::fabs(static_cast<double>(around.min[i]) - at),
                         std::fabs(static_cast<double>(around.max[i]) - at));
      }
      line_ = lane_line<T>(wide<N, T>(on_way.point), Vec<N, double>(1, 0, 0), size, error);
    }
#endif
  }

  bool operator()(const Aabb<N, T>& box) const { return boxes_overlap(box, way_); }
#ifdef GRAZE_HAS_LANES
  LaneMask lanes(const BoxBlock<N, T>& block) const { return overlapping_lanes(block, way_); }
  LaneMask lanes(const TriangleBlock<N, T>& triangles) const requires(N == 3) { return met_lanes(triangles, line_); }
#endif

 private:
  Aabb<N, T> way_;
#ifdef GRAZE_HAS_LANES
  LaneLine<T> line_;  ///< In 3D.
#endif
};

}  // namespace graze::detail
