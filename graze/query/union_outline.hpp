// SPDX-License-Identifier: MIT
/// @file
/// union_outline(polygons): the outline of the union of convex polygons, for pictures of shapes that consist of convex
/// parts. Keeps the pieces of every edge that lie in no other polygon and on no edge that another one shares, and joins
/// them end to end. An edge is clipped by a polygon as by Cyrus and Beck, "Generalized two- and three-dimensional
/// clipping" (1978).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze {

/// `union_outline` merges lines that differ by less than this, relative to the total size: far above the rounding of
/// moved coordinates, far below what a picture shows.
inline constexpr double picture_resolution = 1e-9;

namespace detail {

/// Pieces are joined at ends that differ by at most this many times the resolution: where two edges cross at a small
/// angle, rounding moves the crossing along each of them.
inline constexpr double crossing_slack = 64;

/// An edge with the polygon on its left, and the direction out of the polygon.
struct RimEdge {
  Vec<2, double> start;
  Vec<2, double> end;
  Vec<2, double> outward;  ///< Of length 1.

  /// The height of a point above the edge's line, outward.
  double height(const Vec<2, double>& point) const { return dot(outward, point - start); }
};

/// A convex polygon of at least three corners, counter-clockwise.
struct RimPolygon {
  std::vector<RimEdge> edges;
  Aabb<2, double> box;
};

class UnionOutline {
 public:
  using Polygon = std::vector<Vec<2, double>>;

  explicit UnionOutline(std::span<const Polygon> polygons) {
    Aabb<2, double> all = Aabb<2, double>::nothing();
    for (const Polygon& polygon : polygons) {
      for (const Vec<2, double>& corner : polygon) all.grow(corner);
    }
    if (!(all.min.x <= all.max.x)) return;
    const double farthest = std::max(max_abs(all.min), max_abs(all.max));
    tolerance_ = std::max(max_abs(all.max - all.min) * picture_resolution, farthest * tolerance::rounding);
    for (const Polygon& polygon : polygons) add(polygon);
  }

  std::vector<Polygon> loops() {
    std::vector<std::vector<std::size_t>> neighbours = overlapping();
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      for (const RimEdge& edge : polygons_[i].edges) keep_bare(edge, i, neighbours[i]);
    }
    return joined();
  }

 private:
  struct Interval {
    double from;
    double to;
  };

  void add(const Polygon& corners) {
    RimPolygon polygon{{}, Aabb<2, double>::nothing()};
    double twice_area = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      twice_area += cross_2d(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      Vec<2, double> start = corners[i];
      Vec<2, double> end = corners[(i + 1) % corners.size()];
      if (twice_area < 0) std::swap(start, end);
      const Vec<2, double> along = end - start;
      const double length = std::sqrt(dot(along, along));
      if (!(length > tolerance_)) continue;
      polygon.edges.push_back({start, end, Vec<2, double>(along.y, -along.x) / length});
      polygon.box.grow(start);
      polygon.box.grow(end);
    }
    if (polygon.edges.size() > 2) polygons_.push_back(std::move(polygon));
  }

