// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file again for each.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <graze/broad/contacts/contact_kernels.hpp>
#include <graze/broad/simd/choice.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/contacts/contact_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

// Vectors of two doubles gain nothing over single calls; with them, all pairs are left.
#undef GRAZE_PRIMITIVE_LANES
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_WASM && HWY_HAVE_FLOAT64
#define GRAZE_PRIMITIVE_LANES (HWY_MAX_BYTES >= 32 && HWY_NATIVE_FMA)
#include <graze/broad/contacts/aabb_contacts-inl.hpp>
#include <graze/broad/contacts/capsule_boxes-inl.hpp>
#include <graze/broad/contacts/contact_groups-inl.hpp>
#include <graze/broad/contacts/round_contacts-inl.hpp>
#else
#define GRAZE_PRIMITIVE_LANES 0
#endif

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

#if GRAZE_PRIMITIVE_LANES

/// The manifolds of a group of pairs, whose numbers are at these addresses.
template <PrimitiveKind kind, class T>
HWY_INLINE auto contacts_of_group(const T* const* first, const T* const* second, std::uint32_t turned) {
  if constexpr (kind == PrimitiveKind::aabb_aabb) {
    return AabbContacts<T>(AabbLanes(first), AabbLanes(second), turned);
  } else if constexpr (kind == PrimitiveKind::capsule_aabb || kind == PrimitiveKind::capsule_obb) {
    return capsule_contacts<kind>(first, second, turned);
  } else {
    return RoundContacts<T>(contact_of<kind>(first, second), turned);
  }
}

template <PrimitiveKind kind, class T>
std::size_t contact_primitives(std::span<const PrimitivesToContact<3, T>> pairs, std::uint32_t* left) {
  return contact_groups<3, T>(
      pairs, left,
      [](const T* const* first, const T* const* second, std::uint32_t turned)
          HWY_ATTR GRAZE_INLINE_LAMBDA { return contacts_of_group<kind>(first, second, turned); });
}

template <class T>
constexpr ContactKernels<T> kernels_of = {
    contact_primitives<PrimitiveKind::sphere_sphere, T>,   contact_primitives<PrimitiveKind::sphere_capsule, T>,
    contact_primitives<PrimitiveKind::capsule_capsule, T>, contact_primitives<PrimitiveKind::sphere_aabb, T>,
    contact_primitives<PrimitiveKind::sphere_obb, T>,      contact_primitives<PrimitiveKind::aabb_aabb, T>,
    contact_primitives<PrimitiveKind::capsule_aabb, T>,    contact_primitives<PrimitiveKind::capsule_obb, T>};

#else

template <class T>
std::size_t leave_primitives(std::span<const PrimitivesToContact<3, T>> pairs, std::uint32_t* left) {
  return leave_all(pairs.size(), left);
}

template <class T>
constexpr ContactKernels<T> kernels_of = {leave_primitives<T>, leave_primitives<T>, leave_primitives<T>,
                                          leave_primitives<T>, leave_primitives<T>, leave_primitives<T>,
                                          leave_primitives<T>, leave_primitives<T>};

#endif

}  // namespace

const AllContactKernels& all_contact_kernels() {
  static const AllContactKernels kernels{kernels_of<float>, kernels_of<double>};
  return kernels;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_contact_kernels);
}

template <class T>
const ContactKernels<T>& contact_kernels() {
  return HWY_DYNAMIC_DISPATCH(all_contact_kernels)().template of<T>();
}

template const ContactKernels<float>& contact_kernels<float>();
template const ContactKernels<double>& contact_kernels<double>();

}  // namespace graze::detail
#endif
