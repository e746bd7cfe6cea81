// SPDX-License-Identifier: MIT
// The first filters of a ray and a segment, a triangle or a polygon in 2D. Include ray_cast.hpp.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include <graze/math/lanes/paired.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/triangle.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// A ray and edges in 2D, in double. The line of the ray crosses an edge whose ends are on either side of it, each by
/// more than tolerance::ray_side of the sizes: many times what the precise algorithm leaves to `relation`. The
/// intersection is separated from both ends of the ray by as much.
template <class T>
class RayEdgeFilter {
 public:
  [[gnu::always_inline]] RayEdgeFilter(const Ray<2, T>& ray, T t_max)
      : origin_(wide<2, T>(ray.origin)),
        direction_(wide<2, T>(ray.direction)),
        t_max_(std::max(static_cast<double>(t_max), 0.0)) {}

  [[gnu::always_inline]] Vec<2, double> seen(const Vec<2, T>& corner) const { return wide<2, T>(corner) - origin_; }

  /// The signed side of the ray's line that a point is on, relative to the ray's origin.
  [[gnu::always_inline]] double side_of(const Vec<2, double>& seen) const { return cross_2d(direction_, seen); }

  /// What a side must exceed for points whose coordinates have the sum `size`.
  [[gnu::always_inline]] double band(double size) const {
    const double slopes = std::fabs(direction_.x) + std::fabs(direction_.y);
    const bool is_moderate = (slopes > 0x1p-400) & (slopes < 0x1p400) & (size > 0x1p-400) & (size < 0x1p400);
    return is_moderate ? tolerance::ray_side * slopes * size : std::numeric_limits<double>::infinity();
  }

  /// Decides a ray whose line is known to cross an edge. At t = height / climb the height above the edge's line is
  /// zero. What is certain at twice that t is certain at all later ones. `far` is what the rounding of `relation` is
  /// relative to, besides the size.
  [[gnu::always_inline]] RayVerdict cross(const Vec<2, double>& from, const Vec<2, double>& to, double size,
                                          double far) {
    edge_ = to - from;
    climb_ = cross_2d(direction_, edge_);
    height_ = cross_2d(from, edge_);
    const double slack = 4 * tolerance::ray_side * (size + far) * (std::fabs(edge_.x) + std::fabs(edge_.y));
    const double height = std::fabs(height_);
    const double approach = (height_ < 0) == (climb_ < 0) ? std::fabs(climb_) : -std::fabs(climb_);
    const double beyond = approach * t_max_ - height;
    const double beyond_latest = approach * latest_t(static_cast<T>(t_max_)) - height;
    is_behind_ = approach < 0;
    size_ = size;
    if ((height > slack) & (beyond > slack)) return RayVerdict::hits;
    if ((height > slack) & (beyond_latest < -slack)) return RayVerdict::misses;
    return RayVerdict::unclear;
  }

  /// Whether an edge that is missed is behind the ray's origin, rather than beyond its end.
  [[gnu::always_inline]] bool is_behind() const { return is_behind_; }

  [[gnu::always_inline]] std::optional<RayHit<2, T>> hit() const {
    const double t = height_ / climb_;
    const double per_length = std::copysign(1 / std::sqrt(dot(edge_, edge_)), -climb_);
    const Vec<2, double> normal(edge_.y * per_length, -edge_.x * per_length);
    return RayHit<2, T>{static_cast<T>(t), Vec<2, T>(origin_ + direction_ * t) + T(0), Vec<2, T>(normal) + T(0),
                        Status::converged, 2 * tolerance::rounding * size_};
  }

 private:
  Vec<2, double> origin_;
  Vec<2, double> direction_;
  double t_max_;
  Vec<2, double> edge_ = Vec<2, double>(0.0);
  double climb_ = 0;
  double height_ = 0;
  double size_ = 0;
  bool is_behind_ = false;
};

/// A ray that passes both ends of a segment on the same side misses it; any other crosses it, if it does not end
/// before.
template <class T>
class RaySegmentFilter {
 public:
  [[gnu::always_inline]] RaySegmentFilter(const Segment<2, T>& segment, const Ray<2, T>& ray, T t_max)
      : edge_(ray, t_max) {
    const Vec<2, double> start = edge_.seen(segment.start);
    const Vec<2, double> end = edge_.seen(segment.end);
    const double size = sum_abs(start) + sum_abs(end);
    const double first = edge_.side_of(start);
    const double second = edge_.side_of(end);
    const double band = edge_.band(size);
    const double least = std::min(std::fabs(first), std::fabs(second));
    if (!(least > band)) return;
    verdict_ = (first > 0) == (second > 0) ? RayVerdict::misses : edge_.cross(start, end, size, 0);
  }

  [[gnu::always_inline]] RayVerdict verdict() const { return verdict_; }
  [[gnu::always_inline]] std::optional<RayHit<2, T>> hit() const { return edge_.hit(); }

 private:
  RayEdgeFilter<T> edge_;
  RayVerdict verdict_ = RayVerdict::unclear;
};

