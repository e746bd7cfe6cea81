// SPDX-License-Identifier: MIT
// The queries of bench/mesh.cpp on one surface.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <graze/math/pose.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/sphere.hpp>

#include "surface.hpp"

namespace mesh_bench {

using Ray = graze::Ray<3, float>;
using Pose = graze::Pose<3, float>;

struct Counts {
  std::size_t rays = 100'000;
  std::size_t points = 100'000;
  std::size_t shapes = 4'000;  ///< Of each kind.
  std::size_t places = 20;     ///< Of a second mesh.
};

/// Random queries, the same for the same surface.
struct Course {
  Course(Surface asked, const Counts& counts);

  Surface surface;
  Point center;       ///< Of the box around the surface.
  double reach = 0;   ///< The largest distance of a vertex from the center.
  double radius = 0;  ///< The mean distance.

  std::vector<Ray> rays;      ///< Of length 1, from a ball of twice the reach toward points in that of the reach.
  std::vector<Point> points;  ///< In the ball of the reach.
  /// Places of a second mesh, equal to the first: turned around the center, and then moved by the radius to twice the
  /// reach.
  std::vector<Pose> places;
  /// The same, but the meshes do not touch; every other one is close by.
  std::vector<Pose> places_apart;
  // A hundredth to a tenth of the radius in size, near the surface, so that about half of them touch it.
  std::vector<graze::Sphere<3>> spheres;
  std::vector<graze::Obb<3>> boxes;
  std::vector<graze::Capsule<3>> capsules;
  /// What the vertices move to and fro between: a smooth displacement of up to 2 % of the radius.
  std::array<std::vector<Point>, 2> moved;
};

}  // namespace mesh_bench
