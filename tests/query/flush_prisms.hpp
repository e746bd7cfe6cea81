// SPDX-License-Identifier: MIT
// An unlimited supply of pairs of 3D prisms with an end of one opposite an end of the other, nearly parallel, which is
// difficult for GJK; for tests of single types.
#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/polytope.hpp>

namespace graze::test {

template <class T>
struct FlushPrisms {
  Polytope<3, T> a;
  Polytope<3, T> b;
  Vec<3, double> normal;  ///< Of the end of a, towards b.
};

/// The same for the same turn. Three to nine corners at each end, in half of the cases on a lattice; the ends are `gap`
/// apart (negative: overlapping) and parallel except for 1e-12 to 1e-6 radians in half of the cases and, in another
/// half, for coordinates with 7 to 13 digits.
template <class T>
FlushPrisms<T> flush_prisms(unsigned turn, double gap) {
  std::mt19937 engine(turn + 1);
  const auto number = [&engine](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  const auto way = [&] { return Vec<3, double>(number(-1, 1), number(-1, 1), number(-1, 1)) + Vec<3, double>(2e-3); };
  const Mat<3, double> both = rotation_matrix(way(), number(0, 360));
  const double tilt = number(0, 1) < 0.5 ? 0 : std::pow(10, number(-12, -6)) * (180 / 3.14159265358979323846);
  const Mat<3, double> little = rotation_matrix(way(), tilt);
  const double step = number(0, 1) < 0.5 ? 0 : std::pow(10, -std::floor(number(7, 14)));
  const auto placed = [&](const Vec<3, double>& point) {
    Vec<3, double> place = both * point;
    for (Dim i = 0; i < 3 && step > 0; ++i) place[i] = std::round(place[i] / step) * step;
    return Vec<3, T>(place);
  };
  const auto prism = [&](const auto& put, double side) {
    const bool is_on_lattice = number(0, 1) < 0.5;
    std::vector<Vec<3, T>> corners;
    const double depth = side * number(0.1, 2);
    for (int i = 0, count = static_cast<int>(number(4, 10)); i < count; ++i) {
      const double lattice_y = 0.5 * std::floor(number(-2, 3));
      const double y = is_on_lattice ? lattice_y : number(-1, 1);
      const double z = is_on_lattice ? 0.5 * std::floor(number(-2, 3)) : number(-1, 1);
      corners.push_back(put({0, y, z}));
      corners.push_back(put({depth, y, z}));
    }
    return convex_hull<3, T>(corners);
  };
  const Polytope<3, T> a = prism(placed, -1);
  const Polytope<3, T> b =
      prism([&](const Vec<3, double>& point) { return placed(little * point + Vec<3, double>(gap, 0, 0)); }, 1);
  return {a, b, both[0]};
}

/// From 0.2 to 2e-7, by the turn.
inline double flush_gap(unsigned turn) { return 0.2 * std::pow(10, -0.5 * static_cast<double>(turn % 13)); }

}  // namespace graze::test
