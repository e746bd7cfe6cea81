// SPDX-License-Identifier: MIT
// The cores of 2D capsules and boxes and their contacts with spheres, one pair per lane, and loading their numbers.
// Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_CONTACTS_2D_FAST_CONTACT_2D_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_2D_FAST_CONTACT_2D_INL_HPP
#undef GRAZE_BROAD_CONTACTS_2D_FAST_CONTACT_2D_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_2D_FAST_CONTACT_2D_INL_HPP
#endif

#include <cstddef>
#include <limits>

#include <hwy/highway.h>

#include <graze/broad/contacts/fast_contact-inl.hpp>
#include <graze/broad/contacts/many_pairs-inl.hpp>
#include <graze/math/tolerance.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

// Each after what it needs.
// clang-format off
#include <graze/query/fast_contact/cores_2d-inl.hpp>
#include <graze/query/fast_contact/sphere_2d-inl.hpp>
// clang-format on

template <class T>
HWY_INLINE ObbNumbers2d load_obbs_2d(const T* const* rows) {
  Real numbers[8];
  load_wide(rows, numbers);
  return {place_at<2>(numbers), {numbers[2], numbers[3]}, {place_at<2>(numbers + 4), place_at<2>(numbers + 6)}};
}

template <class T>
HWY_INLINE AabbNumbers2d load_aabbs_2d(const T* const* rows) {
  Real numbers[4];
  load_wide(rows, numbers);
  return {place_at<2>(numbers), place_at<2>(numbers + 2)};
}

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
