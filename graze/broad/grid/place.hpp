// SPDX-License-Identifier: MIT
// Which cell of a Grid a box belongs to. This may round: cells know the bounds of their content, so no answer depends
// on it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <graze/math/platform/bit_cast.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// A cell of level l has size 2^l and contains the x with number * size <= x < (number + 1) * size along each axis. Two
/// along each axis form one of the next level.
template <Dim N>
struct GridPlace {
  int level = 0;
  std::array<std::int64_t, N> numbers{};

  friend bool operator==(const GridPlace&, const GridPlace&) = default;
};

/// The range of levels. A box beyond it is in no cell.
inline constexpr int lowest_grid_level = -1000;
inline constexpr int highest_grid_level = 1000;

/// The maximum number of binary digits of a cell number. A box farther from the origin goes to a level with larger
/// cells.
inline constexpr int grid_digits = 40;

/// 2^level.
inline double grid_size(int level) { return bit_cast<double>(static_cast<std::uint64_t>(1023 + level) << 52U); }

/// The lowest level whose cells are at least this long (0 or more); for 0, below all levels.
inline int grid_level_of(double length) {
  const auto bits = bit_cast<std::uint64_t>(length);
  const bool is_between_powers = (bits & ((std::uint64_t{1} << 52U) - 1)) != 0;
  return static_cast<int>(bits >> 52U) - 1023 + (is_between_powers ? 1 : 0);
}

/// Whether a box can be in a cell: it is finite and below the size of the highest level.
template <Dim N, class T>
bool has_grid_place(const Aabb<N, T>& box) {
  constexpr double most = 0x1p999;  // half a cell of the highest level
  for (Dim i = 0; i < N; ++i) {
    if (!(static_cast<double>(box.min[i]) >= -most && static_cast<double>(box.max[i]) <= most)) return false;
  }
  return true;
}

/// The lowest level whose cells are at least as long as the longest side of a box, and large enough for its distance
/// from the origin. The box must have a place in a cell.
template <Dim N, class T>
int own_grid_level(const Aabb<N, T>& box) {
  constexpr double sizes_to_origin = static_cast<double>(std::int64_t{1} << grid_digits);
  double least_size = 0;
  for (Dim i = 0; i < N; ++i) {
    const double low = static_cast<double>(box.min[i]);
    const double high = static_cast<double>(box.max[i]);
    const double nearest = (high > -low ? high : -low) / sizes_to_origin;
    least_size = high - low > least_size ? high - low : least_size;
    least_size = nearest > least_size ? nearest : least_size;
  }
  const int level = grid_level_of(least_size);
  return level > lowest_grid_level ? level : lowest_grid_level;
}

/// The cell of a level that contains the box's center; the level must not be below the box's own.
template <Dim N, class T>
GridPlace<N> grid_place(const Aabb<N, T>& box, int level) {
  const double cells_per_unit = grid_size(-level);
  GridPlace<N> place{level, {}};
  for (Dim i = 0; i < N; ++i) {
    const double center = static_cast<double>(box.min[i]) * 0.5 + static_cast<double>(box.max[i]) * 0.5;
    const auto towards_zero = static_cast<std::int64_t>(center * cells_per_unit);
    const bool is_above = center * cells_per_unit < static_cast<double>(towards_zero);
    place.numbers[static_cast<std::size_t>(i)] = towards_zero - (is_above ? 1 : 0);
  }
  return place;
}

/// The ancestor of a cell at a higher level.
template <Dim N>
GridPlace<N> place_above(const GridPlace<N>& place, int level) {
  GridPlace<N> above{level, {}};
  const auto levels = static_cast<unsigned>(level - place.level);
  for (std::size_t i = 0; i < std::size_t{N}; ++i) above.numbers[i] = place.numbers[i] >> (levels < 63U ? levels : 63U);
  return above;
}

template <Dim N>
GridPlace<N> parent_of(const GridPlace<N>& place) {
  return place_above(place, place.level + 1);
}

/// The index of a cell among its parent's children: the last binary digits of its numbers.
template <Dim N>
std::uint32_t child_number(const GridPlace<N>& place) {
  std::uint32_t child = 0;
  for (std::size_t i = 0; i < std::size_t{N}; ++i) {
    child |= (static_cast<std::uint32_t>(place.numbers[i]) & 1U) << static_cast<unsigned>(i);
  }
  return child;
}

template <Dim N>
GridPlace<N> child_of(const GridPlace<N>& parent, std::uint32_t child) {
  GridPlace<N> place{parent.level - 1, {}};
  for (std::size_t i = 0; i < std::size_t{N}; ++i) {
    place.numbers[i] = 2 * parent.numbers[i] + static_cast<std::int64_t>(child >> static_cast<unsigned>(i) & 1U);
  }
  return place;
}

/// The cells that touch the origin, with numbers 0 and -1 only, are the possible roots of their level: 2^N, indexed
/// like children.
template <Dim N>
GridPlace<N> place_at_origin(int level, std::uint32_t child) {
  GridPlace<N> place{level, {}};
  for (std::size_t i = 0; i < std::size_t{N}; ++i) {
    place.numbers[i] = -static_cast<std::int64_t>(child >> static_cast<unsigned>(i) & 1U);
  }
  return place;
}

/// The lowest level at which the ancestor of a cell touches the origin.
template <Dim N>
int level_at_origin(const GridPlace<N>& place) {
  std::uint64_t digits = 0;
  for (const std::int64_t number : place.numbers) digits |= static_cast<std::uint64_t>(number < 0 ? ~number : number);
  int level = place.level;
  for (; digits != 0; digits >>= 1U) ++level;
  return level;
}

}  // namespace graze::detail
