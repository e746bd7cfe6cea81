// SPDX-License-Identifier: MIT
// Other programs that find the corners of a convex hull. Each is one file, rival_<name>.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <graze/math/vec.hpp>

namespace graze::exam {

/// The places of the corners among the points; none if the program gives up.
template <Dim N>
using CornersAnswer = std::optional<std::vector<std::size_t>> (*)(const std::vector<Vec<N, double>>& points);

template <Dim N>
struct HullRival {
  std::string_view name;
  CornersAnswer<N> answer;
};

/// qhull with its default options, which merge what is nearly coplanar. It gives up where all points are on a plane.
std::optional<std::vector<std::size_t>> qhull_corners(const std::vector<Vec<2, double>>& points);
std::optional<std::vector<std::size_t>> qhull_corners(const std::vector<Vec<3, double>>& points);

/// Bullet's btConvexHullComputer, which works with whole numbers of a grid that it lays over the points.
std::optional<std::vector<std::size_t>> bullet_corners(const std::vector<Vec<3, double>>& points);

template <Dim N>
constexpr auto hull_rivals() {
  if constexpr (N == 2) {
    return std::array<HullRival<2>, 1>{{{"qhull", qhull_corners}}};
  } else {
    return std::array<HullRival<3>, 2>{{{"qhull", qhull_corners}, {"Bullet", bullet_corners}}};
  }
}

}  // namespace graze::exam
