// SPDX-License-Identifier: MIT
// Sixteen numbers at a time, in the widest vectors of the processor: the numbers of a row, and a bit for each lane.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include <graze/math/platform/has_lanes.hpp>

namespace graze::detail {

inline constexpr std::size_t row_length = 16;

/// Sixteen numbers in memory.
template <class T>
using Row = std::array<T, row_length>;

/// The least of a row without NaN.
template <class T>
T least_of(Row<T> row) {
  for (std::size_t half = row_length / 2; half > 0; half /= 2) {
    for (std::size_t lane = 0; lane < half; ++lane) row[lane] = std::min(row[lane], row[lane + half]);
  }
  return row[0];
}

/// The greatest, likewise.
template <class T>
T greatest_of(Row<T> row) {
  for (std::size_t half = row_length / 2; half > 0; half /= 2) {
    for (std::size_t lane = 0; lane < half; ++lane) row[lane] = std::max(row[lane], row[lane + half]);
  }
  return row[0];
}

/// Bit i belongs to lane i.
using LaneMask = std::uint32_t;

/// The mask of the first lanes; up to sixteen.
constexpr LaneMask first_lanes(std::size_t count) { return (LaneMask{1} << count) - 1; }

/// Calls visit(lane) for the lanes of a mask, ascending, until it returns false. Returns whether all were visited.
template <class Visit>
[[gnu::always_inline]] inline bool for_each_lane(LaneMask lanes, const Visit& visit) {
  for (; lanes != 0; lanes &= lanes - 1) {
    if (!visit(static_cast<std::uint32_t>(std::countr_zero(lanes)))) return false;
  }
  return true;
}

#ifdef GRAZE_HAS_LANES

/// The lanes of a row that fit into one vector register. What a kernel calls is always inlined and takes vectors by
/// reference, so that it is compiled for the target of the caller.
template <class T, std::size_t bytes>
struct LaneGroup {
  using Number = T;
  using Flag = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
  // GCC ignores the attribute of `using`.
  typedef T Numbers __attribute__((vector_size(bytes)));   // NOLINT(modernize-use-using)
  typedef Flag Flags __attribute__((vector_size(bytes)));  // NOLINT(modernize-use-using): all bits of a lane, or none
  static constexpr std::size_t count = bytes / sizeof(T);

  [[gnu::always_inline]] void read(const Row<T>& row, Numbers& numbers) const {
    std::memcpy(&numbers, row.data() + first, bytes);
  }
  [[gnu::always_inline]] void write(const Numbers& numbers, Row<T>& row) const {
    std::memcpy(row.data() + first, &numbers, bytes);
  }

  std::size_t first;  ///< Its place in the row.
  Flags flags{};      ///< What the kernel finds.
};

/// The vectors of a group.
template <class Group>
using NumbersOf = typename std::remove_reference_t<Group>::Numbers;

/// Keeps `a` if b is NaN.
template <class V>
[[gnu::always_inline]] inline void make_larger(V& a, const V& b) {
  a = b > a ? b : a;
}
template <class V>
[[gnu::always_inline]] inline void make_smaller(V& a, const V& b) {
  a = b < a ? b : a;
}
/// Replaces all numbers of a group by their magnitudes.
template <class Group>
[[gnu::always_inline]] inline void make_positive(NumbersOf<Group>& numbers) {
  typename Group::Flags bits;
  std::memcpy(&bits, &numbers, sizeof bits);
  bits &= std::numeric_limits<typename Group::Flag>::max();
  std::memcpy(&numbers, &bits, sizeof bits);
}

/// The flags of a group as numbers whose signs are the flags.
template <class Group>
[[gnu::always_inline]] inline void read_signs(const Group& group, typename Group::Numbers& signs) {
  std::memcpy(&signs, &group.flags, sizeof signs);
}

// The following apply a kernel group by group, each with the instructions of its target, and collect the flags.

template <class T, class Kernel>
[[gnu::flatten]] LaneMask run_plain(const Kernel& kernel) {
  using Group = LaneGroup<T, 16>;
  LaneMask mask = 0;
  for (std::size_t first = 0; first < row_length; first += Group::count) {
    Group group{first};
    kernel(group);
#ifdef __SSE2__
    typename Group::Numbers signs;
    read_signs(group, signs);
    if constexpr (std::is_same_v<T, float>) {
      mask |= static_cast<LaneMask>(__builtin_ia32_movmskps(signs)) << first;
    } else {
      mask |= static_cast<LaneMask>(__builtin_ia32_movmskpd(signs)) << first;
    }
#else
    for (std::size_t i = 0; i < Group::count; ++i) {
      mask |= (group.flags[i] != 0 ? LaneMask{1} : LaneMask{0}) << (first + i);
    }
#endif
  }
  return mask;
}

#ifdef GRAZE_HAS_WIDER_LANES
template <class T, class Kernel>
[[gnu::target("avx2"), gnu::flatten]] LaneMask run_avx2(const Kernel& kernel) {
  using Group = LaneGroup<T, 32>;
  LaneMask mask = 0;
  for (std::size_t first = 0; first < row_length; first += Group::count) {
    Group group{first};
    kernel(group);
    typename Group::Numbers signs;
    read_signs(group, signs);
    if constexpr (std::is_same_v<T, float>) {
      mask |= static_cast<LaneMask>(__builtin_ia32_movmskps256(signs)) << first;
    } else {
      mask |= static_cast<LaneMask>(__builtin_ia32_movmskpd256(signs)) << first;
    }
  }
  return mask;
}

using EightLongs = long long __attribute__((vector_size(64)));
using SixteenInts = int __attribute__((vector_size(64)));

template <class T, class Kernel>
[[gnu::target("avx512f,avx512dq"), gnu::flatten]] LaneMask run_avx512(const Kernel& kernel) {
  using Group = LaneGroup<T, 64>;
  LaneMask mask = 0;
  for (std::size_t first = 0; first < row_length; first += Group::count) {
    Group group{first};
    kernel(group);
    std::conditional_t<std::is_same_v<T, float>, SixteenInts, EightLongs> flags;
    std::memcpy(&flags, &group.flags, sizeof flags);
    if constexpr (std::is_same_v<T, float>) {
      mask |= static_cast<LaneMask>(__builtin_ia32_cvtd2mask512(flags)) << first;
    } else {
      mask |= static_cast<LaneMask>(__builtin_ia32_cvtq2mask512(flags)) << first;
    }
  }
  return mask;
}
#endif

/// The lanes whose flags kernel(group) sets, with the best instructions of the processor. The kernel must be always
/// inlined. With AVX-512, operations may be fused; so it must not matter whether they are.
template <class T, class Kernel>
LaneMask lanes_set_by(const Kernel& kernel) {
#ifdef GRAZE_HAS_WIDER_LANES
  if (__builtin_cpu_supports("avx512dq")) return run_avx512<T>(kernel);
  if (__builtin_cpu_supports("avx2")) return run_avx2<T>(kernel);
#endif
  return run_plain<T>(kernel);
}

#endif

}  // namespace graze::detail
