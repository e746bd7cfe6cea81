// SPDX-License-Identifier: MIT
// A small convex hull around the origin that grows point by point, and provides its face nearest to the origin.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include <graze/math/orientation.hpp>
#include <graze/math/orientation_3d.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/inplace_vector.hpp>
#include <graze/shape/hull/lexicographic.hpp>
#include <graze/shape/hull/monotone_chain.hpp>

namespace graze::detail {

/// An orthonormal basis that grows by one direction at a time.
template <Dim N>
class Frame {
 public:
  bool is_full() const { return size_ == N; }

  /// Adds the component of `direction` perpendicular to the span so far; false if that is not longer than `least`.
  bool add(Vec<N, double> direction, double least) {
    for (Dim i = 0; i < size_; ++i) direction -= axes_[i] * dot(axes_[i], direction);
    const double size = std::sqrt(dot(direction, direction));
    if (is_full() || !(size > least)) return false;
    axes_[size_++] = direction / size;
    return true;
  }

  /// A unit vector perpendicular to the span, which must not be full.
  Vec<N, double> across() const {
    if (size_ == 0) return unit_axis<N>(0);
    if constexpr (N == 2) {
      return perpendicular(axes_[0]);
    } else {
      if (size_ == 2) return normalized(cross(axes_[0], axes_[1]));
      Dim least = 0;  // the coordinate axis farthest from parallel
      for (Dim i = 1; i < N; ++i) {
        if (std::fabs(axes_[0][i]) < std::fabs(axes_[0][least])) least = i;
      }
      return normalized(cross(axes_[0], unit_axis<N>(least)));
    }
  }

 private:
  static Vec<N, double> normalized(const Vec<N, double>& v) { return v / std::sqrt(dot(v, v)); }

  Mat<N, double> axes_ = Mat<N, double>(0.0);
  Dim size_ = 0;
};

/// A face relative to the origin: the plane dot(normal, x) = height, with an outward unit normal. A face too thin to
/// have a normal has infinite height.
template <Dim N>
struct HullFace {
  std::array<std::uint16_t, static_cast<std::size_t>(N)> corners;
  Vec<N, double> normal;
  double height;
  double slack = 0;         ///< Error bound of heights over the plane, relative to the largest coordinate.
  bool is_settled = false;  ///< No longer a candidate for the nearest face, whatever its height.
};

/// The corners of a face, in 3D counter-clockwise from outside.
template <Dim N>
using HullFaceCorners = std::array<Vec<N, double>, static_cast<std::size_t>(N)>;

/// How many points a hull may start with (asserted), and how many more may be added.
template <Dim N>
inline constexpr std::size_t most_hull_starts = 3 * static_cast<std::size_t>(N) + 1;
inline constexpr std::size_t most_hull_inserts = 128;

template <Dim N>
using HullPoints = InplaceVector<Vec<N, double>, most_hull_starts<N> + most_hull_inserts>;

/// Starts with a few points and grows by others, within these limits. Which faces a point lies beyond is decided
/// exactly, so that no face turns inside out, however thin. Does not allocate: in 2D it takes 4 KiB of the stack, in 3D
/// 22 KiB while it grows.
template <Dim N>
class GrowingHull;

/// In 2D: a polygon, counter-clockwise from its first corner by coordinates.
template <>
class GrowingHull<2> {
 public:
  using Point = Vec<2, double>;

  /// The hull of points that are not all collinear.
  explicit GrowingHull(std::span<const Point> points) {
    assert(points.size() <= most_hull_starts<2>);
    HullPoints<2> sorted(points);
    std::sort(sorted.begin(), sorted.end(), lexicographically_less<2, double>);
    sorted.end_at(std::unique(sorted.begin(), sorted.end()));
    corners_ = monotone_chain(sorted);
  }

  /// The largest coordinate.
  double size() const {
    double size = 0;
    for (const Point& corner : corners_) size = std::max(size, max_abs(corner));
    return size;
  }

  /// None if every face is settled, or there is none.
  std::optional<HullFace<2>> nearest_face() const {
    if (corners_.size() < 3) return std::nullopt;
    HullFace<2> nearest{{}, Point(0.0), std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (is_settled(i)) continue;
      const Point edge = corners_[next(i)] - corners_[i];
      const Point normal = -perpendicular(edge) / std::sqrt(dot(edge, edge));  // corners are distinct
      const double height = dot(normal, corners_[i]);
      if (height < nearest.height) nearest = {{number(i), number(next(i))}, normal, height};
    }
    if (nearest.height == std::numeric_limits<double>::infinity()) return std::nullopt;
    return nearest;
  }

