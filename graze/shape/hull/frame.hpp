// SPDX-License-Identifier: MIT
// On which side of planes the points of a hull are: decided by a filter in double, exactly where that is uncertain.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/exact/exact_determinant.hpp>
#include <graze/math/orientation_3d.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/hull/shear.hpp>

namespace graze::detail {

/// A point of a HullFrame: its position in the frame and its index in the original list.
struct HullPoint {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  Vec<3, double> place = Vec<3, double>(0.0);
  std::uint32_t index = 0;
  std::uint32_t link = none;  ///< A face of a Quickhull that it may be outside of.
};

/// A plane through three points of a HullFrame. Points with height above `doubt` are strictly on the side from which
/// the three are counter-clockwise; points at -doubt or below are not; in between the sign is uncertain.
struct HullPlane {
  Vec<3, double> normal = Vec<3, double>(0.0);
  double offset = 0;
  double doubt = 0;

  double height(const Vec<3, double>& place) const {
    return normal.x * place.x + normal.y * place.y + normal.z * place.z - offset;
  }
};

/// A coordinate frame for points: relative to the center of their box, scaled by a power of two so that no coordinate
/// exceeds 1. Requires at least one point and fewer than 2^32, all finite; the points must outlive the frame. If
/// coordinates differ by more than a factor of 1e179 and the smallest is below 1e-90, products would leave the range of
/// double, so the smaller ones count as zero.
template <class T>
class HullFrame {
 public:
  explicit HullFrame(std::span<const Vec<3, T>> points) : points_(points) {
    if constexpr (std::is_same_v<T, double>) bring_into_range();
    find_box();
    is_exact_ = is_on_grid();
  }

  /// A frame for points that are collinear or coplanar up to rounding: positions are the images under HullShear, where
  /// the fewest sides are uncertain. The points must be in range.
  static HullFrame sheared(std::span<const Vec<3, T>> points) {
    return HullFrame(points, HullShear<T>(points).places());
  }

  bool is_sheared() const { return !places_.empty(); }

  // The span may refer to a member.
  HullFrame(const HullFrame&) = delete;
  HullFrame& operator=(const HullFrame&) = delete;

  std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }

  /// The points with the smallest and the largest coordinate along the longest side of the box; equal only if all
  /// points coincide.
  std::array<std::uint32_t, 2> ends() const { return ends_; }

  /// Half extents of the box of the positions, in the frame's units; the largest is from 0.5 to 1, or all are 0.
  const Vec<3, double>& half_extents() const { return half_extents_; }

  HullPoint at(std::uint32_t index) const {
    return {places_.empty() ? place_of(points_[index]) : places_[index], index};
  }

  /// The position of another point inside the box. Not for a sheared frame.
  HullPoint seen(const Vec<3, T>& point) const { return {place_of(point), HullPoint::none}; }

  /// The original point, scaled into range if necessary.
  const Vec<3, T>& point(std::uint32_t index) const { return points_[index]; }

