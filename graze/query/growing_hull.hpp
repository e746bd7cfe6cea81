// SPDX-License-Identifier: MIT
// A small convex hull around the origin that grows point by point, and knows its face nearest to the origin.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/lexicographic.hpp>
#include <graze/shape/monotone_chain.hpp>

namespace graze::detail {

/// An orthonormal basis that grows by one direction at a time.
template <Dim N>
class Frame {
 public:
  bool is_full() const { return size_ == N; }

  /// Adds what `direction` has beside the span so far; false if that is not longer than `least`.
  bool add(Vec<N, double> direction, double least) {
    for (Dim i = 0; i < size_; ++i) direction -= axes_[i] * dot(axes_[i], direction);
    const double size = std::sqrt(dot(direction, direction));
    if (is_full() || !(size > least)) return false;
    axes_[size_++] = direction / size;
    return true;
  }

  /// A unit vector at right angles to the span, which must not be full.
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

/// A face seen from the origin: the plane dot(normal, x) = height, normal outward and of length one.
template <Dim N>
struct HullFace {
  std::array<std::uint32_t, static_cast<std::size_t>(N)> corners;
  Vec<N, double> normal;
  double height = std::numeric_limits<double>::infinity();
};

template <Dim N>
class GrowingHull;

/// In the plane: a polygon, counter-clockwise.
template <>
class GrowingHull<2> {
 public:
  using Point = Vec<2, double>;

  /// The hull of points that do not all lie on one line.
  explicit GrowingHull(std::vector<Point> points) {
    std::sort(points.begin(), points.end(), lexicographically_less<2, double>);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    corners_ = monotone_chain(points);
  }

  std::optional<HullFace<2>> nearest_face() const {
    HullFace<2> nearest;
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
      const std::uint32_t next = i + 1 < corners_.size() ? i + 1 : 0;
      const Point edge = corners_[next] - corners_[i];
      const Point normal = -perpendicular(edge) / std::sqrt(dot(edge, edge));  // corners are distinct
      const double height = dot(normal, corners_[i]);
      if (height < nearest.height) nearest = {{i, next}, normal, height};
    }
    if (corners_.size() < 3) return std::nullopt;
    return nearest;
  }

  /// Adds a point beyond a face; false when it is not new.
  bool insert(const Point& point, const HullFace<2>&) {
    const std::size_t before = corners_.size();
    std::vector<Point> points = corners_;
    points.push_back(point);
    GrowingHull<2> grown(std::move(points));
    const bool is_new = std::find(corners_.begin(), corners_.end(), point) == corners_.end();
    corners_ = std::move(grown.corners_);
    return is_new && (corners_.size() > before || std::find(corners_.begin(), corners_.end(), point) != corners_.end());
  }

 private:
  std::vector<Point> corners_;
};

/// In space: triangles, corners counter-clockwise from outside.
template <>
class GrowingHull<3> {
 public:
  using Point = Vec<3, double>;

  /// The hull of points that do not all lie in one plane.
  explicit GrowingHull(std::vector<Point> points) : points_(std::move(points)) {
    const auto start = largest_tetrahedron();
    if (!start) return;
    const auto [a, b, c, d] = *start;
    for (const auto& face : {std::array{a, b, c}, std::array{a, c, d}, std::array{a, d, b}, std::array{b, d, c}}) {
      add_face(face[0], face[1], face[2]);
    }
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (i != a && i != b && i != c && i != d) grow(i);
    }
  }

  /// None when every face is too thin to have a normal.
  std::optional<HullFace<3>> nearest_face() const {
    const auto nearest = std::min_element(faces_.begin(), faces_.end(),
                                          [](const auto& a, const auto& b) { return a.height < b.height; });
    if (nearest == faces_.end() || nearest->height == std::numeric_limits<double>::infinity()) return std::nullopt;
    return *nearest;
  }

  /// Adds a point beyond a face; false when it is not new or no face sees it.
  bool insert(const Point& point, const HullFace<3>&) {
    if (std::find(points_.begin(), points_.end(), point) != points_.end()) return false;
    points_.push_back(point);
    return grow(static_cast<std::uint32_t>(points_.size() - 1));
  }

 private:
  /// Four points of the largest volume, the last one behind the first three.
  std::optional<std::array<std::uint32_t, 4>> largest_tetrahedron() const {
    std::optional<std::array<std::uint32_t, 4>> best;
    double largest = 0;
    double size = 0;
    for (const Point& point : points_) size = std::max(size, max_abs(point));
    const double scale = scale_to_moderate(size);
    const auto count = static_cast<std::uint32_t>(points_.size());
    for (std::uint32_t a = 0; a < count; ++a) {
      for (std::uint32_t b = a + 1; b < count; ++b) {
        for (std::uint32_t c = b + 1; c < count; ++c) {
          const Point normal = cross((points_[b] - points_[a]) * scale, (points_[c] - points_[a]) * scale);
          for (std::uint32_t d = c + 1; d < count; ++d) {
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

  void add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    HullFace<3> face{{a, b, c}, Point(0.0)};
    const Point normal = of_moderate_size(accurate_cross(points_[b] - points_[a], points_[c] - points_[a]));
    const double size = std::sqrt(dot(normal, normal));
    if (size > 0) {
      face.normal = normal / size;
      face.height =
          std::max({dot(face.normal, points_[a]), dot(face.normal, points_[b]), dot(face.normal, points_[c])});
    }
    faces_.push_back(face);
  }

  /// Replaces the faces that a new point can see by a cone of faces from their rim to the point. The rim is made of the
  /// edges of seen faces whose other side is not seen.
  bool grow(std::uint32_t added) {
    const auto is_seen = [&](const HullFace<3>& face) { return dot(face.normal, points_[added]) > face.height; };
    const auto seen =
        std::stable_partition(faces_.begin(), faces_.end(), [&](const auto& face) { return !is_seen(face); });
    if (seen == faces_.end()) return false;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (auto face = seen; face != faces_.end(); ++face) {
      for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(face->corners[i], face->corners[(i + 1) % 3]);
    }
    faces_.erase(seen, faces_.end());
    for (const auto& [from, to] : edges) {
      const bool is_inner = std::find(edges.begin(), edges.end(), std::pair{to, from}) != edges.end();
      if (!is_inner) add_face(from, to, added);
    }
    return true;
  }

  std::vector<Point> points_;
  std::vector<HullFace<3>> faces_;
};

}  // namespace graze::detail
