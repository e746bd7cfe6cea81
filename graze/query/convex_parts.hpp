// SPDX-License-Identifier: MIT
/// @file
/// convex_parts(polygon): a simple polygon as a union of convex ones. Clips ears (Meisters, "Polygons have ears",
/// 1975), then removes every diagonal that convexity does not need (Hertel and Mehlhorn, "Fast triangulation of simple
/// polygons", 1983): at most four times the least possible number of parts. All decisions are signs of exact
/// orientations, and no corners are added, so the parts cover the polygon without gap or overlap.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/orientation.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/segment.hpp>

namespace graze {

namespace detail {

/// The box around an edge.
template <class T>
Aabb<2, T> edge_box(const Segment<2, T>& edge) {
  return Aabb<2, T>::from_corners(edge.start, edge.end);
}

/// True if two edges share a point. If all orientations are 0, the edges are collinear, and their boxes decide.
template <class T>
bool edges_meet(const Segment<2, T>& a, const Segment<2, T>& b) {
  return boxes_overlap(edge_box(a), edge_box(b)) &&
         orientation(a.start, a.end, b.start) * orientation(a.start, a.end, b.end) <= 0 &&
         orientation(b.start, b.end, a.start) * orientation(b.start, b.end, a.end) <= 0;
}

/// The corners without repetitions and without those that lie straight between their neighbours.
template <class T>
std::vector<Vec<2, T>> true_corners(std::span<const Vec<2, T>> polygon) {
  std::vector<Vec<2, T>> corners;
  const auto straight_on = [](const Vec<2, T>& a, const Vec<2, T>& b, const Vec<2, T>& c) {
    // If they are collinear, b is passed if it lies in the box of the others.
    return orientation(a, b, c) == 0 && boxes_overlap(edge_box<T>({a, c}), Aabb<2, T>{b, b});
  };
  const auto drop_passed = [&](const Vec<2, T>& next) {
    if (!corners.empty() && corners.back() == next) corners.pop_back();
    while (corners.size() > 1 && straight_on(corners[corners.size() - 2], corners.back(), next)) corners.pop_back();
  };
  for (const Vec<2, T>& corner : polygon) {
    drop_passed(corner);
    corners.push_back(corner);
  }
  if (corners.size() > 1) drop_passed(corners.front());
  while (corners.size() > 2 && straight_on(corners.back(), corners[0], corners[1])) corners.erase(corners.begin());
  return corners;
}

/// The two ends of a set of collinear points, one point if they are all equal; none if they span an area.
template <class T>
std::optional<std::vector<Vec<2, T>>> ends_of_2d(std::span<const Vec<2, T>> points) {
  const auto less = [](const Vec<2, T>& a, const Vec<2, T>& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  const auto ends = std::minmax_element(points.begin(), points.end(), less);
  const Vec<2, T> low = *ends.first;
  const Vec<2, T> high = *ends.second;
  if (low == high) return std::vector<Vec<2, T>>{low};
  const bool flat = std::all_of(points.begin(), points.end(),
                                [&](const Vec<2, T>& point) { return orientation(low, high, point) == 0; });
  if (!flat) return std::nullopt;
  return std::vector<Vec<2, T>>{low, high};
}

/// True if neighbouring edges meet only in their common corner and other edges do not meet. `corners` are true corners.
/// Edges are taken from left to right and compared with those that still reach that far: fast unless all lie above each
/// other.
template <class T>
bool is_simple(const std::vector<Vec<2, T>>& corners) {
  const std::size_t count = corners.size();
  const auto edge = [&](std::size_t i) { return Segment<2, T>{corners[i], corners[(i + 1) % count]}; };
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto left = [&](std::size_t i) { return edge_box(edge(i)).min.x; };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return left(i) < left(j); });
  const auto neighbours_fold = [&](std::size_t i, std::size_t j) {
    // j follows i. True corners change direction, or go straight back on the same line.
    return orientation(edge(i).start, edge(i).end, edge(j).end) == 0;
  };
  std::vector<std::size_t> active;
  for (const std::size_t i : order) {
    std::erase_if(active, [&](std::size_t j) { return edge_box(edge(j)).max.x < left(i); });
    for (const std::size_t j : active) {
      const bool i_first = (i + 1) % count == j;
      const bool j_first = (j + 1) % count == i;
      if (i_first || j_first) {
        if (i_first ? neighbours_fold(i, j) : neighbours_fold(j, i)) return false;
      } else if (edges_meet(edge(i), edge(j))) {
        return false;
      }
    }
    active.push_back(i);
  }
  return true;
}

/// True if a simple polygon runs counter-clockwise: its lowest leftmost corner turns left.
template <class T>
bool runs_counter_clockwise(const std::vector<Vec<2, T>>& corners) {
  const std::size_t count = corners.size();
  std::size_t first = 0;
  for (std::size_t i = 1; i < count; ++i) {
    const bool further_left =
        corners[i].x != corners[first].x ? corners[i].x < corners[first].x : corners[i].y < corners[first].y;
    if (further_left) first = i;
  }
  return orientation(corners[(first + count - 1) % count], corners[first], corners[(first + 1) % count]) > 0;
}

/// A polygon cut into triangles: half-edge h of triangle h / 3 runs from corner `origin[h]` to that of the next one in
/// the same triangle; `twin[h]` is the same edge in the other triangle, or `none` on the outline.
struct Triangles {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  std::vector<std::size_t> origin;
  std::vector<std::size_t> twin;
};

/// Clips the ears of a polygon until a triangle is left.
template <class T>
class EarClipper {
 public:
  /// `corners` run counter-clockwise around a simple polygon and must outlive the clipper.
  explicit EarClipper(std::span<const Vec<2, T>> corners) : corners_(corners) {
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
      previous_.push_back((i + count - 1) % count);
      next_.push_back((i + 1) % count);
    }
    inner_side_.assign(count, Triangles::none);
    for (std::size_t i = 0; i < count; ++i) {
      if (turn(i) <= 0) hollows_.push_back(i);
    }
  }

