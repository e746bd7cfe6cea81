// SPDX-License-Identifier: MIT
// patch.hpp for polytopes, which store their corners but, in 3D, not their faces.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/inplace_vector.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/patch/patch.hpp>
#include <graze/shape/hull/lexicographic.hpp>
#include <graze/shape/hull/monotone_chain.hpp>
#include <graze/shape/polytope.hpp>

namespace graze::detail {

template <class T>
Patch<2> patch_of_polytope(const Polytope<2, T>& polytope, const Vec<2, double>& origin,
                           const Vec<2, double>& direction) {
  const auto vertices = polytope.vertices();
  if (vertices.size() == 1) return patch_of(wide<2, T>(vertices[0]) - origin, direction);
  const auto corner = [&](std::size_t i) { return wide<2, T>(vertices[i]) - origin; };
  return PolygonEdges(vertices.size(), corner).along(direction);
}

/// A corner of a polytope, projected onto the plane of a face.
struct PolygonCorner {
  Vec<2, double> place;
  std::uint32_t index;
};

/// The corners of the convex hull of any number of points in a plane, added one by one in the order of their numbers:
/// counter-clockwise from the least number. Corners next to each other, up to `reach`, are merged into the one with the
/// least number, and corners that hardly turn are removed, so that rounding neither adds nor hides any. If there are
/// more than fit, only those farthest in eight directions, so that a face with a thousand corners needs no more memory:
/// 20 KiB on the stack.
class FaceCorners {
 public:
  static constexpr std::size_t most_listed = 128;
  using List = InplaceVector<PolygonCorner, most_listed + 1>;

  explicit FaceCorners(double reach) : reach_(reach) {}

  void add(const PolygonCorner& corner) {
    if (listed_.size() < most_listed) {
      listed_.push_back(corner);
      return;
    }
    if (farthest_.empty()) {
      for (std::size_t i = 0; i < directions.size(); ++i) farthest_.push_back(listed_[0]);
      for (const PolygonCorner& earlier : listed_) offer(earlier);
    }
    offer(corner);
  }

  List around() {
    List corners = farthest_.empty() ? listed_around() : farthest_around();
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), has_less_number), corners.end());
    return corners;
  }

 private:
  /// Directions at multiples of 45 degrees; their lengths do not matter.
  static constexpr std::array<std::array<double, 2>, Patch<3>::most_corners> directions = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

  static bool has_less_number(const PolygonCorner& a, const PolygonCorner& b) { return a.index < b.index; }

  bool are_beside(const PolygonCorner& a, const PolygonCorner& b) const { return sum_abs(b.place - a.place) <= reach_; }

  static bool hardly_turns(const PolygonCorner& before, const PolygonCorner& corner, const PolygonCorner& after) {
    const Vec<2, double> way_in = unit_or(corner.place - before.place, Vec<2, double>(0.0));
    const Vec<2, double> minimum_translation = unit_or(after.place - corner.place, Vec<2, double>(0.0));
    return dot(way_in, minimum_translation) > 0 &&
           std::fabs(cross_2d<double>(way_in, minimum_translation)) <= tolerance::aligned;
  }

  /// Of equally good corners, up to `reach`, the first.
  void offer(const PolygonCorner& corner) {
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Vec<2, double> way = corner.place - farthest_[i].place;
      if (directions[i][0] * way.x + directions[i][1] * way.y > reach_) farthest_[i] = corner;
    }
  }

  List listed_around() {
    std::sort(listed_.begin(), listed_.end(), [](const PolygonCorner& p, const PolygonCorner& q) {
      return p.place == q.place ? p.index < q.index : lexicographically_less<2, double>(p.place, q.place);
    });
    const auto is_same_place = [](const PolygonCorner& p, const PolygonCorner& q) { return p.place == q.place; };
    listed_.end_at(std::unique(listed_.begin(), listed_.end(), is_same_place));
    const List all = monotone_chain(listed_, &PolygonCorner::place);
    const List turning = those_that_turn(those_apart(all));
    return turning.size() < 3 ? all : turning;
  }

  List those_apart(const List& all) const {
    List kept;
    for (const PolygonCorner& corner : all) {
      if (kept.empty() || !are_beside(kept.back(), corner)) {
        kept.push_back(corner);
      } else if (has_less_number(corner, kept.back())) {
        kept[kept.size() - 1] = corner;
      }
    }
    while (kept.size() > 1 && are_beside(kept.back(), kept[0])) {
      kept[0] = std::min(kept[0], kept.back(), has_less_number);
      kept.pop_back();
    }
    return kept;
  }

  static List those_that_turn(const List& all) {
    List kept;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const PolygonCorner& before = kept.empty() ? all.back() : kept.back();
      const PolygonCorner& after = i + 1 < all.size() ? all[i + 1] : kept.empty() ? all[0] : kept[0];
      if (!hardly_turns(before, all[i], after)) kept.push_back(all[i]);
    }
    return kept;
  }

  List farthest_around() const {
    List corners;
    for (const PolygonCorner& corner : farthest_) {
      const auto is_same = [&](const PolygonCorner& other) { return other.index == corner.index; };
      if (std::none_of(corners.begin(), corners.end(), is_same)) corners.push_back(corner);
    }
    return corners;
  }

  double reach_;
  List listed_;
  InplaceVector<PolygonCorner, directions.size()> farthest_;
};

/// Finds a face by gift wrapping: a plane through the corner farthest in a direction is tilted as little as possible
/// until it contains a second one, then about the edge between the two until it contains a third (Chand and Kapur, "An
/// algorithm for convex polytopes", 1970).
template <class T>
class FaceWrapping {
 public:
  using Point = Vec<3, double>;

