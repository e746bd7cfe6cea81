// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <graze/math/vec.hpp>
#include <graze/shape/hull/frame.hpp>
#include <graze/shape/plane.hpp>

namespace graze::detail {

/// Indices of points that span the affine hull of some points of a frame, decided exactly: one if all coincide, two on
/// a line, three in a plane, otherwise four, the last on the inner side of the first three. They are chosen
/// approximately as far apart as possible.
template <class T>
class HullBase {
 public:
  HullBase() = default;

  /// The points must include the frame's ends or lie between them.
  HullBase(const HullFrame<T>& frame, std::span<const HullPoint> points) {
    const auto [a, b] = frame.ends();
    add(a);
    if (frame.point(a) == frame.point(b)) return;
    add(b);
    const Vec<3, double> origin = frame.at(a).place;
    const Vec<3, double> edge = frame.at(b).place - origin;
    const auto across = [&](const Vec<3, double>& place) {
      const Vec<3, double> normal = cross(edge, place - origin);
      return dot(normal, normal);
    };
    const std::uint32_t c = farthest_by(points, across, [&, a = a, b = b](std::uint32_t i) {
      return !are_on_one_line(frame.point(a), frame.point(b), frame.point(i));
    });
    if (c == HullPoint::none) return;
    add(c);
    const HullPlane plane = frame.plane(frame.at(a), frame.at(b), frame.at(c));
    const auto is_off_plane = [&](std::uint32_t i) { return frame.orientation_of(first_three(), i) != 0; };
    const std::uint32_t d = farthest_by(
        points, [&](const Vec<3, double>& place) { return std::fabs(plane.height(place)); }, is_off_plane);
    if (d == HullPoint::none) return;
    add(d);
    if (frame.orientation_of(first_three(), d) > 0) std::swap(places_[1], places_[2]);
  }

  std::span<const std::uint32_t> places() const { return {places_.data(), size_}; }

 private:
  void add(std::uint32_t place) { places_[size_++] = place; }
  std::array<std::uint32_t, 3> first_three() const { return {places_[0], places_[1], places_[2]}; }

  /// The point with the largest `measure` if `counts` holds for it; otherwise any point for which `counts` holds;
  /// otherwise none.
  template <class Measure, class Counts>
  static std::uint32_t farthest_by(std::span<const HullPoint> points, const Measure& measure, const Counts& counts) {
    std::uint32_t best = points.front().index;
    double largest = -1;
    for (const HullPoint& point : points) {
      const double size = measure(point.place);
      if (!(size > largest)) continue;
      largest = size;
      best = point.index;
    }
    if (counts(best)) return best;
    const auto other =
        std::find_if(points.begin(), points.end(), [&](const HullPoint& point) { return counts(point.index); });
    return other == points.end() ? HullPoint::none : other->index;
  }

  std::array<std::uint32_t, 4> places_{};
  std::size_t size_ = 0;
};

}  // namespace graze::detail
