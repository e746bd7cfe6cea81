// SPDX-License-Identifier: MIT
// Prints the number of corners of hulls of points on planes and lines, moved off them by rounding: these numbers change
// as soon as one product is not rounded.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <graze/shape/polytope.hpp>

namespace {

/// Below 1.
double next_number(std::uint64_t& state) {
  state = state * 6364136223846793005U + 1442695040888963407U;
  return static_cast<double>(state >> 11U) * 0x1p-53;
}

graze::Vec<3, double> next_point(std::uint64_t& state) {
  const double x = next_number(state);
  const double y = next_number(state);
  const double z = next_number(state);
  return {x, y, z};
}

}  // namespace

int main() {
  std::uint64_t state = 1;
  for (int trial = 0; trial < 200; ++trial) {
    const graze::Vec<3, double> origin = next_point(state);
    const graze::Vec<3, double> a = next_point(state) * 0.1;
    const graze::Vec<3, double> b = next_point(state) * 0.1;
    std::vector<graze::Vec<3, double>> pyramid{{2, 2, 2}};
    std::vector<graze::Vec<2, double>> triangle{{9, -3}};
    for (int i = 0; i < 8; ++i) {
      for (int j = 0; j < 8; ++j) pyramid.push_back(origin + a * static_cast<double>(i) + b * static_cast<double>(j));
    }
    for (int i = 0; i < 40; ++i) triangle.emplace_back(origin.x + a.x * i, origin.y + a.y * i);
    const std::size_t corners = graze::convex_hull(pyramid).vertices().size();
    std::printf("%zu %zu\n", corners, graze::convex_hull(triangle).vertices().size());
  }
}