  HullFaceCorners<2> corners_of(const HullFace<2>& face) const {
    return {corners_[face.corners[0]], corners_[face.corners[1]]};
  }

  /// Excludes the face from the search for the nearest one. False if there is no room to record another.
  bool settle(const HullFace<2>& face) {
    if (settled_.is_full()) return false;
    settled_.push_back(corners_of(face));
    return true;
  }

  /// Adds a point beyond a face; false when it lies in the hull, or there is no more room. In place of the corners
  /// between the edges that it can see, and those on whose line it lies, which are all in one row.
  bool insert(const Point& point, const HullFace<2>&) {
    const auto is_beyond = [&](std::size_t i) { return side(i, point) < 0; };
    const auto is_inside = [&](std::size_t i) { return side(i, point) > 0; };
    const std::size_t count = corners_.size();
    std::size_t first = 0;
    while (first < count && !is_beyond(first)) ++first;
    if (first == count || corners_.is_full()) return false;
    std::size_t last = first;
    while (!is_inside(next(last)) && next(last) != first) last = next(last);
    while (!is_inside(previous(first)) && previous(first) != last) first = previous(first);
    HullPoints<2> around;
    around.push_back(point);
    for (std::size_t i = next(last); i != first; i = next(i)) around.push_back(corners_[i]);
    around.push_back(corners_[first]);
    std::rotate(around.begin(), std::min_element(around.begin(), around.end(), lexicographically_less<2, double>),
                around.end());
    corners_ = around;
    return true;
  }

 private:
  static std::uint16_t number(std::size_t i) { return static_cast<std::uint16_t>(i); }
  std::size_t next(std::size_t i) const { return i + 1 < corners_.size() ? i + 1 : 0; }
  std::size_t previous(std::size_t i) const { return i > 0 ? i - 1 : corners_.size() - 1; }

  /// For the edge from corner i on: 1 on the inner side, -1 beyond, 0 on its line.
  int side(std::size_t i, const Point& point) const { return orientation(corners_[i], corners_[next(i)], point); }

  bool is_settled(std::size_t i) const {
    return std::find(settled_.begin(), settled_.end(), HullFaceCorners<2>{corners_[i], corners_[next(i)]}) !=
           settled_.end();
  }

  HullPoints<2> corners_;
  InplaceVector<HullFaceCorners<2>, 8> settled_;
};

/// In 3D: triangles, corners counter-clockwise from outside.
template <>
class GrowingHull<3> {
 public:
  using Point = Vec<3, double>;

  /// The hull of points that are not all coplanar.
  explicit GrowingHull(std::span<const Point> points) : points_(points) {
    assert(points.size() <= most_hull_starts<3>);
    for (const Point& point : points_) size_ = std::max(size_, max_abs(point));
    scale_ = scale_to_moderate(size_);
    const auto start = largest_tetrahedron();
    if (!start) return;
    const auto [a, b, c, d] = *start;
    for (const auto& face : {std::array{a, b, c}, std::array{a, c, d}, std::array{a, d, b}, std::array{b, d, c}}) {
      add_face(face[0], face[1], face[2]);
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (i != a && i != b && i != c && i != d) grow(i);
    }
  }

  /// The largest coordinate.
  double size() const { return size_; }

  /// None if every face is settled, or too thin to have a normal.
  std::optional<HullFace<3>> nearest_face() const {
    const HullFace<3>* nearest = nullptr;
    for (const HullFace<3>& face : faces_) {
      if (!face.is_settled && (nearest == nullptr || face.height < nearest->height)) nearest = &face;
    }
    if (nearest == nullptr || nearest->height == std::numeric_limits<double>::infinity()) return std::nullopt;
    return *nearest;
  }

  HullFaceCorners<3> corners_of(const HullFace<3>& face) const {
    return {points_[face.corners[0]], points_[face.corners[1]], points_[face.corners[2]]};
  }

  /// Excludes the face from the search for the nearest one.
  bool settle(const HullFace<3>& settled) {
    for (HullFace<3>& face : faces_) face.is_settled = face.is_settled || face.corners == settled.corners;
    return true;
  }

  /// Adds a point beyond a face; false when it is not new, no face sees it, or there is no more room.
  bool insert(const Point& point, const HullFace<3>&) {
    if (std::find(points_.begin(), points_.end(), point) != points_.end() || points_.is_full()) return false;
    points_.push_back(point);
    size_ = std::max(size_, max_abs(point));
    return grow(points_.size() - 1);
  }

 private:
  using Corner = std::uint16_t;

  /// The side of a face from one corner to the next.
  struct Edge {
    Corner from;
    Corner to;