  /// The triangles; none if no ear is found, which happens only if products of coordinates overflow.
  std::optional<Triangles> clip() {
    std::size_t left = corners_.size();
    std::size_t corner = 0;
    std::size_t misses = 0;
    while (left > 3) {
      if (is_ear(corner)) {
        cut(corner);
        --left;
        misses = 0;
        corner = previous_[corner];  // the corner before the ear has changed, so test it first
      } else {
        if (++misses > left) return std::nullopt;
        corner = next_[corner];
      }
    }
    if (turn(corner) <= 0) return std::nullopt;
    cut(corner);
    const std::size_t last = triangles_.origin.size() - 1;
    link(last, inner_side_[next_[corner]]);
    return std::move(triangles_);
  }

 private:
  int turn(std::size_t i) const { return orientation(corners_[previous_[i]], corners_[i], corners_[next_[i]]); }

  /// True if the triangle at a corner has an area and contains no other corner. Only reflex corners can be the nearest
  /// to the tip, so only those are tested.
  bool is_ear(std::size_t tip) const {
    if (turn(tip) <= 0) return false;
    const std::array<std::size_t, 3> ear{previous_[tip], tip, next_[tip]};
    Aabb<2, T> box = edge_box<T>({corners_[ear[0]], corners_[ear[1]]});
    box.grow(corners_[ear[2]]);
    return std::none_of(hollows_.begin(), hollows_.end(), [&](std::size_t i) {
      if (i == ear[0] || i == ear[2]) return false;
      const Vec<2, T>& point = corners_[i];
      if (!boxes_overlap(box, Aabb<2, T>{point, point})) return false;
      return orientation(corners_[ear[0]], corners_[ear[1]], point) >= 0 &&
             orientation(corners_[ear[1]], corners_[ear[2]], point) >= 0 &&
             orientation(corners_[ear[2]], corners_[ear[0]], point) >= 0;
    });
  }

  void link(std::size_t half_edge, std::size_t twin) {
    triangles_.twin[half_edge] = twin;
    if (twin != Triangles::none) triangles_.twin[twin] = half_edge;
  }

  /// Makes a triangle of a corner and its neighbours, and removes the corner from the rest.
  void cut(std::size_t tip) {
    const std::size_t before = previous_[tip];
    const std::size_t after = next_[tip];
    const std::size_t first = triangles_.origin.size();
    triangles_.origin.insert(triangles_.origin.end(), {before, tip, after});
    triangles_.twin.insert(triangles_.twin.end(), 3, Triangles::none);
    link(first, inner_side_[before]);
    link(first + 1, inner_side_[tip]);
    inner_side_[before] = first + 2;
    next_[before] = after;
    previous_[after] = before;
    std::erase_if(hollows_, [&](std::size_t i) { return (i == before || i == after) && turn(i) > 0; });
  }

