// SPDX-License-Identifier: MIT
// The manifolds of many pairs that touch in one point: spheres and capsules, or spheres and boxes. Included once per
// instruction set, so it has no ordinary include guard.
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
#include <graze/broad/contacts/fast_contact-inl.hpp>
#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/broad/contacts/manifold_points-inl.hpp>
#include <graze/query/manifold.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

/// Loads each lane's pair from the addresses of their numbers.
template <PrimitiveKind kind, class T>
HWY_INLINE RoundContact<Point> contact_of(const T* const* first, const T* const* second) {
  if constexpr (kind == PrimitiveKind::sphere_sphere) {
    return contact_of(load_spheres<3>(first), load_spheres<3>(second));
  } else if constexpr (kind == PrimitiveKind::sphere_capsule) {
    return contact_of(load_spheres<3>(first), load_capsules<3>(second));
  } else if constexpr (kind == PrimitiveKind::capsule_capsule) {
    return contact_of(load_capsules<3>(first), load_capsules<3>(second));
  } else {
    constexpr bool along = kind == PrimitiveKind::sphere_aabb;
    const SphereNumbers<Point> sphere = load_spheres<3>(first);
    BoxNumbers<along> box;
    load_boxes_from(sphere.center, second, box);
    SphereOnBox<along> pair(sphere, box);
    RoundContact<Point> contact = pair.run();
    contact.meets = contact.meets && is_usual_size(pair.size());
    return contact;
  }
}

/// The manifolds of a group of pairs, written one by one.
template <class T, Dim N = 3>
class RoundContacts {
 public:
  HWY_INLINE RoundContacts(const RoundContact<LaneVec<N, double>>& contact, std::uint32_t turned)
      : clear_(bits_of<double>(contact.meets && contact.is_single)), turned_(turned) {
    const Mask turns = mask_of(Tag<double>(), turned);
    rows_.set(contact.normal, contact.error, turns);
    point_.set(contact.on_first, contact.on_second, contact.depth, turns);
    store(contact.of_first, features_[0]);
    store(contact.of_second, features_[1]);
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
