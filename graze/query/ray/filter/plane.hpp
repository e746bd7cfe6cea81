// SPDX-License-Identifier: MIT
// The first filter of a ray and a plane or half-space. Include ray_cast.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <graze/math/lanes/paired.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/shape/half_space.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/ray.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// The height of a ray's origin above a plane and its speed of approach, in units of the normal, by plain sums in
/// double. With h and c as the sums of the magnitudes of their terms, the sums are off by less than 4 epsilon of those,
/// and where the ray ends, at t or before 2 t, by 4 epsilon of h + 2 c t, which is less than 2^-33 h for a ray that
/// approaches by at least 2^-10 c: what is farther from the plane than that at both ends exceeds what the precise
/// algorithm calls touching. Everything else is unclear, including rays at small angles. There is one branch for each
/// verdict and none for its conditions, because those of random rays are unpredictable.
template <Dim N, class T>
class RayPlaneFilter {
 public:
  [[gnu::always_inline]] RayPlaneFilter(const Plane<N, T>& plane, const Ray<N, T>& ray, T t_max, bool is_solid)
      : normal_(plane.normal), origin_(ray.origin), direction_(ray.direction), squared_(dot(normal_, normal_)) {
    const LanePair offset{static_cast<double>(plane.offset), 0};
    const TwoSums sums = two_sums(products(normal_, origin_), products(normal_, direction_));
    const LanePair height_and_climb = sums.value - offset;
    sizes_ = sums.magnitude + magnitude(offset);
    const LanePair slack = sizes_ * LanePair{tolerance::ray_plane, least_slope};
    // Each comparison by itself: GCC splits vectors joined by & into scalars and assembles them again.
    const LanePairBits is_far = magnitude(height_and_climb) > slack;
    const LanePairBits is_large = sizes_ > least_size;
    const LanePairBits is_small = sizes_ < 1 / least_size;
    const unsigned clear = sign_bits(is_far) & sign_bits(is_large) & sign_bits(is_small);
    const bool is_moderate = (squared_ > least_size) & (squared_ < 1 / least_size);
    height_ = height_and_climb[0];
    approach_ = -height_and_climb[1] * std::copysign(1.0, height_);
    const bool is_settled = (clear == 3) & is_moderate & !(is_solid & (height_ < 0));
    const T end = std::max(T(0), t_max);
    const double beyond = approach_ * static_cast<double>(end) - std::fabs(height_);
    const double beyond_latest = approach_ * latest_t(end) - std::fabs(height_);
    is_hit_ = is_settled & (beyond > slack[0]);
    is_missed_ = is_settled & (beyond_latest < -slack[0]);
  }

  [[gnu::always_inline]] RayVerdict verdict() const {
    if (is_hit_) return RayVerdict::hits;
    return is_missed_ ? RayVerdict::misses : RayVerdict::unclear;
  }

  [[gnu::always_inline]] std::optional<RayHit<N, T>> hit() const {
    const LanePair quotients = LanePair{std::fabs(height_), 1} / LanePair{approach_, std::sqrt(squared_)};
    const double t = quotients[0];
    const double per_length = quotients[1];
    const double sizes = 2 * sizes_[0] + sizes_[1] * t;  // at least those of the terms of both heights
    return RayHit<N, T>{static_cast<T>(t), rounded_vec<T>(origin_ + direction_ * t),
                        rounded_vec<T>(normal_ * std::copysign(per_length, height_)), Status::converged,
                        2 * tolerance::rounding * sizes * per_length};
  }

 private:
  static constexpr double least_size = 0x1p-480;
  static constexpr double least_slope = 0x1p-10;

  Paired<N> normal_;
  Paired<N> origin_;
  Paired<N> direction_;
  double squared_;
  LanePair sizes_;   ///< The sums of the magnitudes of the terms of the height and of the climb.
  double height_;    ///< The height of the ray's origin above the plane.
  double approach_;  ///< The decrease of the height per unit of t.
  bool is_hit_;
  bool is_missed_;
};

template <Dim N, class T>
[[gnu::always_inline]] inline RayPlaneFilter<N, T> quick_cast(const Plane<N, T>& plane, const Ray<N, T>& ray, T t_max) {
  return {plane, ray, t_max, false};
}

/// A ray from outside meets the boundary; everything else is unclear.
template <Dim N, class T>
[[gnu::always_inline]] inline RayPlaneFilter<N, T> quick_cast(const HalfSpace<N, T>& solid, const Ray<N, T>& ray,
                                                              T t_max) {
  return {boundary(solid), ray, t_max, true};
}

}  // namespace graze::detail

#endif