  std::span<const Vec<2, T>> corners_;
  std::vector<std::size_t> previous_;
  std::vector<std::size_t> next_;
  std::vector<std::size_t> inner_side_;  ///< Of the edge from each corner on: the half-edge that was cut off along it.
  std::vector<std::size_t> hollows_;     ///< The corners that are not convex.
  Triangles triangles_;
};

/// Removes every diagonal at whose two ends the corners stay convex, and returns the remaining loops of half-edges.
template <class T>
std::vector<std::vector<Vec<2, T>>> merged(const std::vector<Vec<2, T>>& corners, const Triangles& triangles) {
  const std::size_t count = triangles.origin.size();
  std::vector<std::size_t> next(count);
  std::vector<std::size_t> previous(count);
  for (std::size_t h = 0; h < count; ++h) {
    next[h] = h % 3 == 2 ? h - 2 : h + 1;
    previous[h] = h % 3 == 0 ? h + 2 : h - 1;
  }
  const auto at = [&](std::size_t h) -> const Vec<2, T>& { return corners[triangles.origin[h]]; };
  // The corner where `arriving` ends if the diagonal after it is removed and `leaving` follows.
  const auto stays_convex = [&](std::size_t arriving, std::size_t leaving) {
    return orientation(at(arriving), at(leaving), at(next[leaving])) >= 0;
  };
  std::vector<bool> done(count, false);
  for (std::size_t h = 0; h < count; ++h) {
    const std::size_t twin = triangles.twin[h];
    if (twin == Triangles::none || twin < h) continue;
    if (!stays_convex(previous[h], next[twin]) || !stays_convex(previous[twin], next[h])) continue;
    done[h] = done[twin] = true;
    const std::array<std::pair<std::size_t, std::size_t>, 2> joints{
        {{previous[h], next[twin]}, {previous[twin], next[h]}}};
    for (const auto& [arriving, leaving] : joints) {
      next[arriving] = leaving;
      previous[leaving] = arriving;
    }
  }
  std::vector<std::vector<Vec<2, T>>> parts;
  for (std::size_t h = 0; h < count; ++h) {
    if (done[h]) continue;
    std::vector<Vec<2, T>> loop;
    for (std::size_t i = h; !done[i]; i = next[i]) {
      done[i] = true;
      loop.push_back(at(i));
    }
    parts.push_back(true_corners<T>(loop));
  }
  return parts;
}

}  // namespace detail

/// Splits a polygon into convex ones that do not overlap, each counter-clockwise (y up) and without collinear corners.
/// The polygon may have either orientation and repeat consecutive corners. A convex polygon is its only part; collinear
/// corners give the two ends, or the only point; no corners give no parts. Returns std::nullopt if the outline crosses
/// or touches itself, which is decided exactly, or a coordinate is not finite; `filled_parts` accepts outlines that
/// cross. Time: corners times reflex corners; n log n for a convex polygon.
template <class T>
std::optional<std::vector<std::vector<Vec<2, T>>>> convex_parts(
    std::type_identity_t<std::span<const Vec<2, T>>> polygon) {
  using Parts = std::vector<std::vector<Vec<2, T>>>;
  if (polygon.empty()) return Parts{};
  if (!std::all_of(polygon.begin(), polygon.end(), [](const Vec<2, T>& point) { return is_finite(point); })) {
    return std::nullopt;
  }
  if (auto ends = detail::ends_of_2d<T>(polygon)) return Parts{*std::move(ends)};
  std::vector<Vec<2, T>> corners = detail::true_corners<T>(polygon);
  if (!detail::is_simple(corners)) return std::nullopt;
  if (!detail::runs_counter_clockwise(corners)) std::reverse(corners.begin(), corners.end());
  const std::optional<detail::Triangles> triangles = detail::EarClipper<T>(corners).clip();
  if (!triangles) return std::nullopt;
  return detail::merged(corners, *triangles);
}

/// The overload for any contiguous range of points.
template <PointRow Row>
auto convex_parts(const Row& polygon) {
  return convex_parts<typename ElementOf<Row>::value_type>(span_of(polygon));
}

}  // namespace graze
