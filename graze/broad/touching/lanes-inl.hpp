// SPDX-License-Identifier: MIT
// Shapes of many pairs side by side: every number of a struct as a vector with a lane per pair. Included once per
// instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_TOUCHING_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_TOUCHING_LANES_INL_HPP
#undef GRAZE_BROAD_TOUCHING_LANES_INL_HPP
#else
#define GRAZE_BROAD_TOUCHING_LANES_INL_HPP
#endif

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <hwy/highway.h>

#include <graze/broad/pair.hpp>
#include <graze/broad/simd/lanes-inl.hpp>
#include <graze/math/vec.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

/// A 2D or 3D vector in every lane.
template <Dim N, class T>
struct LaneVec {
  Lanes<T> at[N];

  HWY_INLINE Lanes<T>& operator[](Dim i) { return at[i]; }
  HWY_INLINE const Lanes<T>& operator[](Dim i) const { return at[i]; }
};

template <Dim N, class T>
HWY_INLINE Lanes<T> inner(const LaneVec<N, T>& a, const LaneVec<N, T>& b) {
  Lanes<T> sum = hn::Mul(a.at[0], b.at[0]);
  for (Dim i = 1; i < N; ++i) sum = hn::MulAdd(a.at[i], b.at[i], sum);
  return sum;
}

template <Dim N, class T>
HWY_INLINE LaneVec<N, T> difference(const LaneVec<N, T>& a, const LaneVec<N, T>& b) {
  LaneVec<N, T> result;
  for (Dim i = 0; i < N; ++i) result.at[i] = hn::Sub(a.at[i], b.at[i]);
  return result;
}

template <Dim N, class T>
HWY_INLINE Lanes<T> sum_abs(const LaneVec<N, T>& v) {
  Lanes<T> sum = hn::Abs(v.at[0]);
  for (Dim i = 1; i < N; ++i) sum = hn::Add(sum, hn::Abs(v.at[i]));
  return sum;
}

/// The same number in every lane.
template <class T>
HWY_INLINE Lanes<T> all(T value) {
  return hn::Set(Tag<T>(), value);
}

/// The addresses of a group's structs: rows[lane], and rows + n for subsequent numbers. Either pointers or PairRows.
template <class Rows, class T>
concept RowsOf = requires(const Rows& rows, std::size_t lane) {
  { *rows[lane] } -> std::convertible_to<T>;
};

/// One side of pairs that name shapes of one type, which are `Stride` numbers apart.
template <class T, std::size_t Stride, std::uint32_t Pair::*Side>
struct SideOfPairs {
  const T* shapes;
  const Pair* pairs;

  HWY_INLINE const T* operator[](std::size_t lane) const { return shapes + pairs[lane].*Side * Stride; }
  HWY_INLINE SideOfPairs operator+(std::size_t lanes) const { return {shapes, pairs + lanes}; }
};

#if HWY_TARGET != HWY_SCALAR

/// The numbers in a 128-bit block: within blocks, shuffles are cheap.
template <class T>
constexpr std::size_t per_block = 16 / sizeof(T);

/// A block from each of the rows first, first + per_block, ..., side by side.
template <class T, class Rows, class D>
HWY_INLINE hn::Vec<D> load_blocks(D d, const Rows& rows, std::size_t offset) {
  if constexpr (hn::MaxLanes(D()) == per_block<T>) {
    return hn::LoadU(d, rows[0] + offset);
  } else {
    const hn::Half<D> half;
    const auto low = load_blocks<T>(half, rows, offset);
    return hn::Combine(d, load_blocks<T>(half, rows + hn::MaxLanes(half), offset), low);
  }
}

/// Loads number `offset` + k of every row into out[k], for one block of numbers: a transposition within blocks.
template <class T, class Rows>
HWY_INLINE void load_numbers(const Rows& rows, std::size_t offset, Lanes<T>* out) {
  const Tag<T> d;
  if constexpr (per_block<T> == 4) {
    const auto row0 = load_blocks<T>(d, rows, offset);
    const auto row1 = load_blocks<T>(d, rows + 1, offset);
    const auto row2 = load_blocks<T>(d, rows + 2, offset);
    const auto row3 = load_blocks<T>(d, rows + 3, offset);
    const auto even_low = hn::InterleaveLower(d, row0, row2);
    const auto odd_low = hn::InterleaveLower(d, row1, row3);
    const auto even_high = hn::InterleaveUpper(d, row0, row2);
    const auto odd_high = hn::InterleaveUpper(d, row1, row3);
    out[0] = hn::InterleaveLower(d, even_low, odd_low);
    out[1] = hn::InterleaveUpper(d, even_low, odd_low);
    out[2] = hn::InterleaveLower(d, even_high, odd_high);
    out[3] = hn::InterleaveUpper(d, even_high, odd_high);
  } else {
    const auto row0 = load_blocks<T>(d, rows, offset);
    const auto row1 = load_blocks<T>(d, rows + 1, offset);
    out[0] = hn::InterleaveLower(d, row0, row1);
    out[1] = hn::InterleaveUpper(d, row0, row1);
  }
}

