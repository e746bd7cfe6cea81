// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file anew for each.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <graze/broad/round_kernels.hpp>
#include <graze/broad/simd_choice.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/round_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

// Vectors of two doubles gain nothing over single calls. Elsewhere all pairs are left.
#undef GRAZE_ROUND_LANES
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_WASM && HWY_HAVE_FLOAT64
#define GRAZE_ROUND_LANES (HWY_MAX_BYTES >= 32 && HWY_NATIVE_FMA)
#include <graze/broad/aabb_contacts-inl.hpp>
#include <graze/broad/capsule_boxes-inl.hpp>
#include <graze/broad/round_contacts-inl.hpp>
#else
#define GRAZE_ROUND_LANES 0
#endif

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

#if GRAZE_ROUND_LANES

/// The manifolds of a group of pairs, whose numbers lie at these places.
template <RoundKind kind, class T>
HWY_INLINE auto contacts_of_group(const T* const* first, const T* const* second, std::uint32_t turned) {
  if constexpr (kind == RoundKind::aabb_aabb) {
    return AabbContacts<T>(AabbLanes(first), AabbLanes(second), turned);
  } else if constexpr (kind == RoundKind::capsule_aabb || kind == RoundKind::capsule_obb) {
    return capsule_contacts<kind>(first, second, turned);
  } else {
    return RoundContacts<T>(touch_of<kind>(first, second), turned);
  }
}

template <RoundKind kind, class T>
std::size_t contact_rounds(std::span<const RoundsToContact<T>> pairs, std::uint32_t* left) {
  std::size_t left_count = 0;
  for (std::size_t from = 0; from < pairs.size(); from += pairs_at_once) {
    const std::size_t count = std::min(pairs_at_once, pairs.size() - from);
    const T* first[pairs_at_once];
    const T* second[pairs_at_once];
    std::uint32_t turned = 0;
    for (std::size_t lane = 0; lane < pairs_at_once; ++lane) {
      const RoundsToContact<T>& pair = pairs[lane < count ? from + lane : from];
      first[lane] = pair.first;
      second[lane] = pair.second;
      turned |= std::uint32_t{pair.turned} << lane;
    }
    const auto contacts = contacts_of_group<kind>(first, second, turned);
    for (std::size_t lane = 0; lane < count; ++lane) {
      if (HWY_LIKELY(contacts.is_clear(lane))) {
        contacts.write(lane, *pairs[from + lane].manifold);
      } else {
        left[left_count++] = static_cast<std::uint32_t>(from + lane);
      }
    }
  }
  return left_count;
}

template <class T>
constexpr RoundKernels<T> kernels_of = {
    contact_rounds<RoundKind::sphere_sphere, T>,   contact_rounds<RoundKind::sphere_capsule, T>,
    contact_rounds<RoundKind::capsule_capsule, T>, contact_rounds<RoundKind::sphere_aabb, T>,
    contact_rounds<RoundKind::sphere_obb, T>,      contact_rounds<RoundKind::aabb_aabb, T>,
    contact_rounds<RoundKind::capsule_aabb, T>,    contact_rounds<RoundKind::capsule_obb, T>};

#else

template <class T>
std::size_t leave_rounds(std::span<const RoundsToContact<T>> pairs, std::uint32_t* left) {
  for (std::size_t i = 0; i < pairs.size(); ++i) left[i] = static_cast<std::uint32_t>(i);
  return pairs.size();
}

template <class T>
constexpr RoundKernels<T> kernels_of = {leave_rounds<T>, leave_rounds<T>, leave_rounds<T>, leave_rounds<T>,
                                        leave_rounds<T>, leave_rounds<T>, leave_rounds<T>, leave_rounds<T>};

#endif

}  // namespace

const AllRoundKernels& all_round_kernels() {
  static const AllRoundKernels kernels{kernels_of<float>, kernels_of<double>};
  return kernels;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_round_kernels);
}

template <class T>
const RoundKernels<T>& round_kernels() {
  const AllRoundKernels& kernels = HWY_DYNAMIC_DISPATCH(all_round_kernels)();
  if constexpr (std::is_same_v<T, float>) {
    return kernels.of_floats;
  } else {
    return kernels.of_doubles;
  }
}

template const RoundKernels<float>& round_kernels<float>();
template const RoundKernels<double>& round_kernels<double>();

}  // namespace graze::detail
#endif
