// SPDX-License-Identifier: MIT
// Sets of boxes that are difficult for broad phases.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <graze/shape/aabb.hpp>

namespace graze::test {

template <Dim N, class T>
struct BoxWorld {
  std::string name;
  std::vector<Aabb<N, T>> boxes;
};

/// Deterministic uniform numbers; std::uniform_real_distribution differs between libraries.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1p-53);
  }
  template <Dim N, class T>
  Vec<N, T> point(double low, double high) {
    Vec<N, T> result;
    for (Dim i = 0; i < N; ++i) result[i] = static_cast<T>(between(low, high));
    return result;
  }

 private:
  std::mt19937_64 engine_;
};

/// The number of positions along each axis of the smallest lattice with at least this many.
template <Dim N>
std::size_t side_of_lattice(std::size_t places) {
  std::size_t side = 1;
  while ((N == 2 ? side * side : side * side * side) < places) ++side;
  return side;
}

template <Dim N, class T>
std::vector<BoxWorld<N, T>> box_worlds(std::size_t count, std::uint64_t seed) {
  Numbers numbers(seed);
  const auto world = [count](const std::string& name, const auto& make) {
    BoxWorld<N, T> result{name, {}};
    for (std::size_t i = 0; i < count; ++i) result.boxes.push_back(make(i));
    return result;
  };
  const auto cube = [](const Vec<N, T>& center, double half) {
    return Aabb<N, T>::from_center(center, Vec<N, T>(static_cast<T>(half)));
  };
  const double side = std::pow(static_cast<double>(count), 1.0 / N) * 2;
  constexpr T infinity = std::numeric_limits<T>::infinity();
  std::vector<BoxWorld<N, T>> worlds;
  worlds.push_back(world("equal cubes", [&](std::size_t) { return cube(numbers.point<N, T>(0, side), 0.7); }));
  worlds.push_back(world("sizes over 1:1000", [&](std::size_t) {
    return cube(numbers.point<N, T>(0, side), 0.01 * std::pow(10.0, numbers.between(0, 3)));
  }));
  worlds.push_back(world("clusters", [&](std::size_t i) {
    const auto place = static_cast<T>(i % 7 * 100);
    return cube(Vec<N, T>(place) + numbers.point<N, T>(-1, 1), 0.1);
  }));
  worlds.push_back(world("on one line", [&](std::size_t) {
    Vec<N, T> center(T(0));
    center[0] = static_cast<T>(numbers.between(0, static_cast<double>(count)));
    return cube(center, 0.5);
  }));
  worlds.push_back(world("on one plane", [&](std::size_t) {
    Vec<N, T> center = numbers.point<N, T>(0, std::sqrt(static_cast<double>(count)));
    center[N - 1] = T(3);
    return cube(center, 0.5);
  }));
  const std::size_t row = side_of_lattice<N>(count);
  worlds.push_back(world("a lattice that only touches", [row](std::size_t i) {
    Vec<N, T> low;
    for (Dim k = 0; k < N; ++k, i /= row) low[k] = static_cast<T>(i % row);
    return Aabb<N, T>{low, low + T(1)};
  }));
  const std::size_t dwarfs_per_giant = std::max<std::size_t>(100, count / 5);
  worlds.push_back(world("a few giants over dwarfs", [&](std::size_t i) {
    return cube(numbers.point<N, T>(0, side), i % dwarfs_per_giant == 0 ? side / 2 : 0.2);
  }));
  worlds.push_back(world("zero size on a grid", [&](std::size_t) {
    Vec<N, T> center = numbers.point<N, T>(0, 6);
    for (Dim k = 0; k < N; ++k) center[k] = std::floor(center[k]);
    return cube(center, 0);
  }));
  worlds.push_back(world("sizes of 1 at 1e7", [&](std::size_t) {
    // Not relative to the center: in float, half a unit would be lost there.
    const auto low = numbers.point<N, T>(1e7, 1e7 + side);
    return Aabb<N, T>{low, low + T(1)};
  }));
  worlds.push_back(world("infinite, empty and plain", [&](std::size_t i) {
    Aabb<N, T> box = cube(numbers.point<N, T>(0, side), 0.5);
    const Dim axis = static_cast<Dim>(i % N);
    if (i % 11 == 0) box.max[axis] = infinity;
    if (i % 13 == 0) box.min[axis] = -infinity;
    if (i % 17 == 0) box = Aabb<N, T>::everything();
    if (i % 19 == 0) box = Aabb<N, T>::nothing();
    return box;
  }));
  worlds.push_back(world("the largest numbers", [&](std::size_t) {
    const double huge = static_cast<double>(std::numeric_limits<T>::max());
    return Aabb<N, T>::from_corners(numbers.point<N, T>(-huge / 2, huge / 2), numbers.point<N, T>(-huge / 2, huge / 2));
  }));
  return worlds;
}

}  // namespace graze::test