  /// For each polygon, the others whose boxes it meets, by a sweep from left to right.
  std::vector<std::vector<std::size_t>> overlapping() const {
    std::vector<std::size_t> order(polygons_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return polygons_[a].box.min.x < polygons_[b].box.min.x; });
    std::vector<std::vector<std::size_t>> result(polygons_.size());
    std::vector<std::size_t> open;
    for (const std::size_t next : order) {
      const Aabb<2, double>& box = polygons_[next].box;
      std::erase_if(open, [&](std::size_t i) { return polygons_[i].box.max.x + tolerance_ < box.min.x; });
      for (const std::size_t other : open) {
        const Aabb<2, double>& its = polygons_[other].box;
        if (its.min.y > box.max.y + tolerance_ || its.max.y + tolerance_ < box.min.y) continue;
        result[next].push_back(other);
        result[other].push_back(next);
      }
      open.push_back(next);
    }
    return result;
  }

  /// True if two edges are collinear, as far as the shorter one tells.
  bool on_one_line(const RimEdge& a, const RimEdge& b) const {
    const auto lies_on = [this](const RimEdge& edge, const RimEdge& line) {
      return std::fabs(line.height(edge.start)) <= tolerance_ && std::fabs(line.height(edge.end)) <= tolerance_;
    };
    return lies_on(a, b) || lies_on(b, a);
  }

  /// The part of an edge that a polygon hides: what lies inside, or on an edge from the other side. Of two edges in the
  /// same direction one is hidden, by the polygon that `comes_first`.
  std::optional<Interval> hidden(const RimEdge& edge, const RimPolygon& by, bool comes_first) const {
    Interval part{0, 1};
    for (const RimEdge& side : by.edges) {
      if (on_one_line(edge, side)) {
        if (dot(edge.outward, side.outward) > 0 && !comes_first) return std::nullopt;
        continue;
      }
      const double start = side.height(edge.start);
      const double end = side.height(edge.end);
      if (start >= 0 && end >= 0) return std::nullopt;
      // They have opposite signs if one is positive, so their difference is not zero.
      if (start > 0) part.from = std::max(part.from, start / (start - end));
      if (end > 0) part.to = std::min(part.to, start / (start - end));
    }
    if (!(part.from < part.to)) return std::nullopt;
    return part;
  }

  /// Keeps the pieces of an edge that no other polygon hides.
  void keep_bare(const RimEdge& edge, std::size_t own, std::span<const std::size_t> others) {
    std::vector<Interval> parts;
    for (const std::size_t other : others) {
      if (const auto part = hidden(edge, polygons_[other], other < own)) parts.push_back(*part);
    }
    std::sort(parts.begin(), parts.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
    parts.push_back({1, 1});
    const auto at = [&edge](double t) {
      if (t == 0 || t == 1) return t == 0 ? edge.start : edge.end;
      return edge.start + (edge.end - edge.start) * t;
    };
    double bare_from = 0;
    for (const Interval& part : parts) {
      if (part.from > bare_from) keep(at(bare_from), at(part.from));
      bare_from = std::max(bare_from, part.to);
    }
  }

  void keep(const Vec<2, double>& start, const Vec<2, double>& end) {
    const std::size_t from = place_of(start);
    const std::size_t to = place_of(end);
    if (from != to) next_[from].push_back(to);
  }

  /// The index of a point; the same for points that nearly coincide. A cell contains at most one point.
  std::size_t place_of(const Vec<2, double>& point) {
    const double step = tolerance_ * crossing_slack;
    const Vec<2, double> cell = point / step;
    for (const double x : {std::floor(cell.x - 0.5), std::floor(cell.x + 0.5)}) {
      for (const double y : {std::floor(cell.y - 0.5), std::floor(cell.y + 0.5)}) {
        const auto found = places_.find({x, y});
        if (found == places_.end()) continue;
        if (max_abs(points_[found->second] - point) <= step) return found->second;
      }
    }
    const std::size_t place = points_.size();
    places_[{std::floor(cell.x), std::floor(cell.y)}] = place;
    points_.push_back(point);
    next_.emplace_back();
    return place;
  }

  /// At every point as many pieces end as start, so a path that follows them returns to its start.
  std::vector<Polygon> joined() {
    std::vector<Polygon> loops;
    for (std::size_t first = 0; first < points_.size(); ++first) {
      while (!next_[first].empty()) {
        Polygon loop;
        for (std::size_t at = first; !next_[at].empty() && (at != first || loop.empty());) {
          loop.push_back(points_[at]);
          const std::size_t to = next_[at].back();
          next_[at].pop_back();
          at = to;
        }
        if (loop.size() > 2) loops.push_back(std::move(loop));
      }
    }
    return loops;
  }

  double tolerance_ = 0;
  std::vector<RimPolygon> polygons_;
  std::vector<Vec<2, double>> points_;
  std::map<std::pair<double, double>, std::size_t> places_;
  std::vector<std::vector<std::size_t>> next_;  ///< For each point, the points to which a piece leads.
};

}  // namespace detail

/// The outline of the union of convex polygons, each given by its corners in either orientation. Returns closed loops,
/// outer ones counter-clockwise (y up) and those around holes clockwise, without the edges that two polygons share;
/// filled by the nonzero rule they show the union. Intended for pictures: exact to `picture_resolution` of the total
/// size, and narrower gaps are closed. Polygons of fewer than three corners are ignored; coordinates must be finite.
/// Time grows with the number of pairs of polygons whose boxes overlap.
inline std::vector<std::vector<Vec<2, double>>> union_outline(std::span<const std::vector<Vec<2, double>>> polygons) {
  return detail::UnionOutline(polygons).loops();
}

}  // namespace graze