  /// Points are taken relative to `origin`.
  FaceWrapping(std::span<const Vec<3, T>> vertices, const Point& origin, const Point& direction)
      : vertices_(vertices), origin_(origin), up_(direction) {
    double height = dot(up_, point(0));
    for (std::size_t i = 1; i < vertices_.size(); ++i) {
      const double candidate = dot(up_, point(i));
      if (!(candidate > height)) continue;
      height = candidate;
      first_ = i;
    }
    from_ = point(first_);
    for (std::size_t i = 0; i < vertices_.size(); ++i) size_ = std::max(size_, sum_abs(point(i) - from_));
  }

  Patch<3> run() {
    Patch<3> patch;
    const std::size_t second = least_tilt([this](const Point& w) {
      const double drop = -dot(up_, w);
      const Point level = w + up_ * drop;
      return drop / std::sqrt(dot(level, level));
    });
    if (second == first_) {
      patch.add(from_, number(first_), 0);
      return patch;
    }
    const Point edge = point(second) - from_;
    const std::size_t third = third_corner(edge);
    if (third == first_) return edge_patch(first_, second);
    const Point normal = unit_or(accurate_cross(edge, point(third) - from_), up_);
    return face_patch(dot(normal, up_) < 0 ? -normal : normal, edge);
  }

 private:
  static std::uint32_t number(std::size_t i) { return static_cast<std::uint32_t>(i); }

  Point point(std::size_t i) const { return wide<3, T>(vertices_[i]) - origin_; }

  /// Of all other corners, the one that needs the least tilt of the plane; the first corner itself if there is none.
  template <class Tilt>
  std::size_t least_tilt(const Tilt& tilt) const {
    double least = std::numeric_limits<double>::infinity();
    std::size_t best = first_;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      if (i == first_) continue;
      const double candidate = tilt(point(i) - from_);
      if (!(candidate < least)) continue;
      least = candidate;
      best = i;
    }
    return best;
  }

  /// On the side of the edge that needs the smaller tilt. Corners on the edge's line, up to rounding, are skipped.
  std::size_t third_corner(const Point& edge) const {
    const Point level = unit_or(up_ - edge * (dot(up_, edge) / dot(edge, edge)), up_);
    const Point side = unit_or(cross(level, edge), Point(0.0));
    return least_tilt([&](const Point& w) {
      const double beside = std::fabs(dot(side, w));
      if (beside <= tolerance::convex * size_) return std::numeric_limits<double>::infinity();
      return -dot(level, w) / beside;
    });
  }

  /// Of two consecutive corners.
  std::uint32_t pair_number(std::size_t i, std::size_t j) const { return number(i * vertices_.size() + j); }

  std::uint32_t edge_number(std::size_t i, std::size_t j) const { return pair_number(std::min(i, j), std::max(i, j)); }

  Patch<3> edge_patch(std::size_t i, std::size_t j) const {
    Patch<3> patch;
    patch.face = edge_number(i, j);
    patch.add(point(std::min(i, j)), number(std::min(i, j)), patch.face);
    patch.add(point(std::max(i, j)), number(std::max(i, j)), patch.face);
    return patch;
  }

  /// All corners of the face, in order around it from the least number. Corners that are meant to be coplanar may be
  /// off by the rounding of their coordinates. The face has the number of its first two corners: two faces have no more
  /// than an edge in common, which they traverse in opposite directions.
  Patch<3> face_patch(const Point& normal, const Point& edge) const {
    const Point x = way_along(normal, edge);
    const Point y = cross(normal, x);
    FaceCorners corners(reach());
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const Point w = point(i) - from_;
      if (is_on_plane(normal, w)) corners.add({{dot(x, w), dot(y, w)}, number(i)});
    }
    const auto around = corners.around();
    Patch<3> patch;
    patch.normal = normal;
    const std::size_t count = std::min(around.size(), Patch<3>::most_corners);
    const auto chosen = [&](std::size_t i) { return around[i % count * around.size() / count].index; };
    for (std::size_t i = 0; i < count; ++i) {
      patch.add(point(chosen(i)), chosen(i), edge_number(chosen(i), chosen(i + 1)));
    }
    patch.face = pair_number(chosen(0), chosen(1));
    return patch;
  }

  double reach() const { return tolerance::aligned * size_; }

  bool is_on_plane(const Point& normal, const Point& w) const { return std::fabs(dot(normal, w)) <= reach(); }

  /// From the face's least corner to the next one that is not close to it: a direction that rotates with the polytope.
  /// Along an edge if there is none.
  Point way_along(const Point& normal, const Point& edge) const {
    std::optional<Point> least;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const Point w = point(i) - from_;
      if (!is_on_plane(normal, w)) continue;
      if (!least) least = w;
      const Point way = (w - *least) - normal * dot(normal, w - *least);
      if (sum_abs(way) > reach()) return unit_or(way, Point(0.0));
    }
    return unit_or(edge, Point(0.0));
  }

  std::span<const Vec<3, T>> vertices_;
  Point origin_;
  Point up_;
  Point from_;  // the first corner
  std::size_t first_ = 0;
  double size_ = 0;
};

/// Of faces with more than eight corners, eight of them: evenly counted around the face from the least; of more than
/// 128 corners, those farthest in eight directions. The selection does not depend on the polytope's position.
template <class T>
Patch<3> patch_of_polytope(const Polytope<3, T>& polytope, const Vec<3, double>& origin,
                           const Vec<3, double>& direction) {
  return FaceWrapping<T>(polytope.vertices(), origin, direction).run();
}

}  // namespace graze::detail
