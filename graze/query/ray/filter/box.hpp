// SPDX-License-Identifier: MIT
// The first filter of a ray and an axis-aligned 3D box, four numbers at a time. Include ray_cast.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <graze/math/lanes/lanes.hpp>
#include <graze/math/platform/bit_cast.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/ray/filter/slab.hpp>
#include <graze/query/ray/hit_lanes.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// Decides whether a ray hits by slabs in float; if it does, only the side that is met is calculated in double: so
/// point, t and normal are bit-identical to those of `ray_verdict_of`, and the error up to its rounding to float.
template <class T>
class RayBoxFilter;

template <>
class RayBoxFilter<float> {
 public:
  [[gnu::always_inline]] RayBoxFilter(const Aabb<3, float>& box, const Ray<3, float>& ray, float t_max)
      : box_(box), ray_(ray) {
    static_assert(sizeof(box) == 6 * sizeof(float) && sizeof(ray) == 6 * sizeof(float));
    const Lanes origin = four_of(ray, 0);
    slabs_.cross(four_of(box, 0) - origin, arranged<1, 2, 3>(four_of(box, 2)) - origin,
                 arranged<1, 2, 3>(four_of(ray, 2)), t_max, tolerance::ray_lanes<float>);
  }

  [[gnu::always_inline]] RayVerdict verdict() const { return slabs_.verdict(); }

  /// The t of the side that is met is the largest, and the point is between all other sides by the margin.
  [[gnu::always_inline]] std::optional<RayHit<3, float>> hit() const {
    const Lanes direction = arranged<1, 2, 3>(four_of(ray_, 2));
    const LaneBits is_down = bit_cast<LaneBits>(direction) < 0;  // minus zero, too: its t is then minus infinity
    const Lanes side = is_down ? arranged<1, 2, 3>(four_of(box_, 2)) : four_of(box_, 0);
    const PairedVec origin(ray_.origin);
    const PairedVec slope(ray_.direction);
    const PairedVec across = (PairedVec(side) - origin) / slope;
    const double t = std::max(across.xy[0], std::max(across.xy[1], across.z));
    const Lanes along = turned_by_one(narrow(t, slope * t + origin));
    const Lanes point = slabs_.is_side() ? side : along;
    const LaneBits against = ~is_down & std::numeric_limits<int>::min();
    const LaneBits normal = slabs_.is_side() & (bit_cast<LaneBits>(Lanes{1, 1, 1, 1}) | against);
    const double error = tolerance::rounding * static_cast<double>(slabs_.size());
    return hit_of(__builtin_shufflevector(point, point, 3, 0, 1, 2), bit_cast<Lanes>(normal), error);
  }

 private:
  [[gnu::always_inline]] static Lanes turned_by_one(Lanes v) { return __builtin_shufflevector(v, v, 1, 2, 3, 0); }

  const Aabb<3, float>& box_;
  const Ray<3, float>& ray_;
  RaySlabFilter slabs_;
};

template <>
class RayBoxFilter<double> {
 public:
  [[gnu::always_inline]] RayBoxFilter(const Aabb<3, double>& box, const Ray<3, double>& ray, double t_max)
      : min_(read_paired(box.min)),
        max_(read_paired(box.max)),
        origin_(read_paired(ray.origin)),
        slope_(read_paired(ray.direction)) {
    const Lanes slope = narrow(slope_);
    const Lanes nothing = slope * 0.0F;  // unless a slope has become infinite, which then decides nothing
    slabs_.cross(narrow(min_ - origin_) + nothing, narrow(max_ - origin_), slope, static_cast<float>(t_max),
                 tolerance::ray_lanes<float>);
  }

  [[gnu::always_inline]] RayVerdict verdict() const { return slabs_.verdict(); }

  [[gnu::always_inline]] std::optional<RayHit<3, double>> hit() const {
    const LanePairBits is_down = bit_cast<LanePairBits>(LanePair(slope_.xy)) < 0;
    const bool is_z_down = std::signbit(slope_.z);
    const PairedVec side(is_down ? LanePair(max_.xy) : LanePair(min_.xy), is_z_down ? max_.z : min_.z);
    const PairedVec across = (side - origin_) / slope_;
    const double t = std::max(across.xy[0], std::max(across.xy[1], across.z));
    const PairedVec along = slope_ * t + origin_;
    const LaneBits met = slabs_.is_side();
    const LanePairBits is_met{met[0], met[1]};
    const LanePair against = is_down ? LanePair{1, 1} : LanePair{-1, -1};
    const PairedVec point(is_met ? LanePair(side.xy) : LanePair(along.xy), met[2] != 0 ? side.z : along.z);
    const PairedVec normal(is_met ? against : LanePair{0, 0}, met[2] == 0 ? 0.0 : is_z_down ? 1.0 : -1.0);
    const double error = tolerance::rounding * static_cast<double>(slabs_.size());
    return RayHit<3, double>{t, rounded_vec<double>(point), rounded_vec<double>(normal), Status::converged, error};
  }

 private:
  PairedVec min_;
  PairedVec max_;
  PairedVec origin_;
  PairedVec slope_;
  RaySlabFilter slabs_;
};

template <class T>
[[gnu::always_inline]] inline RayBoxFilter<T> quick_cast(const Aabb<3, T>& box, const Ray<3, T>& ray, T t_max) {
  return {box, ray, t_max};
}

}  // namespace graze::detail

#endif
