// SPDX-License-Identifier: MIT
// The sets of points whose hulls bench/convex_hull.cpp calculates, in 2D and 3D.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>

namespace graze::hull_bench {

template <Dim N>
using Points = std::vector<Vec<N, double>>;

enum class PointCloud {
  on_sphere,
  in_ball,
  in_cube,
  gaussian,
  on_lines,
  grid,
  decimal_grid,
  turned_grid,
  // 3D only:
  on_cube,
  on_cube_edges,
  on_cylinder_lines,
};

inline constexpr std::array all_clouds = {PointCloud::on_sphere,    PointCloud::in_ball,    PointCloud::in_cube,
                                          PointCloud::gaussian,     PointCloud::on_lines,   PointCloud::grid,
                                          PointCloud::decimal_grid, PointCloud::turned_grid};

inline constexpr std::array clouds_of_3d = {PointCloud::on_cube, PointCloud::on_cube_edges,
                                            PointCloud::on_cylinder_lines};

inline const char* name_of(PointCloud cluster, Dim dimension) {
  const bool is_flat = dimension == 2;
  switch (cluster) {
    case PointCloud::on_sphere:
      return is_flat ? "on a circle" : "on a sphere";
    case PointCloud::in_ball:
      return is_flat ? "in a disk" : "in a ball";
    case PointCloud::in_cube:
      return is_flat ? "in a square" : "in a cube";
    case PointCloud::gaussian:
      return is_flat ? "gaussian, flat" : "gaussian";
    case PointCloud::on_lines:
      return is_flat ? "on five flat lines" : "on five lines";
    case PointCloud::grid:
      return is_flat ? "flat grid of 1" : "grid of 1";
    case PointCloud::decimal_grid:
      return is_flat ? "flat grid of 0.1" : "grid of 0.1";
    case PointCloud::turned_grid:
      return is_flat ? "turned flat grid" : "turned grid";
    case PointCloud::on_cube:
      return "on a turned cube";
    case PointCloud::on_cube_edges:
      return "on a turned cube's edges";
    case PointCloud::on_cylinder_lines:
      return "on 100 lines of a cylinder";
  }
  return "";
}

/// Whether every corner is clearly one; many points on a circle are not.
inline bool is_in_general_position(PointCloud cluster, Dim dimension) {
  if (cluster == PointCloud::on_sphere) return dimension == 3;
  return cluster == PointCloud::in_ball || cluster == PointCloud::in_cube || cluster == PointCloud::gaussian;
}

template <Dim N>
Vec<N, double> direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Vec<N, double> way(0.0);
  for (Dim i = 0; i < N; ++i) way[i] = normal(random);
  return way;
}

/// A square or cubic lattice of points, their number rounded to a power of the dimension, in random order.
template <Dim N>
Points<N> grid(std::size_t count, double step, std::mt19937_64& random) {
  const auto side = std::lround(std::pow(static_cast<double>(count), 1.0 / static_cast<double>(N)));
  Points<N> points(1, Vec<N, double>(0.0));
  for (Dim axis = 0; axis < N; ++axis) {
    const Points<N> before = points;
    points.clear();
    for (const Vec<N, double>& start : before) {
      for (long i = 0; i < side; ++i) {
        points.push_back(start);
        points.back()[axis] = step * static_cast<double>(i);
      }
    }
  }
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

template <Dim N>
Points<N> turned(Points<N> points) {
  Mat<N, double> turn;
  if constexpr (N == 2)
    turn = rotation_matrix(40.0);
  else
    turn = rotation_matrix(Vec<3, double>(1, 2, 3), 40.0);
  for (Vec<N, double>& point : points) point = turn * point;
  return points;
}

template <Dim N>
Points<N> on_lines(std::size_t count, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::array<Vec<N, double>, 5> starts;
  std::array<Vec<N, double>, 5> ways;
  for (Vec<N, double>& start : starts) start = direction<N>(random);
  for (Vec<N, double>& way : ways) way = direction<N>(random);
  Points<N> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(starts[i % 5] + ways[i % 5] * uniform(random));
  return points;
}

template <Dim N>
Vec<N, double> random_point(PointCloud cluster, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Vec<N, double> point = direction<N>(random);
  if (cluster == PointCloud::gaussian) return point;
  if (cluster == PointCloud::in_cube) {
    for (Dim i = 0; i < N; ++i) point[i] = uniform(random);
    return point;
  }
  point /= std::sqrt(dot(point, point));
  if (cluster == PointCloud::on_sphere) return point;
  return point * std::pow(0.5 + 0.5 * uniform(random), 1.0 / static_cast<double>(N));
}

/// On the faces or the edges of a cube, or on a hundred lines along a cylinder, up to rounding.
inline Points<3> on_surface(PointCloud cluster, std::size_t count, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto end = [&] { return uniform(random) < 0 ? -1.0 : 1.0; };
  Points<3> points;
  for (std::size_t i = 0; i < count; ++i) {
    Vec<3, double>& point = points.emplace_back(end(), end(), end());
    const auto axis = static_cast<Dim>(i % 3);
    point[axis] = uniform(random);
    if (cluster == PointCloud::on_cube) point[(axis + 1) % 3] = uniform(random);
    if (cluster != PointCloud::on_cylinder_lines) continue;
    const double angle = 0.0628 * static_cast<double>(i % 100);
    point = {std::cos(angle), std::sin(angle), uniform(random)};
  }
  return turned<3>(points);
}

template <Dim N>
Points<N> points_of(PointCloud cluster, std::size_t count) {
  std::mt19937_64 random(20261122);
  if constexpr (N == 3) {
    if (cluster >= PointCloud::on_cube) return on_surface(cluster, count, random);
  }
  if (cluster == PointCloud::grid) return grid<N>(count, 1, random);
  if (cluster == PointCloud::decimal_grid) return grid<N>(count, 0.1, random);
  if (cluster == PointCloud::turned_grid) return turned(grid<N>(count, 1, random));
  if (cluster == PointCloud::on_lines) return on_lines<N>(count, random);
  Points<N> points;
  points.reserve(count);
  while (points.size() < count) points.push_back(random_point<N>(cluster, random));
  return points;
}

}  // namespace graze::hull_bench
