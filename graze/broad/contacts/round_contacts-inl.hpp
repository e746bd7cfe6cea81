// SPDX-License-Identifier: MIT
// The manifolds of many pairs that touch in one point: of spheres and capsules, or of spheres and boxes. Included once
// for each instruction set, hence no ordinary guard.
#if defined(GRAZE_BROAD_CONTACTS_ROUND_CONTACTS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_ROUND_CONTACTS_INL_HPP
#undef GRAZE_BROAD_CONTACTS_ROUND_CONTACTS_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_ROUND_CONTACTS_INL_HPP
#endif

#include <array>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include <graze/broad/contacts/contact_kernels.hpp>
#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/broad/contacts/manifold_points-inl.hpp>
#include <graze/broad/contacts/round_lanes-inl.hpp>
#include <graze/broad/contacts/sphere_box-inl.hpp>
#include <graze/query/manifold.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

// ---- The touch of each lane's pair, as their numbers lie in memory

template <PrimitiveKind kind, class T>
HWY_INLINE RoundTouch touch_of(const T* const* first, const T* const* second) {
  if constexpr (kind == PrimitiveKind::sphere_sphere) {
    return touch_lanes(SphereLanes::load<3>(first), SphereLanes::load<3>(second));
  } else if constexpr (kind == PrimitiveKind::sphere_capsule) {
    return touch_lanes<3>(SphereLanes::load<3>(first), CapsuleLanes::load<3>(second));
  } else if constexpr (kind == PrimitiveKind::capsule_capsule) {
    return touch_lanes(CapsuleLanes::load<3>(first), CapsuleLanes::load<3>(second));
  } else {
    constexpr bool along = kind == PrimitiveKind::sphere_aabb;
    const SphereLanes sphere = SphereLanes::load<3>(first);
    return SphereContactLanes<along>(sphere, BoxLanesInFrame<along>(second, sphere.center)).run();
  }
}

/// The manifolds of a group of pairs, to be written one by one.
template <class T, Dim N = 3>
class RoundContacts {
 public:
  HWY_INLINE RoundContacts(const RoundTouch& touch, std::uint32_t turned)
      : clear_(bits_of<double>(touch.is_clear)), turned_(turned) {
    const DoublesMask turns = mask_of(Tag<double>(), turned);
    rows_.set(touch.normal, touch.error, turns);
    point_.set(touch.on_first, touch.on_second, touch.depth, turns);
    store(touch.feature_first, features_[0]);
    store(touch.feature_second, features_[1]);
  }

  bool is_clear(std::size_t lane) const { return (clear_ >> lane & 1U) != 0; }

  void write(std::size_t lane, Manifold<N, T>& to) const {
    const std::size_t first = turned_ >> lane & 1U;
    point_.write(lane, to.points[0]);
    write_feature(feature(first, lane), to.points[0].id.a);
    write_feature(feature(1 - first, lane), to.points[0].id.b);
    rows_.write(lane, 1, to);
  }

 private:
  const Feature& feature(std::size_t of_second, std::size_t lane) const {
    return (*all_features_)[static_cast<std::size_t>(features_[of_second].of[lane])];
  }

  const TouchedFeatures* all_features_ = &touched_features();
  std::uint32_t clear_;
  std::uint32_t turned_;
  ManifoldRows<T, N> rows_;
  PointRows<T, N> point_;
  Row<double> features_[2];
};

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