/// Unrolled block by block: a loop would keep the vectors in memory.
template <class T, class Rows, std::size_t Count, std::size_t... Block>
HWY_INLINE void load_all_blocks(const Rows& rows, Lanes<T> (&out)[Count], std::index_sequence<Block...>) {
  (load_numbers<T>(rows, std::min(Block * per_block<T>, Count - per_block<T>),
                   out + std::min(Block * per_block<T>, Count - per_block<T>)),
   ...);
}

#endif

/// The first `Count` numbers of each lane's struct. If Count is not a multiple of a block, the last block overlaps the
/// previous one, so that nothing beyond the struct is read.
template <class T, class Rows, std::size_t Count>
HWY_INLINE void load_struct(const Rows& rows, Lanes<T> (&out)[Count]) {
#if HWY_TARGET == HWY_SCALAR
  for (std::size_t k = 0; k < Count; ++k) out[k] = hn::Set(Tag<T>(), rows[0][k]);
#else
  if constexpr (Count < per_block<T>) {
    alignas(64) T column[lanes_of<T>];
    for (std::size_t k = 0; k < Count; ++k) {
      for (std::uint32_t lane = 0; lane < lanes_of<T>; ++lane) column[lane] = rows[lane][k];
      out[k] = hn::Load(Tag<T>(), column);
    }
  } else {
    load_all_blocks<T>(rows, out, std::make_index_sequence<(Count + per_block<T> - 1) / per_block<T> >());
  }
#endif
}

// ---- The structs of shapes, in every lane

template <Dim N, class T>
struct LaneSphere {
  LaneVec<N, T> center;
  Lanes<T> radius;

  template <RowsOf<T> Rows>
  HWY_INLINE explicit LaneSphere(const Rows& rows) {
    Lanes<T> number[N + 1];
    load_struct<T>(rows, number);
    for (Dim i = 0; i < N; ++i) center.at[i] = number[i];
    radius = number[N];
  }
};

template <Dim N, class T>
struct LaneAabb {
  LaneVec<N, T> min;
  LaneVec<N, T> max;

  template <RowsOf<T> Rows>
  HWY_INLINE explicit LaneAabb(const Rows& rows) {
    Lanes<T> number[2 * N];
    load_struct<T>(rows, number);
    for (Dim i = 0; i < N; ++i) {
      min.at[i] = number[i];
      max.at[i] = number[N + i];
    }
  }
};

template <Dim N, class T>
struct LaneObb {
  LaneVec<N, T> center;
  LaneVec<N, T> half;
  LaneVec<N, T> axes[N];

  template <RowsOf<T> Rows>
  HWY_INLINE explicit LaneObb(const Rows& rows) {
    Lanes<T> number[2 * N + N * N];
    load_struct<T>(rows, number);
    set(number);
  }

  /// Takes numbers in the order of the struct.
  HWY_INLINE explicit LaneObb(const Lanes<T> (&number)[2 * N + N * N]) { set(number); }

  /// The oriented box of an AABB's size around the origin: far from the origin, its center would be rounded.
  HWY_INLINE explicit LaneObb(const LaneAabb<N, T>& box) {
    for (Dim i = 0; i < N; ++i) {
      center.at[i] = hn::Zero(Tag<T>());
      half.at[i] = hn::Mul(all(T(0.5)), hn::Sub(box.max.at[i], box.min.at[i]));
      for (Dim k = 0; k < N; ++k) axes[i].at[k] = all(T(i == k ? 1 : 0));
    }
  }

 private:
  HWY_INLINE void set(const Lanes<T> (&number)[2 * N + N * N]) {
    unrolled<N>([&](auto i) GRAZE_INLINE_LAMBDA {
      center.at[i] = number[i];
      half.at[i] = number[N + i];
      unrolled<N>([&](auto k) GRAZE_INLINE_LAMBDA { axes[i].at[k] = number[2 * N + i * N + k]; });
    });
  }
};

/// A capsule; a sphere is a capsule of length zero.
template <Dim N, class T>
struct LaneCapsule {
  LaneVec<N, T> start;
  LaneVec<N, T> along;  ///< From start to end.
  Lanes<T> radius;

  template <RowsOf<T> Rows>
  HWY_INLINE explicit LaneCapsule(const Rows& rows) {
    Lanes<T> number[2 * N + 1];
    load_struct<T>(rows, number);
    for (Dim i = 0; i < N; ++i) {
      start.at[i] = number[i];
      along.at[i] = hn::Sub(number[N + i], number[i]);
    }
    radius = number[2 * N];
  }

  HWY_INLINE explicit LaneCapsule(const LaneSphere<N, T>& sphere) : start(sphere.center), radius(sphere.radius) {
    for (Dim i = 0; i < N; ++i) along.at[i] = hn::Zero(Tag<T>());
  }
};

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
