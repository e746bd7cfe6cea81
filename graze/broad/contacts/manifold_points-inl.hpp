// SPDX-License-Identifier: MIT
// Converts the results of kernels for many pairs to their manifolds, rounded as ObbPoints of
// query/fast_contact/obb/manifold.hpp. Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_CONTACTS_MANIFOLD_POINTS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_MANIFOLD_POINTS_INL_HPP
#undef GRAZE_BROAD_CONTACTS_MANIFOLD_POINTS_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_MANIFOLD_POINTS_INL_HPP
#endif

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include <hwy/highway.h>

#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/broad/contacts/obb/choice-inl.hpp>
#include <graze/query/contact/boxes.hpp>
#include <graze/query/manifold.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

HWY_INLINE void store(Bits v, Row<std::uint64_t>& row) { hn::Store(v, BitsTag(), row.of); }
HWY_INLINE void store(Doubles v, Row<double>& row) { hn::Store(v, Tag<double>(), row.of); }
HWY_INLINE void store(Doubles v, Row<float>& row) { hn::Store(narrowed(v), FloatTag(), row.of); }

/// Adding zero turns -0 into +0.
HWY_INLINE void store_rounded(Doubles v, Row<double>& row) { hn::Store(hn::Add(v, both(0)), Tag<double>(), row.of); }
HWY_INLINE void store_rounded(Doubles v, Row<float>& row) {
  hn::Store(hn::Add(narrowed(v), hn::Zero(FloatTag())), FloatTag(), row.of);
}

/// A contact point of each pair: three positions and the depth.
template <class T, Dim N = 3>
struct PointRows {
  using V = LaneVec<N, double>;

  Row<T> point[N];
  Row<T> point_a[N];
  Row<T> point_b[N];
  Row<T> depth;

  /// `first` is on the user's second box if `turns`.
  HWY_INLINE void set(const V& first, const V& second, Doubles its_depth, DoublesMask turns) {
    set(first, second, (first + second) * both(0.5), its_depth, turns);
  }

  HWY_INLINE void set(const V& first, const V& second, const V& middle, Doubles its_depth, DoublesMask turns) {
    for (std::size_t k = 0; k < N; ++k) {
      const Doubles a = first.at[k];
      const Doubles b = second.at[k];
      store_rounded(middle.at[k], point[k]);
      store_rounded(hn::IfThenElse(turns, b, a), point_a[k]);
      store_rounded(hn::IfThenElse(turns, a, b), point_b[k]);
    }
    store(its_depth, depth);
  }

  void write(std::size_t lane, ManifoldPoint<N, T>& to) const {
    for (Dim k = 0; k < N; ++k) {
      to.point[k] = point[k].of[lane];
      to.point_a[k] = point_a[k].of[lane];
      to.point_b[k] = point_b[k].of[lane];
    }
    to.depth = depth.of[lane];
  }
};

#if HWY_TARGET <= HWY_AVX3
template <class T>
struct PointRows<T, 3> {
  alignas(64) T first_eight[pairs_at_once][8];
  Row<T> ninth;
  Row<T> depth;

  /// `first` is on the user's second box if `turns`.
  HWY_INLINE void set(const Point& first, const Point& second, Doubles its_depth, DoublesMask turns) {
    set(first, second, (first + second) * both(0.5), its_depth, turns);
  }

  HWY_INLINE void set(const Point& first, const Point& second, const Point& middle, Doubles its_depth,
                      DoublesMask turns) {
    __m512d rows[8];
    __m512d last{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Doubles a = first.at[k];
      const Doubles b = second.at[k];
      rows[k] = middle.at[k].raw;
      rows[3 + k] = hn::IfThenElse(turns, b, a).raw;
      (k < 2 ? rows[6 + k] : last) = hn::IfThenElse(turns, a, b).raw;
    }
    Doubles of_pairs[8];
    transpose_eight(rows, of_pairs);
    for (std::size_t lane = 0; lane < pairs_at_once; ++lane) {
      if constexpr (std::is_same_v<T, double>) {
        hn::Store(hn::Add(of_pairs[lane], both(0)), Tag<double>(), first_eight[lane]);
      } else {
        hn::Store(hn::Add(narrowed(of_pairs[lane]), hn::Zero(FloatTag())), FloatTag(), first_eight[lane]);
      }
    }
    store_rounded(Doubles{last}, ninth);
    store(its_depth, depth);
  }

  void write(std::size_t lane, ManifoldPoint<3, T>& to) const {
    static_assert(sizeof(to.point) + sizeof(to.point_a) + sizeof(to.point_b) == 9 * sizeof(T));
    std::memcpy(reinterpret_cast<char*>(&to), first_eight[lane], sizeof(first_eight[lane]));
    to.point_b.z = ninth.of[lane];
    to.depth = depth.of[lane];
  }
};
#endif

/// A manifold without its points.
template <class T, Dim N = 3>
struct ManifoldRows {
  Row<T> normal[N];
  Row<double> error;

  HWY_INLINE void set(const AxisLanes& axis, Doubles size, DoublesMask turned) {
    set(axis.normal, hn::Add(max_of(both(0), axis.gap), hn::Mul(both(boxes_error), size)), turned);
  }

  HWY_INLINE void set(const LaneVec<N, double>& its_normal, Doubles its_error, DoublesMask turned) {
    const Doubles side = hn::IfThenElse(turned, both(-1), both(1));
    for (std::size_t k = 0; k < N; ++k) store_rounded(hn::Mul(its_normal.at[k], side), normal[k]);
    store(its_error, error);
  }

  void write(std::size_t lane, std::size_t size, Manifold<N, T>& to) const {
    to.size = size;
    for (Dim k = 0; k < N; ++k) to.normal[k] = normal[k].of[lane];
    to.error = error.of[lane];
  }
};

/// Copied as a whole, including the padding, which takes half as long.
HWY_INLINE void write_feature(const Feature& from, Feature& to) { std::memcpy(&to, &from, sizeof(to)); }

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
