// SPDX-License-Identifier: MIT
// patch.hpp for polytopes, which know their corners, but in space not their faces.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/inplace_vector.hpp>
#include <graze/query/patch.hpp>
#include <graze/query/surface_point.hpp>
#include <graze/shape/lexicographic.hpp>
#include <graze/shape/monotone_chain.hpp>
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

/// A corner of a polytope as it lies on a face, seen flat.
struct FlatCorner {
  Vec<2, double> place;
  std::uint32_t index;
};

/// The corners of the convex hull of any number of points of a plane, which are put in one by one, counter-clockwise.
/// Of more than it can list those that are farthest in eight directions, so that a face of a thousand corners needs no
/// more memory: 10 KiB on the stack.
class FaceCorners {
 public:
  static constexpr std::size_t most_listed = 128;
  using List = InplaceVector<FlatCorner, most_listed + 1>;

  void add(const FlatCorner& corner) {
    if (listed_.size() < most_listed) {
      listed_.push_back(corner);
      return;
    }
    if (farthest_.empty()) {
      for (std::size_t i = 0; i < directions.size(); ++i) farthest_.push_back(listed_[0]);
      for (const FlatCorner& earlier : listed_) offer(earlier);
    }
    offer(corner);
  }

  List around() {
    if (!farthest_.empty()) return farthest_around();
    std::sort(listed_.begin(), listed_.end(), [](const FlatCorner& p, const FlatCorner& q) {
      return lexicographically_less<2, double>(p.place, q.place);
    });
    return monotone_chain(listed_, &FlatCorner::place);
  }

 private:
  /// Eighths of a turn; how long they are does not matter.
  static constexpr std::array<std::array<double, 2>, Patch<3>::most_corners> directions = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

  void offer(const FlatCorner& corner) {
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Vec<2, double> way = corner.place - farthest_[i].place;
      if (directions[i][0] * way.x + directions[i][1] * way.y > 0) farthest_[i] = corner;
    }
  }

  List farthest_around() const {
    List corners;
    for (const FlatCorner& corner : farthest_) {
      const auto is_same = [&](const FlatCorner& other) { return other.index == corner.index; };
      if (std::none_of(corners.begin(), corners.end(), is_same)) corners.push_back(corner);
    }
    return corners;
  }

  List listed_;
  InplaceVector<FlatCorner, directions.size()> farthest_;
};

/// Finds a face by wrapping: a plane laid on the corner that is farthest along a direction is tilted as little as it
/// takes to lie on a second one, then about the edge between the two, until it lies on a third (Chand and Kapur, "An
/// algorithm for convex polytopes", 1970).
template <class T>
class FaceWrapping {
 public:
  using Point = Vec<3, double>;

  /// Of points seen from `origin`.
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

  /// Of all other corners the one towards which the plane tilts least; the first corner itself if there is none.
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

  /// To whichever side of the edge needs the smaller tilt. What lies on the edge's line, up to rounding, is no side.
  std::size_t third_corner(const Point& edge) const {
    const Point level = unit_or(up_ - edge * (dot(up_, edge) / dot(edge, edge)), up_);
    const Point side = unit_or(cross(level, edge), Point(0.0));
    return least_tilt([&](const Point& w) {
      const double beside = std::fabs(dot(side, w));
      if (beside <= tolerance::convex * size_) return std::numeric_limits<double>::infinity();
      return -dot(level, w) / beside;
    });
  }

  std::uint32_t edge_number(std::size_t i, std::size_t j) const {
    return number(std::min(i, j) * vertices_.size() + std::max(i, j));
  }

  Patch<3> edge_patch(std::size_t i, std::size_t j) const {
    Patch<3> patch;
    patch.face = edge_number(i, j);
    patch.add(point(std::min(i, j)), number(std::min(i, j)), patch.face);
    patch.add(point(std::max(i, j)), number(std::max(i, j)), patch.face);
    return patch;
  }

  /// All corners on the face, in order around it. Corners of what is meant to be one face may be off by the rounding of
  /// their coordinates.
  Patch<3> face_patch(const Point& normal, const Point& edge) const {
    const Point x = unit_or(edge, Point(0.0));
    const Point y = cross(normal, x);
    FaceCorners corners;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const Point w = point(i) - from_;
      if (std::fabs(dot(normal, w)) <= tolerance::aligned * size_) corners.add({{dot(x, w), dot(y, w)}, number(i)});
    }
    const auto around = corners.around();
    Patch<3> patch;
    patch.normal = normal;
    const std::size_t count = std::min(around.size(), Patch<3>::most_corners);
    const auto chosen = [&](std::size_t i) { return around[i % count * around.size() / count].index; };
    for (std::size_t i = 0; i < count; ++i) {
      patch.add(point(chosen(i)), chosen(i), edge_number(chosen(i), chosen(i + 1)));
    }
    patch.face = *std::min_element(patch.vertices.begin(), patch.vertices.begin() + patch.size);
    return patch;
  }

  std::span<const Vec<3, T>> vertices_;
  Point origin_;
  Point up_;
  Point from_;  // the first corner
  std::size_t first_ = 0;
  double size_ = 0;
};

/// Of faces with more than eight corners, eight of them: evenly counted around the face; of more than 128 corners,
/// those that are farthest in eight directions.
template <class T>
Patch<3> patch_of_polytope(const Polytope<3, T>& polytope, const Vec<3, double>& origin,
                           const Vec<3, double>& direction) {
  return FaceWrapping<T>(polytope.vertices(), origin, direction).run();
}

}  // namespace graze::detail
