// SPDX-License-Identifier: MIT
// fitted_axes(points): the axes of a box around 3D points with a small surface area. (The minimum can be found, but
// takes cubic time: O'Rourke, 1985.)
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounding/box.hpp>
#include <graze/query/bounding/extreme_points.hpp>
#include <graze/query/bounding/flush_rectangle.hpp>
#include <graze/query/bounding/hull_corners.hpp>

namespace graze::detail {

/// An eighth of the surface area of a box from half extents; a quarter of half of it from sides. Unlike the volume it
/// distinguishes flat boxes.
inline double surface_of(const Vec<3, double>& size) { return size.x * size.y + size.y * size.z + size.z * size.x; }

using Points3 = std::span<const Vec<3, double>>;

/// The lowest and highest coordinates of points along axes.
inline Aabb<3, double> range_along(const Mat<3, double>& axes, Points3 points) {
  Aabb<3, double> range = Aabb<3, double>::nothing();
  for (const Vec<3, double>& point : points) range.grow(point * axes);
  return range;
}

inline double surface_along(const Mat<3, double>& axes, Points3 points) {
  const Aabb<3, double> range = range_along(axes, points);
  return surface_of(range.max - range.min);
}

/// Right-handed unit vectors: the first along `edge`, which is not zero, the last as close to `normal` as possible;
/// determined by rounding if the two are parallel.
inline Mat<3, double> axes_from(const Vec<3, double>& edge, const Vec<3, double>& normal) {
  const Vec<3, double> x = edge / std::sqrt(dot(edge, edge));
  const auto upright = [&x](Vec<3, double> v) {
    for (int round = 0; round < 2; ++round) v -= x * dot(x, v);
    return v;
  };
  Vec<3, double> z = upright(normal);
  if (!(dot(z, z) > 0)) z = upright(unit_axis<3>(std::fabs(x.x) < 0.5 ? 0 : 1));
  z /= std::sqrt(dot(z, z));
  return {x, cross(z, x), z};
}

/// The points farthest apart.
inline std::array<Vec<3, double>, 2> farthest_pair(Points3 points) {
  std::array<Vec<3, double>, 2> pair = {points[0], points[0]};
  for (const Vec<3, double>& a : points) {
    for (const Vec<3, double>& b : points) {
      if (length_squared(b - a) > length_squared(pair[1] - pair[0])) pair = {a, b};
    }
  }
  return pair;
}

/// The point with the largest `height(point)`.
template <class Height>
Vec<3, double> highest(Points3 points, Height height) {
  return *std::max_element(points.begin(), points.end(), [&height](const Vec<3, double>& a, const Vec<3, double>& b) {
    return height(a) < height(b);
  });
}

/// The best axes along an edge and the normal of a face of a large double tetrahedron among the points: its base is the
/// largest triangle on the pair farthest apart, its tips the farthest points on either side. Larsson and Källberg
/// (2011).
inline Mat<3, double> ditetrahedron_axes(Points3 points) {
  const auto [a, b] = farthest_pair(points);
  const Vec<3, double> line = b - a;
  const Vec<3, double> start = a;
  const Vec<3, double> c =
      highest(points, [&](const Vec<3, double>& p) { return length_squared(cross(line, p - start)); });
  const Vec<3, double> normal = cross(line, c - a);
  const Vec<3, double> top = highest(points, [&](const Vec<3, double>& p) { return dot(normal, p); });
  const Vec<3, double> bottom = highest(points, [&](const Vec<3, double>& p) { return -dot(normal, p); });
  const std::array<std::array<Vec<3, double>, 3>, 7> faces = {
      {{a, b, c}, {a, b, top}, {b, c, top}, {c, a, top}, {a, b, bottom}, {b, c, bottom}, {c, a, bottom}}};
  Mat<3, double> best = axes_from(line, normal);
  double least = surface_along(best, points);
  for (const auto& face : faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec<3, double> edge = face[(i + 1) % 3] - face[i];
      if (!(length_squared(edge) > 0)) continue;
      const Mat<3, double> axes = axes_from(edge, cross(face[1] - face[0], face[2] - face[0]));
      const double surface = surface_along(axes, points);
      if (surface < least) {
        least = surface;
        best = axes;
      }
    }
  }
  return best;
}