  HullPlane plane(const HullPoint& a, const HullPoint& b, const HullPoint& c) const {
    const Vec<3, double> u = b.place - a.place;
    const Vec<3, double> v = c.place - a.place;
    const Vec<3, double> normal(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
    const double offset = normal.x * a.place.x + normal.y * a.place.y + normal.z * a.place.z;
    if (is_exact_) return {normal, offset, 0};
    const double size = max_abs(u) + max_abs(v);
    if (places_.empty()) return {normal, offset, tolerance::hull_plane * (size + 4 * tolerance::epsilon)};
    return {normal, offset, tolerance::hull_sheared_plane * (size + 8 * tolerance::hull_shear)};
  }

  /// `orientation` of the points at four indices.
  int orientation_of(const std::array<std::uint32_t, 3>& corners, std::uint32_t point) const {
    return orientation_of(corners, points_[point]);
  }

  /// The same for any point.
  int orientation_of(const std::array<std::uint32_t, 3>& corners, const Vec<3, T>& point) const {
    return orientation(points_[corners[0]], points_[corners[1]], points_[corners[2]], point);
  }

  /// A point in integer units, for exact heights above planes.
  IntegerPoint integer_point(std::uint32_t index) const { return {wide<3, T>(points_[index]), integer_unit(largest_)}; }

  /// The plane through three such points.
  IntegerPlane integer_plane(const std::array<IntegerPoint, 3>& corners) const {
    return {corners, integer_unit(largest_)};
  }

  /// Whether heights above planes are exact: the points lie on a grid of at most 2^15 steps.
  bool is_exact() const { return is_exact_; }

 private:
  HullFrame(std::span<const Vec<3, T>> points, std::vector<Vec<3, double>> places)
      : points_(points), places_(std::move(places)) {
    find_box();
    Vec<3, double> low = places_.front();
    Vec<3, double> high = low;
    for (const Vec<3, double>& place : places_) {
      low = min(low, place);
      high = max(high, place);
    }
    half_extents_ = 0.5 * (high - low);
  }

  Vec<3, double> place_of(const Vec<3, T>& point) const { return (wide<3, T>(point) - middle_) * scale_; }

  void bring_into_range() {
    constexpr double most = 0x1p298;  // the range of `orientation`, 1e-90 to 1e90
    constexpr double least = 0x1p-298;
    double largest = 0;
    bool is_in_range = true;
    for (const Vec<3, T>& point : points_) {
      for (Dim i = 0; i < 3; ++i) {
        const double size = std::fabs(point[i]);
        largest = std::max(largest, size);
        is_in_range = is_in_range && size < most && (size > least || size == 0);
      }
    }
    if (is_in_range) return;
    const int shift = std::ilogb(most) - 1 - std::ilogb(largest);
    scaled_.assign(points_.begin(), points_.end());
    for (Vec<3, T>& point : scaled_) {
      for (Dim i = 0; i < 3; ++i) {
        point[i] = std::scalbn(point[i], shift);
        if (std::fabs(point[i]) < least) point[i] = 0;
      }
    }
    points_ = scaled_;
  }

  void find_box() {
    Vec<3, T> low = points_.front();
    Vec<3, T> high = low;
    std::array<std::array<std::uint32_t, 2>, 3> ends{};
    for (std::uint32_t i = 0; i < size(); ++i) {
      for (Dim axis = 0; axis < 3; ++axis) {
        const T x = points_[i][axis];
        if (x < low[axis]) {
          low[axis] = x;
          ends[static_cast<std::size_t>(axis)][0] = i;
        } else if (x > high[axis]) {
          high[axis] = x;
          ends[static_cast<std::size_t>(axis)][1] = i;
        }
      }
    }
    largest_ = std::max(max_abs(wide<3, T>(low)), max_abs(wide<3, T>(high)));
    middle_ = 0.5 * wide<3, T>(low) + 0.5 * wide<3, T>(high);
    half_extents_ = 0.5 * wide<3, T>(high) - 0.5 * wide<3, T>(low);
    Dim longest = 0;
    for (Dim axis = 1; axis < 3; ++axis) longest = half_extents_[axis] > half_extents_[longest] ? axis : longest;
    ends_ = ends[static_cast<std::size_t>(longest)];
    if (half_extents_[longest] > 0) scale_ = std::ldexp(1.0, -std::ilogb(half_extents_[longest]) - 1);
    half_extents_ *= scale_;
  }

  /// With integer coordinates up to 2^15, a normal is below 2^34 and a height below 2^52: all are exact.
  bool is_on_grid() const {
    constexpr double steps = 0x1p15;
    for (const Vec<3, T>& point : points_) {
      const Vec<3, double> place = place_of(point) * steps;
      for (Dim i = 0; i < 3; ++i) {
        if (static_cast<double>(static_cast<std::int32_t>(place[i])) != place[i]) return false;
        if (two_sum(static_cast<double>(point[i]), -middle_[i]).error != 0) return false;
      }
    }
    return true;
  }

  std::span<const Vec<3, T>> points_;
  std::vector<Vec<3, T>> scaled_;       // only if points_ were out of range
  std::vector<Vec<3, double>> places_;  // only if sheared
  Vec<3, double> middle_ = Vec<3, double>(0.0);
  Vec<3, double> half_extents_ = Vec<3, double>(0.0);
  double scale_ = 1;
  double largest_ = 0;  ///< The largest magnitude of a coordinate.
  std::array<std::uint32_t, 2> ends_{};
  bool is_exact_ = false;
};

template <class T>
std::vector<HullPoint> all_points(const HullFrame<T>& frame) {
  std::vector<HullPoint> points;
  points.reserve(frame.size());
  for (std::uint32_t i = 0; i < frame.size(); ++i) points.push_back(frame.at(i));
  return points;
}

}  // namespace graze::detail
