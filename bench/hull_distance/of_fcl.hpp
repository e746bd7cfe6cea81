// SPDX-License-Identifier: MIT
// FCL's distances of two convex hulls, in double: by its own solver, and by one based on libccd's. Both take an initial
// guess. The hulls have faces, which FCL uses to climb from corner to corner if there are more than 32.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/detail/gjk_solver_indep.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include <graze/shape/hull/frame.hpp>
#include <graze/shape/hull/quickhull.hpp>
#include <graze/shape/hull/undecided_points.hpp>

#include "../bench/hull_distance/pairs.hpp"

namespace graze::hull_bench {

inline std::unique_ptr<fcl::Convexd> fcl_hull(const Hull& hull) {
  const detail::HullFrame<double> frame(hull.vertices());
  const detail::Quickhull<double> built = detail::hull_of(frame);
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const Point& corner : hull.vertices()) vertices->emplace_back(corner.x, corner.y, corner.z);
  auto faces = std::make_shared<std::vector<int>>();
  int count = 0;
  for (const auto& face : built.faces()) {
    if (!face.is_alive) continue;
    ++count;
    faces->push_back(3);
    for (const std::uint32_t corner : face.corners) {
      faces->push_back(static_cast<int>(built.corners()[corner].index));
    }
  }
  return std::make_unique<fcl::Convexd>(vertices, count, faces, true);
}

template <class Solver>
class FclSolver {
 public:
  explicit FclSolver(const MovingPair& pair) {
    for (std::size_t k = 0; k < 2; ++k) hulls_[k] = fcl_hull(pair.hulls[k]);
    for (const auto& places : pair.frames) frames_.push_back({transform(places[0]), transform(places[1])});
  }

  double find(std::size_t i) {
    solver_.enableCachedGuess(false);
    return distance(i);
  }
  double follow(std::size_t i) {
    solver_.enableCachedGuess(true);
    return distance(i);
  }

 private:
  static fcl::Transform3d transform(const Place& place) {
    fcl::Transform3d result = fcl::Transform3d::Identity();
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) result.linear()(row, column) = place.rotation[column][row];
      result.translation()[column] = place.position[column];
    }
    return result;
  }

  double distance(std::size_t i) {
    double found = 0;
    fcl::Vector3d on_a;
    fcl::Vector3d on_b;
    solver_.shapeDistance(*hulls_[0], frames_[i][0], *hulls_[1], frames_[i][1], &found, &on_a, &on_b);
    return std::max(0.0, found);
  }

  std::array<std::unique_ptr<fcl::Convexd>, 2> hulls_;
  std::vector<std::array<fcl::Transform3d, 2>> frames_;
  Solver solver_;
};

class FclOwn : public FclSolver<fcl::detail::GJKSolver_indepd> {
 public:
  static constexpr const char* name = "FCL, its own solver";
  using FclSolver::FclSolver;
};

class FclOfLibccd : public FclSolver<fcl::detail::GJKSolver_libccdd> {
 public:
  static constexpr const char* name = "FCL, libccd's solver";
  using FclSolver::FclSolver;
};

}  // namespace graze::hull_bench
