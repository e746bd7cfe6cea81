// SPDX-License-Identifier: MIT
// Contacts of 3D spheres, capsules and boxes, one pair per lane, and loading their numbers. Included once per
// instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_CONTACTS_FAST_CONTACT_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_FAST_CONTACT_INL_HPP
#undef GRAZE_BROAD_CONTACTS_FAST_CONTACT_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_FAST_CONTACT_INL_HPP
#endif

#include <cstddef>
#include <limits>
#include <type_traits>

#include <hwy/highway.h>

#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/broad/contacts/many_pairs-inl.hpp>
#include <graze/broad/contacts/obb/axes-inl.hpp>
#include <graze/math/tolerance.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

// The order matters.
// clang-format off
#include <graze/query/fast_contact/spheres_and_capsules-inl.hpp>
#include <graze/query/fast_contact/sphere_box-inl.hpp>
#include <graze/query/fast_contact/minimum_translation-inl.hpp>
#include <graze/query/fast_contact/axis_over_face-inl.hpp>
#include <graze/query/fast_contact/capsule_box-inl.hpp>
// clang-format on

/// Whether products of four such lengths stay in the range of double: other pairs are left to the single query, which
/// scales.
HWY_INLINE Mask is_usual_size(Real size) { return size > 0x1p-200 && size < 0x1p200; }

/// The first numbers of each lane's struct, in double.
template <class T, std::size_t count>
HWY_INLINE void load_wide(const T* const* rows, Real (&numbers)[count]) {
  if constexpr (std::is_same_v<T, double>) {
    load_struct<double>(rows, numbers);
  } else {
    for (std::size_t k = 0; k < count; ++k) {
      Row<double> column;
      for (std::size_t lane = 0; lane < pairs_at_once; ++lane) column.of[lane] = static_cast<double>(rows[lane][k]);
      numbers[k] = hn::Load(Tag<double>(), column.of);
    }
  }
}

/// A position from the coordinates at these addresses.
template <Dim N>
HWY_INLINE LaneVec<N, double> place_at(const Real* numbers) {
  if constexpr (N == 2) return {{numbers[0], numbers[1]}};
  if constexpr (N == 3) return {{numbers[0], numbers[1], numbers[2]}};
}

template <Dim N, class T>
HWY_INLINE SphereNumbers<LaneVec<N, double>> load_spheres(const T* const* rows) {
  Real numbers[N + 1];
  load_wide(rows, numbers);
  return {place_at<N>(numbers), numbers[N]};
}

template <Dim N, class T>
HWY_INLINE CapsuleNumbers<LaneVec<N, double>> load_capsules(const T* const* rows) {
  Real numbers[2 * N + 1];
  load_wide(rows, numbers);
  return {place_at<N>(numbers), place_at<N>(numbers + N), numbers[2 * N]};
}

/// Boxes relative to a point, AABBs if `along`, otherwise oriented ones. Written in place, number by number: copies of
/// rows of vectors go through memory.
template <bool along, class T>
HWY_INLINE void load_boxes_from(const Point& origin, const T* const* rows, BoxNumbers<along>& box) {
  if constexpr (along) {
    Real numbers[6];
    load_wide(rows, numbers);
    const Point min = place_at<3>(numbers);
    const Point max = place_at<3>(numbers + 3);
    box.center = ((min - origin) + (max - origin)) * all(0.5);
    box.half = (max - min) * all(0.5);
  } else {
    Real numbers[15];
    load_numbers_of_boxes(rows, numbers);
    box.center = place_at<3>(numbers) - origin;
    box.half = place_at<3>(numbers + 3);
    unrolled<9>([&](auto i) GRAZE_INLINE_LAMBDA { box.axes[i / 3].at[i % 3] = numbers[6 + i]; });
  }
}

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
