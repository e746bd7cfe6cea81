// SPDX-License-Identifier: MIT
// Exact touching of axis-aligned configurations: barycentric weights may be rounded, but coordinates are exact.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "exact/enclosed.hpp"

namespace graze::test {

using SignTest = bool (*)(const Enclosed&);

template <std::size_t N>
bool none_is(const std::vector<EnclosedVec<N>>& corners, std::size_t axis, SignTest has_sign) {
  return std::none_of(corners.begin(), corners.end(), [&](const EnclosedVec<N>& x) { return has_sign(x[axis]); });
}

/// Whether the hull of two or three corners, projected along all axes except i and j, certainly contains the origin.
template <std::size_t N>
bool holds_origin_in_plane(const std::vector<EnclosedVec<N>>& corners, std::size_t i, std::size_t j) {
  const auto turn = [&](std::size_t from, std::size_t to) {
    return corners[from][i] * corners[to][j] - corners[from][j] * corners[to][i];
  };
  if (corners.size() == 2) {
    const Enclosed cosine = corners[0][i] * corners[1][i] + corners[0][j] * corners[1][j];
    return is_surely_zero(turn(0, 1)) && is_surely_negative(cosine);
  }
  if (corners.size() != 3) return false;
  const std::vector<Enclosed> turns{turn(1, 2), turn(2, 0), turn(0, 1)};
  return std::all_of(turns.begin(), turns.end(), is_surely_positive) ||
         std::all_of(turns.begin(), turns.end(), is_surely_negative);
}

/// Whether the hull of a simplex's corners certainly contains the origin. If all corners are on one side of zero in a
/// coordinate, only those at zero count, and the coordinate is settled; at most two coordinates may remain, otherwise
/// the answer is unknown. If a single coordinate remains, the origin is between corners on either side.
template <std::size_t N>
bool holds_origin_on_axes(std::vector<EnclosedVec<N>> corners) {
  std::vector<std::size_t> axes;
  for (std::size_t axis = 0; axis < N; ++axis) axes.push_back(axis);
  for (std::size_t at = 0; at < axes.size();) {
    const std::size_t axis = axes[at];
    if (!none_is(corners, axis, is_surely_positive) && !none_is(corners, axis, is_surely_negative)) {
      ++at;
      continue;
    }
    std::erase_if(corners, [axis](const EnclosedVec<N>& corner) { return !is_surely_zero(corner[axis]); });
    axes.erase(axes.begin() + static_cast<std::ptrdiff_t>(at));
    at = 0;
  }
  if (corners.empty() || axes.size() > 2) return false;
  return axes.size() < 2 || holds_origin_in_plane(corners, axes[0], axes[1]);
}

}  // namespace graze::test
