// SPDX-License-Identifier: MIT
// 3D vectors of all lanes of a group at once. Written without loops, because GCC 12 does not unroll them and then keeps
// the vectors in memory.
#pragma once

#include <array>

#include <graze/math/lanes/sixteen.hpp>
#include <graze/math/vec.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// The coordinates, each of all lanes.
template <class V>
struct LaneVec {
  V x;
  V y;
  V z;
};

template <class Group, class T, class V>
[[gnu::always_inline]] inline void read_vec(const Group& group, const std::array<Row<T>, 3>& rows, LaneVec<V>& v) {
  group.read(rows[0], v.x);
  group.read(rows[1], v.y);
  group.read(rows[2], v.z);
}

/// v - start, for a point or the points of the lanes.
template <class V, class Start>
[[gnu::always_inline]] inline void subtract(const LaneVec<V>& v, const Start& start, LaneVec<V>& result) {
  result.x = v.x - start.x;
  result.y = v.y - start.y;
  result.z = v.z - start.z;
}

/// With a vector, or the vectors of the lanes.
template <class V, class Other>
[[gnu::always_inline]] inline void dot_of(const LaneVec<V>& a, const Other& b, V& result) {
  result = a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class V>
[[gnu::always_inline]] inline void cross_of(const LaneVec<V>& a, const LaneVec<V>& b, LaneVec<V>& result) {
  result.x = a.y * b.z - a.z * b.y;
  result.y = a.z * b.x - a.x * b.z;
  result.z = a.x * b.y - a.y * b.x;
}

/// Of all coordinates.
template <class Group, class V>
[[gnu::always_inline]] inline void sum_magnitudes(const LaneVec<V>& v, V& result) {
  LaneVec<V> positive = v;
  make_positive<Group>(positive.x);
  make_positive<Group>(positive.y);
  make_positive<Group>(positive.z);
  result = positive.x + positive.y + positive.z;
}

}  // namespace graze::detail

#endif
