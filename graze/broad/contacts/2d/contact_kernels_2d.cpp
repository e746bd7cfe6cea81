// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file again for each.
#include <cstddef>
#include <cstdint>
#include <span>

#include <graze/broad/contacts/2d/contact_kernels_2d.hpp>
#include <graze/broad/simd/choice.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/contacts/2d/contact_kernels_2d.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

// Vectors of two doubles gain nothing over single calls; with them, all pairs are left.
#undef GRAZE_FLAT_LANES
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_WASM && HWY_HAVE_FLOAT64
#define GRAZE_FLAT_LANES (HWY_MAX_BYTES >= 32 && HWY_NATIVE_FMA)
#include <graze/broad/contacts/2d/contacts-inl.hpp>
#include <graze/broad/contacts/contact_groups-inl.hpp>
#include <graze/broad/contacts/round_contacts-inl.hpp>
#else
#define GRAZE_FLAT_LANES 0
#endif

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

#if GRAZE_FLAT_LANES

/// For a sphere and a second shape, from the addresses of their numbers.
template <Kind2d kind, class T>
HWY_INLINE RoundContact<Point2d> sphere_contact_2d(const T* const* first, const T* const* second) {
  const SphereNumbers<Point2d> sphere = load_spheres<2>(first);
  if constexpr (kind == Kind2d::sphere_sphere) {
    return contact_of(sphere, load_spheres<2>(second));
  } else if constexpr (kind == Kind2d::sphere_capsule) {
    return contact_of(sphere, load_capsules<2>(second));
  } else if constexpr (kind == Kind2d::sphere_aabb) {
    return SphereOnBox2d(sphere, core_2d(load_aabbs_2d(second), sphere.center)).run();
  } else {
    return SphereOnBox2d(sphere, core_2d(load_obbs_2d(second), sphere.center)).run();
  }
}

template <Kind2d kind, class T>
std::size_t contact_2d(std::span<const PrimitivesToContact<2, T>> pairs, std::uint32_t* left) {
  if constexpr (kind <= Kind2d::sphere_capsule) {
    return contact_groups<2, T>(pairs, left,
                                [](const T* const* first, const T* const* second, std::uint32_t turned) HWY_ATTR {
                                  return RoundContacts<T, 2>(sphere_contact_2d<kind>(first, second), turned);
                                });
  } else {
    return contact_groups<2, T>(pairs, left,
                                [](const T* const* first, const T* const* second, std::uint32_t turned)
                                    HWY_ATTR { return contacts_2d<kind>(first, second, turned); });
  }
}

#else

template <Kind2d /*kind*/, class T>
std::size_t contact_2d(std::span<const PrimitivesToContact<2, T>> pairs, std::uint32_t* left) {
  return leave_all(pairs.size(), left);
}

#endif

template <class T>
constexpr ContactKernels2d<T> contact_kernels_2d_of = {
    contact_2d<Kind2d::sphere_sphere, T>,  contact_2d<Kind2d::sphere_obb, T>, contact_2d<Kind2d::sphere_aabb, T>,
    contact_2d<Kind2d::sphere_capsule, T>, contact_2d<Kind2d::obb_obb, T>,    contact_2d<Kind2d::obb_aabb, T>,
    contact_2d<Kind2d::obb_capsule, T>,    contact_2d<Kind2d::aabb_aabb, T>,  contact_2d<Kind2d::aabb_capsule, T>,
    contact_2d<Kind2d::capsule_capsule, T>};

}  // namespace

const AllContactKernels2d& all_contact_kernels_2d() {
  static const AllContactKernels2d kernels{contact_kernels_2d_of<float>, contact_kernels_2d_of<double>};
  return kernels;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_contact_kernels_2d);
}

template <class T>
const ContactKernels2d<T>& contact_kernels_2d() {
  return HWY_DYNAMIC_DISPATCH(all_contact_kernels_2d)().template of<T>();
}

template const ContactKernels2d<float>& contact_kernels_2d<float>();
template const ContactKernels2d<double>& contact_kernels_2d<double>();

}  // namespace graze::detail
#endif
