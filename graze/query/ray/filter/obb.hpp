// SPDX-License-Identifier: MIT
// The first filter of a ray and an oriented 3D box, four numbers at a time. Include ray_cast.hpp.
#pragma once

#include <cmath>
#include <optional>

#include <graze/math/lanes/lanes.hpp>
#include <graze/math/lanes/paired.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/ray/filter/slab.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/ray.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// An oriented box and a ray as lanes: the box's center relative to the ray's origin, its axes as rows, so that lane i
/// of a sum of rows belongs to axis i.
struct RayAtObb {
  LaneMatrix rows;
  Lanes half;
  Lanes center;
  Lanes direction;
};

[[gnu::always_inline]] inline RayAtObb seen_by(const Ray<3, float>& ray, const Obb<3, float>& box) {
  static_assert(sizeof(box) == 15 * sizeof(float) && sizeof(ray) == 6 * sizeof(float));
  const Lanes third = arranged<1, 2, 3>(four_of(box, 11));
  return {transposed({four_of(box, 6), four_of(box, 9), third}), four_of(box, 3), four_of(box, 0) - four_of(ray, 0),
          arranged<1, 2, 3>(four_of(ray, 2))};
}

[[gnu::always_inline]] inline RayAtObb seen_by(const Ray<3, double>& ray, const Obb<3, double>& box) {
  const auto& axes = box.axes;
  return {transposed({narrow(read_paired(axes[0])), narrow(read_paired(axes[1])), narrow(read_paired(axes[2]))}),
          narrow(read_paired(box.half_extents)), narrow(read_paired(box.center) - read_paired(ray.origin)),
          narrow(read_paired(ray.direction))};
}

/// Slabs in float, in the box's own axes. Axes are assumed to be orthonormal, which those of a valid box are up to
/// tolerance::orthonormal: that moves no point by more than the margin, and nor do errors of the slopes before the ray
/// has passed the box. If it hits, only the intersection with one face's plane is left, in double and with its true
/// normal, which is perpendicular to the other two axes.
template <class T>
class RayObbFilter {
 public:
  [[gnu::always_inline]] RayObbFilter(const Obb<3, T>& box, const Ray<3, T>& ray, T t_max) : box_(box), ray_(ray) {
    const RayAtObb seen = seen_by(ray, box);
    const Lanes center = combined(seen.rows, seen.center);
    slope_ = combined(seen.rows, seen.direction);
    const float slopes = sum_of_three(magnitude(slope_));
    // for smaller slopes nothing is left but rounding
    const bool is_moderate = (slopes > 0x1p-60F) & (slopes < 0x1p60F);
    if (!is_moderate) return;
    slabs_.cross(center - seen.half, center + seen.half, slope_, static_cast<float>(t_max),
                 tolerance::ray_orthonormality_error);
  }

  [[gnu::always_inline]] RayVerdict verdict() const { return slabs_.verdict(); }

  [[gnu::always_inline]] std::optional<RayHit<3, T>> hit() const {
    const LaneBits met = slabs_.is_side();
    const Dim i = met[0] != 0 ? 0 : met[1] != 0 ? 1 : 2;
    const float slope = met[0] != 0 ? slope_[0] : met[1] != 0 ? slope_[1] : slope_[2];
    const PairedVec across = cross(PairedVec(box_.axes[i == 2 ? 0 : i + 1]), PairedVec(box_.axes[i == 0 ? 2 : i - 1]));
    const PairedVec direction(ray_.direction);
    const PairedVec origin(ray_.origin);
    const double to_face = std::copysign(static_cast<double>(box_.half_extents[i]), -static_cast<double>(slope));
    const PairedVec face = PairedVec(box_.center) - origin + PairedVec(box_.axes[i]) * to_face;
    const double climb = dot(across, direction);
    const double t = dot(across, face) / climb;
    const PairedVec normal = across * (std::copysign(1.0, -climb) / std::sqrt(dot(across, across)));
    const double error = 2 * tolerance::rounding * static_cast<double>(slabs_.size());
    return RayHit<3, T>{static_cast<T>(t), rounded_vec<T>(direction * t + origin), rounded_vec<T>(normal),
                        Status::converged, error};
  }

 private:
  const Obb<3, T>& box_;
  const Ray<3, T>& ray_;
  Lanes slope_;
  RaySlabFilter slabs_;
};

template <class T>
[[gnu::always_inline]] inline RayObbFilter<T> quick_cast(const Obb<3, T>& box, const Ray<3, T>& ray, T t_max) {
  return {box, ray, t_max};
}

}  // namespace graze::detail

#endif
