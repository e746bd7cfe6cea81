// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file anew for each.
#include <cstddef>
#include <cstdint>
#include <span>

#include <graze/broad/contacts/2d/contact_kernels_2d.hpp>
#include <graze/broad/simd/choice.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/contacts/2d/contact_kernels_2d.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

// Vectors of two doubles gain nothing over single calls. Elsewhere all pairs are left.
#undef GRAZE_FLAT_LANES
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_WASM && HWY_HAVE_FLOAT64
#define GRAZE_FLAT_LANES (HWY_MAX_BYTES >= 32 && HWY_NATIVE_FMA)
#include <graze/broad/contacts/2d/contacts-inl.hpp>
#include <graze/broad/contacts/2d/sphere-inl.hpp>
#include <graze/broad/contacts/contact_groups-inl.hpp>
#include <graze/broad/contacts/round_contacts-inl.hpp>
#else
#define GRAZE_FLAT_LANES 0
#endif

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

#if GRAZE_FLAT_LANES

/// Of a ball and what is named second, as their numbers lie in memory.
template <FlatKind kind, class T>
HWY_INLINE RoundTouch flat_ball_touch(const T* const* first, const T* const* second) {
  const BallLanes ball = BallLanes::load<2>(first);
  if constexpr (kind == FlatKind::sphere_sphere) {
    return touch_lanes(ball, BallLanes::load<2>(second));
  } else if constexpr (kind == FlatKind::sphere_capsule) {
    return touch_lanes<2>(ball, CapsuleLanes::load<2>(second));
  } else if constexpr (kind == FlatKind::sphere_aabb) {
    return FlatBallLanes(ball, flat_core_of(FlatAabbLanes(second), in_plane(ball.center))).run();
  } else {
    return FlatBallLanes(ball, flat_core_of(FlatObbLanes(second), in_plane(ball.center))).run();
  }
}

template <FlatKind kind, class T>
std::size_t contact_flat(std::span<const PrimitivesToContact<2, T>> pairs, std::uint32_t* left) {
  if constexpr (kind <= FlatKind::sphere_capsule) {
    return contact_groups<2, T>(pairs, left,
                                [](const T* const* first, const T* const* second, std::uint32_t turned) HWY_ATTR {
                                  return RoundContacts<T, 2>(flat_ball_touch<kind>(first, second), turned);
                                });
  } else {
    return contact_groups<2, T>(pairs, left,
                                [](const T* const* first, const T* const* second, std::uint32_t turned)
                                    HWY_ATTR { return flat_contacts<kind>(first, second, turned); });
  }
}

#else

template <FlatKind /*kind*/, class T>
std::size_t contact_flat(std::span<const PrimitivesToContact<2, T>> pairs, std::uint32_t* left) {
  return leave_all(pairs.size(), left);
}

#endif

template <class T>
constexpr FlatKernels<T> flat_kernels_of = {
    contact_flat<FlatKind::sphere_sphere, T>, contact_flat<FlatKind::sphere_obb, T>,
    contact_flat<FlatKind::sphere_aabb, T>,   contact_flat<FlatKind::sphere_capsule, T>,
    contact_flat<FlatKind::obb_obb, T>,       contact_flat<FlatKind::obb_aabb, T>,
    contact_flat<FlatKind::obb_capsule, T>,   contact_flat<FlatKind::aabb_aabb, T>,
    contact_flat<FlatKind::aabb_capsule, T>,  contact_flat<FlatKind::capsule_capsule, T>};

}  // namespace

const AllFlatKernels& all_flat_kernels() {
  static const AllFlatKernels kernels{flat_kernels_of<float>, flat_kernels_of<double>};
  return kernels;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_flat_kernels);
}

template <class T>
const FlatKernels<T>& flat_kernels() {
  return HWY_DYNAMIC_DISPATCH(all_flat_kernels)().template of<T>();
}

template const FlatKernels<float>& flat_kernels<float>();
template const FlatKernels<double>& flat_kernels<double>();

}  // namespace graze::detail
#endif
