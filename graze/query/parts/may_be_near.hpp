// SPDX-License-Identifier: MIT
// Which parts may be nearer to a point than a distance. Include contains.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest/triangle_lanes.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/parts/box_block.hpp>

namespace graze::detail {

/// No part in the box contains a point that is farther from the box than this; if the point is farther, its distance
/// from any part exceeds the difference.
template <Dim N, class T>
double forgiven_outside(const Aabb<N, T>& box, const Vec<N, T>& point) {
  const double largest = static_cast<double>(std::max(max_abs(point), size_of_box(box)));
  return (tolerance::surface<T> + tolerance::box_slack) * largest;
}

template <Dim N, class T>
class MayBeNearInside;

/// For `visit_parts`: whether a part may be nearer to a point than a distance, or hold it.
template <Dim N, class T>
struct MayBeNear {
  bool operator()(const Aabb<N, T>& box) const {
    return !is_farther(distance_squared(point, box), distance + forgiven_outside(box, point));
  }
  /// The same for boxes in this one, with keys, and for faces in it, each up to `error` away from where the point sees
  /// it. It refers to this object.
  MayBeNearInside<N, T> inside(const Aabb<N, T>& box, double error) const {
    return MayBeNearInside<N, T>(*this, box, error);
  }
  /// In one function, as may_part_touch is.
  [[gnu::flatten]] bool operator()(const Part<N, T>& part) const { return (*this)(part.box) || is_hidden_by_box(part); }

  Vec<N, T> point;
  double distance = 0;
};

template <Dim N, class T>
class MayBeNearInside {
 public:
  MayBeNearInside(const MayBeNear<N, T>& may_be_near, const Aabb<N, T>& box, [[maybe_unused]] double error)
      : may_be_near_(may_be_near), forgiven_(forgiven_outside(box, may_be_near.point)) {
#ifdef GRAZE_HAS_LANES
    if constexpr (N == 3) lane_point_ = lane_point(may_be_near.point, box, error);
#endif
  }

  double key(const Aabb<N, T>& box) const { return distance_squared(may_be_near_.point, box); }
  bool admits(double key) const { return !(key > static_cast<double>(most())); }
  bool operator()(const Aabb<N, T>& box) const { return admits(key(box)); }
#ifdef GRAZE_HAS_LANES
  LaneMask lanes(const BoxBlock<N, T>& block, Row<T>& keys) const {
    return squared_distances(block, Aabb<N, T>{may_be_near_.point, may_be_near_.point}, most(), keys);
  }
  LaneMask lanes(const TriangleBlock<N, T>& triangles, Row<T>& keys) const requires(N == 3) {
    SquaredDistances<T> squared;
    return lanes(triangles, keys, squared);
  }

 protected:
  /// Also writes squared distances of the faces.
  LaneMask lanes(const TriangleBlock<N, T>& triangles, Row<T>& keys, SquaredDistances<T>& squared) const
      requires(N == 3) {
    const LaneMask result = find_squared_distances(triangles, lane_point_, most(), squared);
    keys = squared.least;
    return result;
  }
#endif

  /// The squared distance that still matters.
  T most() const {
    if (may_be_near_.distance != distance_) {
      distance_ = may_be_near_.distance;
      most_ = most_squared<T>(distance_ + forgiven_);
    }
    return most_;
  }

 private:
#ifdef GRAZE_HAS_LANES
  LanePoint<T> lane_point_;  // in 3D
#endif
  const MayBeNear<N, T>& may_be_near_;
  double forgiven_;
  mutable double distance_ = -1;  // to which most_ belongs
  mutable T most_ = 0;
};

template <Dim N, class T>
class MayBeNearestFaceInside;

/// For `visit_faces`: what may be the nearest face. Faces that were tested bring down the distance.
template <Dim N, class T>
struct MayBeNearestFace {
  MayBeNearestFaceInside<N, T> inside(const Aabb<N, T>& box, double error) const {
    return MayBeNearestFaceInside<N, T>(near, box, error);
  }

  MayBeNear<N, T>& near;
};

template <Dim N, class T>
class MayBeNearestFaceInside : public MayBeNearInside<N, T> {
 public:
  MayBeNearestFaceInside(MayBeNear<N, T>& near, const Aabb<N, T>& box, double error)
      : MayBeNearInside<N, T>(near, box, error), near_(near) {}

#ifdef GRAZE_HAS_LANES
  using MayBeNearInside<N, T>::lanes;
  LaneMask lanes(const TriangleBlock<N, T>& triangles, Row<T>& keys) const requires(N == 3) {
    SquaredDistances<T> squared;
    const LaneMask result = MayBeNearInside<N, T>::lanes(triangles, keys, squared);
    const T most = least_of(squared.most);
    if (most < std::min(this->most(), std::numeric_limits<T>::max()))
      near_.distance = std::min(near_.distance, std::sqrt(static_cast<double>(most)));
    return result;
  }
#endif

 private:
  MayBeNear<N, T>& near_;
};

}  // namespace graze::detail