/// `axes` rotated about the one with index k to minimise the surface area of the box around the points.
inline Mat<3, double> turned_about(Dim k, const Mat<3, double>& axes, Points3 points) {
  const Vec<3, double> u = axes[(k + 1) % 3];
  const Vec<3, double> v = axes[(k + 2) % 3];
  std::vector<Vec<2, double>> shadow;
  shadow.reserve(points.size());
  for (const Vec<3, double>& point : points) shadow.emplace_back(dot(u, point), dot(v, point));
  shadow = sorted_chain(std::move(shadow));
  if (shadow.size() < 2) return axes;
  const Aabb<3, double> range = range_along(axes, points);
  const double depth = range.max[k] - range.min[k];
  const Vec<2, double> along =
      best_flush_direction(std::span<const Vec<2, double>>(shadow), 1.0, [depth](double width, double height) {
        return surface_of({width, height, depth});
      });
  Mat<3, double> turned = axes;
  turned[(k + 1) % 3] = u * along.x + v * along.y;
  turned[(k + 2) % 3] = v * along.x - u * along.y;
  return turned;
}

/// Rotates the axes about each of them in turn as long as the surface area decreases by more than rounding; the points
/// are in local coordinates, with about unit size.
inline Mat<3, double> refined_axes(Mat<3, double> axes, Points3 points) {
  constexpr int most_turns = 60;  // 5 to 15 are usual; later ones gain little
  double least = surface_along(axes, points);
  int since_better = 0;
  for (int turn = 0; turn < most_turns && since_better < 3; ++turn) {
    const Mat<3, double> turned = turned_about(turn % 3, axes, points);
    const double surface = surface_along(turned, points);
    ++since_better;
    if (!(surface < least - tolerance::rounding)) continue;
    least = surface;
    axes = turned;
    since_better = 0;
  }
  return axes_from(axes[0], axes[2]);  // orthonormalised again after many rotations
}

/// The extreme points along axes, on either side, and the surface area of the box between them.
struct Outermost {
  std::array<Vec<3, double>, 6> points{};
  double surface = 0;
};

template <class T>
Outermost outermost_along(const Mat<3, double>& axes, std::span<const Vec<3, T>> points, const LocalFrame<3>& frame) {
  Aabb<3, double> range = Aabb<3, double>::nothing();
  std::array<std::size_t, 3> lowest{};
  std::array<std::size_t, 3> highest{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec<3, double> u = frame.local(points[i]) * axes;
    for (Dim k = 0; k < 3; ++k) {
      if (u[k] < range.min[k]) lowest[static_cast<std::size_t>(k)] = i;
      if (u[k] > range.max[k]) highest[static_cast<std::size_t>(k)] = i;
    }
    range.grow(u);
  }
  Outermost result;
  for (std::size_t k = 0; k < 3; ++k) {
    result.points[k] = frame.local(points[lowest[k]]);
    result.points[k + 3] = frame.local(points[highest[k]]);
  }
  result.surface = surface_of(range.max - range.min);
  return result;
}

/// All points if there are few, otherwise the extreme ones.
template <class T>
std::vector<Vec<3, double>> first_choice(std::span<const Vec<3, T>> points, const LocalFrame<3>& frame) {
  constexpr std::size_t few = 64;
  std::vector<Vec<3, double>> chosen;
  if (points.size() <= few) {
    for (const Vec<3, T>& point : points) chosen.push_back(frame.local(point));
  } else {
    for (const std::size_t index : extreme_points(points)) chosen.push_back(frame.local(points[index]));
  }
  return chosen;
}

/// Right-handed unit axes of a box around the points with a small surface area. They are fitted to a few extreme
/// points, starting from a double tetrahedron among those and from the coordinate axes; then points outside of the box
/// are added to the few, and the axes are fitted again.
template <class T>
Mat<3, double> fitted_axes(std::span<const Vec<3, T>> points, const LocalFrame<3>& frame) {
  constexpr int most_rounds = 6;  // each is a pass over the points
  std::vector<Vec<3, double>> few = first_choice(points, frame);
  Mat<3, double> axes = refined_axes(ditetrahedron_axes(few), few);
  const Mat<3, double> upright = refined_axes(Mat<3, double>(1.0), few);
  if (surface_along(upright, few) < surface_along(axes, few)) axes = upright;
  Mat<3, double> best = axes;
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < most_rounds; ++round) {
    const Outermost outermost = outermost_along(axes, points, frame);
    if (outermost.surface < least) {
      least = outermost.surface;
      best = axes;
    }
    if (!(outermost.surface > surface_along(axes, few))) break;
    few.insert(few.end(), outermost.points.begin(), outermost.points.end());
    axes = refined_axes(axes, few);
  }
  return best;
}

}  // namespace graze::detail