template <class T>
[[gnu::always_inline]] inline RaySegmentFilter<T> quick_cast(const Segment<2, T>& segment, const Ray<2, T>& ray,
                                                             T t_max) {
  return {segment, ray, t_max};
}

/// One coordinate each of two corners.
struct CornerPair {
  LanePair x;
  LanePair y;
};

template <class T>
[[gnu::always_inline]] inline CornerPair read_corners(const Vec<2, T>& first, const Vec<2, T>& second) {
  const Vec<2, double> one = wide<2, T>(first);
  const Vec<2, double> two = wide<2, T>(second);
  return {LanePair{one.x, two.x}, LanePair{one.y, two.y}};
}

/// The line of a ray enters a polygon by the edge that begins on its left and ends on its right, and leaves it by the
/// one that does the opposite; no other edge is evaluated.
template <class T>
class RayPolygonFilter {
 public:
  static constexpr std::size_t most_corners = 64;  ///< Each side has a bit.

  /// In counter-clockwise order.
  [[gnu::always_inline]] RayPolygonFilter(const Vec<2, T>* corners, std::size_t count, const Ray<2, T>& ray, T t_max,
                                          double far)
      : edge_(ray, t_max) {
    if (count < 3 || count > most_corners) return;
    const LanePair origin_x = LanePair{} + static_cast<double>(ray.origin.x);
    const LanePair origin_y = LanePair{} + static_cast<double>(ray.origin.y);
    const LanePair slope_x = LanePair{} + static_cast<double>(ray.direction.x);
    const LanePair slope_y = LanePair{} + static_cast<double>(ray.direction.y);
    std::uint64_t left = 0;
    LanePair sizes{};
    LanePair least = LanePair{} + std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; i += 2) {
      const CornerPair pair = read_corners<T>(corners[i], corners[i + 1 < count ? i + 1 : 0]);
      const LanePair x = pair.x - origin_x;
      const LanePair y = pair.y - origin_y;
      const LanePair side = slope_x * y - slope_y * x;
      const LanePair size = magnitude(x) + magnitude(y);
      const LanePair height = magnitude(side);
      sizes = size > sizes ? size : sizes;
      least = height < least ? height : least;
      left |= std::uint64_t{sign_bits(side)} << i;
    }
    const double size = std::max(sizes[0], sizes[1]);
    if (!(std::min(least[0], least[1]) > edge_.band(size + far))) return;
    settle(corners, count, size, far, ~left & (~std::uint64_t{0} >> (most_corners - count)));
  }

  [[gnu::always_inline]] RayVerdict verdict() const { return verdict_; }
  [[gnu::always_inline]] std::optional<RayHit<2, T>> hit() const { return edge_.hit(); }

 private:
  /// Bit i of `left` is set if corner i is on the left of the ray's line; all are off it by a margin.
  [[gnu::always_inline]] void settle(const Vec<2, T>* corners, std::size_t count, double size, double far,
                                     std::uint64_t left) {
    const std::uint64_t next = left >> 1U | left << (count - 1);
    const auto cross = [&](std::uint64_t edges) __attribute__((always_inline)) {
      const auto i = static_cast<std::size_t>(std::countr_zero(edges));
      return edge_.cross(edge_.seen(corners[i]), edge_.seen(corners[i + 1 == count ? 0 : i + 1]), size, far);
    };
    const std::uint64_t all = ~std::uint64_t{0} >> (most_corners - count);
    const std::uint64_t entering = left & ~next & all;
    if (entering == 0) {
      verdict_ = RayVerdict::misses;
      return;
    }
    verdict_ = cross(entering);
    // The line enters before the ray begins; it is missed only if the line also leaves before.
    if (verdict_ == RayVerdict::misses && edge_.is_behind()) {
      const bool is_left = cross(~left & next & all) == RayVerdict::misses && edge_.is_behind();
      if (!is_left) verdict_ = RayVerdict::unclear;
    }
  }

  RayEdgeFilter<T> edge_;
  RayVerdict verdict_ = RayVerdict::unclear;
};

template <class T>
[[gnu::always_inline]] inline RayPolygonFilter<T> quick_cast(const Polytope<2, T>& polygon, const Ray<2, T>& ray,
                                                             T t_max) {
  const auto corners = polygon.vertices();
  return {corners.data(), corners.size(), ray, t_max, sum_abs(wide<2, T>(ray.origin))};
}

/// In counter-clockwise order according to their area; if that is zero, either order will do.
template <class T>
[[gnu::always_inline]] inline RayPolygonFilter<T> quick_cast(const Triangle<2, T>& triangle, const Ray<2, T>& ray,
                                                             T t_max) {
  const Vec<2, double> a = wide<2, T>(triangle.a);
  const bool is_clockwise = cross_2d(wide<2, T>(triangle.b) - a, wide<2, T>(triangle.c) - a) < 0;
  const Vec<2, T> corners[] = {triangle.a, is_clockwise ? triangle.c : triangle.b,
                               is_clockwise ? triangle.b : triangle.c};
  return {corners, 3, ray, t_max, 0};
}

}  // namespace graze::detail

#endif
