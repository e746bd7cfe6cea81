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
#include <graze/math/rounding.hpp>
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
};

/// How many points a hull may start with (asserted), and how many more may be added.
template <Dim N>
inline constexpr std::size_t most_hull_starts = 3 * static_cast<std::size_t>(N) + 1;
inline constexpr std::size_t most_hull_inserts = 128;

template <Dim N>
using HullPoints = InplaceVector<Vec<N, double>, most_hull_starts<N> + most_hull_inserts>;

/// Starts with a few points and grows by others, within these limits. Does not allocate: in 2D it takes 4 KiB of the
/// stack, in 3D 18 KiB while it grows.
template <Dim N>
class GrowingHull;

/// 2D: a polygon, counter-clockwise from its first corner by coordinates.
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

  std::optional<HullFace<2>> nearest_face() const {
    if (corners_.size() < 3) return std::nullopt;
    HullFace<2> nearest{{}, Point(0.0), std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Point edge = corners_[next(i)] - corners_[i];
      const Point normal = -perpendicular(edge) / std::sqrt(dot(edge, edge));  // corners are distinct
      const double height = dot(normal, corners_[i]);
      if (height < nearest.height) nearest = {{number(i), number(next(i))}, normal, height};
    }
    return nearest;
  }

  /// Adds a point beyond a face; false if it is in the hull, or the hull is full. It replaces the corners between the
  /// edges that it sees, and those on whose line it is, which are consecutive.
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

  HullPoints<2> corners_;
};

/// 3D: triangles, corners counter-clockwise as seen from outside.
template <>
class GrowingHull<3> {
 public:
  using Point = Vec<3, double>;

  /// The hull of points that are not all coplanar.
  explicit GrowingHull(std::span<const Point> points) : points_(points) {
    assert(points.size() <= most_hull_starts<3>);
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

  /// None if every face is too thin to have a normal.
  std::optional<HullFace<3>> nearest_face() const {
    const HullFace<3>* nearest = std::min_element(faces_.begin(), faces_.end(),
                                                  [](const auto& a, const auto& b) { return a.height < b.height; });
    if (nearest == faces_.end() || nearest->height == std::numeric_limits<double>::infinity()) return std::nullopt;
    return *nearest;
  }

  /// Adds a point beyond a face; false if it is not new, no face sees it, or the hull is full.
  bool insert(const Point& point, const HullFace<3>&) {
    if (std::find(points_.begin(), points_.end(), point) != points_.end() || points_.is_full()) return false;
    points_.push_back(point);
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
    double size = 0;
    for (const Point& point : points_) size = std::max(size, max_abs(point));
    const double scale = scale_to_moderate(size);
    const std::size_t count = points_.size();
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = a + 1; b < count; ++b) {
        for (std::size_t c = b + 1; c < count; ++c) {
          const Point normal = cross((points_[b] - points_[a]) * scale, (points_[c] - points_[a]) * scale);
          for (std::size_t d = c + 1; d < count; ++d) {
            const double volume = dot(normal, (points_[d] - points_[a]) * scale);
            if (!(std::fabs(volume) > largest)) continue;
            largest = std::fabs(volume);
            best = volume < 0 ? std::array{a, b, c, d} : std::array{a, c, b, d};
          }
        }
      }
    }
    return best;
  }

  /// By plain products if these lose a few bits at most; for thin triangles, whose products nearly cancel, accurately.
  static Point cross_of_sides(const Point& u, const Point& v) {
    constexpr double least_sine_squared = 1.0 / 64;
    const Point plain = cross(u, v);
    const double most = least_sine_squared * dot(u, u) * dot(v, v);
    constexpr double least = 0x1p-900;
    return most > least && dot(plain, plain) > most ? plain : accurate_cross(u, v);
  }

  void add_face(std::size_t a, std::size_t b, std::size_t c) {
    const auto number = [](std::size_t i) { return static_cast<Corner>(i); };
    HullFace<3> face{{number(a), number(b), number(c)}, Point(0.0), std::numeric_limits<double>::infinity()};
    const Point normal = of_moderate_size(cross_of_sides(points_[b] - points_[a], points_[c] - points_[a]));
    const double size = std::sqrt(dot(normal, normal));
    if (size > 0) {
      face.normal = normal / size;
      face.height =
          std::max({dot(face.normal, points_[a]), dot(face.normal, points_[b]), dot(face.normal, points_[c])});
    }
    faces_.push_back(face);
  }

  /// Replaces the faces that see a new point by a cone of faces from the horizon to the point. The horizon consists of
  /// the edges of visible faces whose other side is not visible.
  bool grow(std::size_t added) {
    const auto is_seen = [&](const HullFace<3>& face) { return dot(face.normal, points_[added]) > face.height; };
    HullFace<3>* kept = std::find_if(faces_.begin(), faces_.end(), is_seen);
    if (kept == faces_.end()) return false;
    Edges edges;
    for (const HullFace<3>* face = kept; face != faces_.end(); ++face) {
      if (is_seen(*face)) {
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
  InplaceVector<HullFace<3>, most_faces> faces_;
};

}  // namespace graze::detail