    friend bool operator==(const Edge&, const Edge&) = default;
  };

  /// The number of triangles in a closed surface.
  static constexpr std::size_t most_faces = 2 * (most_hull_starts<3> + most_hull_inserts) - 4;
  using Edges = InplaceVector<Edge, 3 * most_faces>;

  /// The four points with the largest volume, the last one behind the first three.
  std::optional<std::array<std::size_t, 4>> largest_tetrahedron() const {
    std::optional<std::array<std::size_t, 4>> best;
    double largest = 0;
    const std::size_t count = points_.size();
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = a + 1; b < count; ++b) {
        for (std::size_t c = b + 1; c < count; ++c) {
          const Point normal = cross((points_[b] - points_[a]) * scale_, (points_[c] - points_[a]) * scale_);
          for (std::size_t d = c + 1; d < count; ++d) {
            const double volume = dot(normal, (points_[d] - points_[a]) * scale_);
            if (!(std::fabs(volume) > largest)) continue;
            const int side = side_of({a, b, c}, d);
            if (side == 0) continue;
            largest = std::fabs(volume);
            best = side < 0 ? std::array{a, b, c, d} : std::array{a, c, b, d};
          }
        }
      }
    }
    return best;
  }

  /// The exact side of the plane through three points on which a fourth lies: 1 if the three appear counter-clockwise
  /// from there, -1 if clockwise, 0 if it is on the plane.
  int side_of(const std::array<std::size_t, 3>& plane, std::size_t point) const {
    const auto at = [this](std::size_t i) { return points_[i] * scale_; };
    return orientation(at(plane[0]), at(plane[1]), at(plane[2]), at(point));
  }

  /// The normal of a triangle with two sides u and v: by plain products where these lose a few bits at most, in twofold
  /// precision for thin triangles, whose products nearly cancel.
  void add_face(std::size_t a, std::size_t b, std::size_t c) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double least_sine_squared = 1.0 / 64;
    constexpr double least = 0x1p-900;
    const auto number = [](std::size_t i) { return static_cast<Corner>(i); };
    HullFace<3> face{{number(a), number(b), number(c)}, Point(0.0), infinity, infinity};
    const Point u = (points_[b] - points_[a]) * scale_;
    const Point v = (points_[c] - points_[a]) * scale_;
    const double most_squared = dot(u, u) * dot(v, v);
    Point normal = cross(u, v);
    double squared = dot(normal, normal);
    if (!(most_squared > least && squared > least_sine_squared * most_squared)) {
      normal = accurate_cross(u, v);
      squared = dot(normal, normal);
    }
    if (squared > 0) {
      face.normal = normal / std::sqrt(squared);
      face.height =
          std::max({dot(face.normal, points_[a]), dot(face.normal, points_[b]), dot(face.normal, points_[c])});
      face.slack = tolerance::growing_hull * (1 + std::sqrt(most_squared / squared));
    }
    faces_.push_back(face);
  }

  bool is_seen(const HullFace<3>& face, std::size_t point) const {
    const double over = dot(face.normal, points_[point]) - face.height;
    if (std::fabs(over) > face.slack * size_) return over > 0;
    return side_of({face.corners[0], face.corners[1], face.corners[2]}, point) > 0;
  }

  /// Replaces the faces that a new point can see by a cone of faces from their rim to the point. The rim is made of the
  /// edges of seen faces whose other side is not seen.
  bool grow(std::size_t added) {
    const auto is_visible = [&](const HullFace<3>& face) { return is_seen(face, added); };
    HullFace<3>* kept = std::find_if(faces_.begin(), faces_.end(), is_visible);
    if (kept == faces_.end()) return false;
    Edges edges;
    for (const HullFace<3>* face = kept; face != faces_.end(); ++face) {
      if (is_visible(*face)) {
        for (std::size_t i = 0; i < 3; ++i) edges.push_back({face->corners[i], face->corners[(i + 1) % 3]});
      } else {
        *kept++ = *face;
      }
    }
    faces_.end_at(kept);
    for (const Edge& edge : edges) {
      const bool is_inner = std::find(edges.begin(), edges.end(), Edge{edge.to, edge.from}) != edges.end();
      if (is_inner) continue;
      if (faces_.is_full()) return false;
      add_face(edge.from, edge.to, added);
    }
    return true;
  }

  HullPoints<3> points_;
  double size_ = 0;   ///< The largest coordinate.
  double scale_ = 1;  ///< The power of two that scales it to about 1.
  InplaceVector<HullFace<3>, most_faces> faces_;
};

}  // namespace graze::detail
