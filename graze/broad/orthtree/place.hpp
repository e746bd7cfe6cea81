// SPDX-License-Identifier: MIT
// The positions of an Orthtree's cells, and which cell takes a box. This may round: cells know the bounds of their
// content, so no answer depends on it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <graze/broad/orthtree/entry_pool.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze {

/// When an Orthtree splits its cells.
struct OrthtreeOptions {
  std::size_t capacity = 32;  ///< A cell with more boxes than this is split. At least 1.
  int max_depth = 16;         ///< Cells of this depth are not split; the root has depth 0. 0 to 32.
};

namespace detail {

/// The position of a square or cubic cell. Cells of the next level have half the size; the root's level decreases when
/// it grows.
template <Dim N>
struct CellPosition {
  Vec<N, double> center = Vec<N, double>(0.0);
  double half = 0;
  int level = 0;
  std::uint32_t parent = no_index;
};

template <Dim N, class T>
Vec<N, double> center_of(const Aabb<N, T>& box) {
  return wide<N, T>(box.min) * 0.5 + wide<N, T>(box.max) * 0.5;
}

/// A cell takes boxes that are inside its square grown to twice its size (a loose tree): boxes up to its own size whose
/// center it contains.
template <Dim N, class T>
bool fits(const CellPosition<N>& place, const Aabb<N, T>& box) {
  unsigned sticks_out = 0;  // branch-free, because the outcome is unpredictable
  for (Dim i = 0; i < N; ++i) {
    sticks_out |= static_cast<unsigned>(!(static_cast<double>(box.min[i]) >= place.center[i] - 2 * place.half)) |
                  static_cast<unsigned>(!(static_cast<double>(box.max[i]) <= place.center[i] + 2 * place.half));
  }
  return sticks_out == 0;
}

template <Dim N>
bool contains_center(const CellPosition<N>& place, const Vec<N, double>& center) {
  unsigned is_beyond = 0;
  for (Dim i = 0; i < N; ++i) {
    is_beyond |= static_cast<unsigned>(!(std::fabs(center[i] - place.center[i]) <= place.half));
  }
  return is_beyond == 0;
}

template <Dim N, class T>
bool takes(const CellPosition<N>& place, const Aabb<N, T>& box) {
  return contains_center(place, center_of(box)) && fits(place, box);
}

/// The number of the child on a point's side.
template <Dim N>
std::uint32_t child_towards(const CellPosition<N>& place, const Vec<N, double>& center) {
  std::uint32_t child = 0;
  for (Dim i = 0; i < N; ++i) child |= (center[i] >= place.center[i] ? 1U : 0U) << static_cast<unsigned>(i);
  return child;
}

template <Dim N>
CellPosition<N> child_place(const CellPosition<N>& place, std::uint32_t child) {
  CellPosition<N> result{place.center, place.half / 2, place.level + 1, no_index};
  for (Dim i = 0; i < N; ++i) {
    const bool is_upper = (child >> static_cast<unsigned>(i) & 1U) != 0;
    result.center[i] += is_upper ? result.half : -result.half;
  }
  return result;
}

/// The cell of twice the size that has this one as a child and extends towards a point.
template <Dim N>
CellPosition<N> doubled_place(const CellPosition<N>& place, const Vec<N, double>& target) {
  CellPosition<N> result{place.center, place.half * 2, place.level - 1, no_index};
  for (Dim i = 0; i < N; ++i) result.center[i] += target[i] >= place.center[i] ? place.half : -place.half;
  return result;
}

/// Whether a root contains another and is not much larger.
template <Dim N>
bool is_as_good(const CellPosition<N>& root, const CellPosition<N>& other) {
  for (Dim i = 0; i < N; ++i) {
    if (std::fabs(other.center[i] - root.center[i]) + other.half > root.half) return false;
  }
  return root.half < 1.5 * other.half;
}

/// The middle and half the length of a range, without overflow.
struct AxisRange {
  double center;
  double half;
};

inline AxisRange range_between(double low, double high) { return {low * 0.5 + high * 0.5, high * 0.5 - low * 0.5}; }

template <Dim N, class Ranges>
CellPosition<N> place_over(const Ranges& ranges) {
  CellPosition<N> place;
  for (Dim i = 0; i < N; ++i) {
    const AxisRange range = ranges(i);
    place.center[i] = range.center;
    place.half = std::max(place.half, range.half);
  }
  return place;
}

/// The square for a root of `count` boxes: around all; or, if a few distant boxes would cost more levels than there
/// are, around the central seven eighths of the centers along each axis, doubled, estimated from a sample.
template <Dim N, class T>
CellPosition<N> place_of_root(const std::vector<Aabb<N, T>>& some, const Aabb<N, T>& all, std::size_t count,
                              const OrthtreeOptions& options) {
  const CellPosition<N> whole = place_over<N>(
      [&](Dim i) { return range_between(static_cast<double>(all.min[i]), static_cast<double>(all.max[i])); });
  std::vector<double> centers(some.size());
  const CellPosition<N> middle = place_over<N>([&](Dim i) {
    for (std::size_t k = 0; k < some.size(); ++k) centers[k] = center_of(some[k])[i];
    const auto skipped = static_cast<std::ptrdiff_t>(some.size() / 16);
    std::nth_element(centers.begin(), centers.begin() + skipped, centers.end());
    const double low = centers[static_cast<std::size_t>(skipped)];
    std::nth_element(centers.begin(), centers.end() - 1 - skipped, centers.end());
    const AxisRange range = range_between(low, *(centers.end() - 1 - skipped));
    return AxisRange{range.center, 2 * range.half};
  });
  if (!(middle.half > 0)) return whole;  // all centers coincide: the size of the boxes is as good as any
  const double leaves = static_cast<double>(count) / static_cast<double>(options.capacity);
  const int levels = std::ilogb(std::max(1.0, leaves)) / N + 3 + std::ilogb(whole.half) - std::ilogb(middle.half);
  return levels > options.max_depth ? middle : whole;
}

/// The same, from all boxes.
template <Dim N, class T>
CellPosition<N> place_of_root(const std::vector<Aabb<N, T>>& boxes, const OrthtreeOptions& options) {
  Aabb<N, T> all = Aabb<N, T>::nothing();
  for (const Aabb<N, T>& box : boxes) all.grow(box);
  return place_of_root(boxes, all, boxes.size(), options);
}

}  // namespace detail
}  // namespace graze
