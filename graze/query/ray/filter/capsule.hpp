// SPDX-License-Identifier: MIT
// The first filter of a ray and a capsule. Include ray_cast.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <graze/math/lanes/paired.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/ray.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// The distance between a ray and a capsule's axis decides whether it hits, unless they are nearly parallel: the
/// nearest point of the axis to the two lines' common perpendicular, clamped to its ends, and the nearest point of the
/// ray to that (Ericson, "Real-Time Collision Detection", 2005, section 5.1.9). A ray that hits from outside enters by
/// the cylinder, which is a sphere when projected along the axis, if that is between the two ends, otherwise by the
/// sphere around the nearer end. Others are unclear.
template <Dim N, class T>
class RayCapsuleFilter {
 public:
  [[gnu::always_inline]] RayCapsuleFilter(const Capsule<N, T>& capsule, const Ray<N, T>& ray, T t_max)
      : origin_(ray.origin),
        direction_(ray.direction),
        a_(Paired<N>(capsule.a) - origin_),
        edge_(Paired<N>(capsule.b) - origin_ - a_),
        radius_(static_cast<double>(capsule.radius)),
        t_max_(latest_t(t_max)),
        dd_(dot(direction_, direction_)),
        ee_(dot(edge_, edge_)),
        de_(dot(direction_, edge_)),
        ea_(dot(edge_, a_)),
        det_(dd_ * ee_ - de_ * de_) {
    const double da = dot(direction_, a_);
    const double aa = dot(a_, a_);
    const double products = dd_ * ee_;
    constexpr double least_sine_squared = 0x1p-20;
    const bool is_moderate = (dd_ > 0x1p-400) & (dd_ < 0x1p400) & (ee_ > 0x1p-400) & (ee_ + aa < 0x1p400);
    if (is_moderate & passes_by(da, aa)) {
      verdict_ = RayVerdict::misses;
      return;
    }
    if (!(is_moderate & (det_ > least_sine_squared * products) & (t_max >= T(0)))) return;
    per_dd_ = 1 / dd_;
    per_ee_ = 1 / ee_;
    const double first = held((da * ee_ - ea_ * de_) / det_, t_max_);
    const double share = held((de_ * first - ea_) * per_ee_, 1);
    const double t = held((de_ * share + da) * per_dd_, t_max_);
    const Paired<N> between = direction_ * t - (edge_ * share + a_);
    const double squared_radius = radius_ * radius_;
    const double outside = dot(between, between) - squared_radius;
    band_ = band_of(aa);
    if (outside > band_) verdict_ = RayVerdict::misses;
    if (outside < -band_) enter();
    if (!(t_ <= static_cast<double>(t_max)) && verdict_ == RayVerdict::hits)
      verdict_ = RayVerdict::unclear;  // T may round it
  }

  [[gnu::always_inline]] RayVerdict verdict() const { return verdict_; }

  [[gnu::always_inline]] std::optional<RayHit<N, T>> hit() const {
    const Paired<N> normal = unit_of(spoke_ * -1, radius_);
    const double error =
        tolerance::rounding * (2 * sum_of_coordinates(magnitude(a_)) + sum_of_coordinates(magnitude(edge_)) + radius_);
    return RayHit<N, T>{static_cast<T>(held(t_, t_max_)), rounded_vec<T>(center_ + normal * radius_ + origin_),
                        rounded_vec<T>(normal), Status::converged, error};
  }

 private:
  /// The nearest point of the ray is no farther from its origin than the capsule, so that three times its squares are
  /// an upper bound, wherever the ray ends.
  [[gnu::always_inline]] double band_of(double aa) const {
    return 3 * tolerance::ray_capsule * (aa + ee_ + radius_ * radius_);
  }

  /// The whole line misses the infinite cylinder, or all is behind the ray: decided without a division.
  [[gnu::always_inline]] bool passes_by(double da, double aa) const {
    const double squared_radius = radius_ * radius_;
    const double band = band_of(aa);
    // The line's nearest points to the axis are at (b - sqrt(b^2 - det c)) / det and with the plus sign.
    const double b = ee_ * da - ea_ * de_;
    const double c = ee_ * (aa - squared_radius) - ea_ * ea_;
    const double foremost = std::max(da, da + de_);
    return (det_ * c - b * b > band * (ee_ * ee_) * dd_) |
           ((foremost < 0) & (foremost * foremost > dd_ * (squared_radius + band)));
  }

  /// Clamped to between zero and a bound; most compilers make it branch-free.
  [[gnu::always_inline]] static double held(double number, double most) {
    return std::min(std::max(number, 0.0), most);
  }

  /// For a ray that hits: where, unless it begins inside or nearly so, or enters a cylinder to which it is nearly
  /// parallel.
  [[gnu::always_inline]] void enter() {
    const Paired<N> beside_origin = a_ + edge_ * held(-ea_ * per_ee_, 1);
    if (!(dot(beside_origin, beside_origin) - radius_ * radius_ > band_)) return;
    const Paired<N> across = direction_ - edge_ * (de_ * per_ee_);
    const double whole = dot(across, across);
    pass(a_ - edge_ * (ea_ * per_ee_), across, 1 / whole);
    const double place = (de_ * t_ - ea_) * per_ee_;
    if (place >= 0 && place <= 1) {
      constexpr double least_sine_squared = 1.0 / 64;
      if (!(whole > least_sine_squared * dd_)) verdict_ = RayVerdict::unclear;
      center_ = a_ + edge_ * place;
    } else {
      center_ = place < 0 ? a_ : a_ + edge_;
      pass(center_, direction_, per_dd_);
    }
  }

  /// Where a line through zero enters a sphere; undecided if it nearly misses it.
  [[gnu::always_inline]] void pass(Paired<N> center, Paired<N> direction, double per_whole) {
    const double middle = dot(center, direction) * per_whole;
    const Paired<N> off = center - direction * middle;
    const double depth = radius_ * radius_ - dot(off, off);
    const double half = std::sqrt(std::fabs(depth) * per_whole);
    t_ = middle - half;
    spoke_ = off + direction * half;  // to the center
    verdict_ = depth > band_ ? RayVerdict::hits : RayVerdict::unclear;
  }

  Paired<N> origin_;
  Paired<N> direction_;
  Paired<N> a_;  ///< Relative to the ray's origin.
  Paired<N> edge_;
  double radius_;
  double t_max_;
  double dd_;
  double ee_;
  double de_;
  double ea_;
  double det_;
  double per_dd_ = 0;
  double per_ee_ = 0;
  double band_ = 0;
  // Where the ray hits, if it does.
  double t_ = 0;
  Paired<N> spoke_{Vec<N, double>(0.0)};
  Paired<N> center_{Vec<N, double>(0.0)};
  RayVerdict verdict_ = RayVerdict::unclear;
};

template <Dim N, class T>
[[gnu::always_inline]] inline RayCapsuleFilter<N, T> quick_cast(const Capsule<N, T>& capsule, const Ray<N, T>& ray,
                                                                T t_max) {
  return {capsule, ray, t_max};
}

}  // namespace graze::detail

#endif
