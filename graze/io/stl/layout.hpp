// SPDX-License-Identifier: MIT
// The layout of binary STL: a header of any bytes, the number of triangles, and for each triangle its normal and three
// corners in float, and two bytes without a fixed meaning. All numbers are little endian.
#pragma once

#include <cstddef>

namespace graze::io {

inline constexpr std::size_t stl_name_bytes = 80;
inline constexpr std::size_t stl_head_bytes = stl_name_bytes + 4;
inline constexpr std::size_t stl_normal_bytes = 12;
inline constexpr std::size_t stl_triangle_bytes = 50;

}  // namespace graze::io
