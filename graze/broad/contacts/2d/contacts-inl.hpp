// SPDX-License-Identifier: MIT
// The manifolds of many pairs of capsules and boxes in the plane. Included once for each instruction set, hence no
// ordinary guard.
#if defined(GRAZE_BROAD_CONTACTS_2D_CONTACTS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_2D_CONTACTS_INL_HPP
#undef GRAZE_BROAD_CONTACTS_2D_CONTACTS_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_2D_CONTACTS_INL_HPP
#endif

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include <graze/broad/contacts/2d/aabb-inl.hpp>
#include <graze/broad/contacts/2d/boxes-inl.hpp>
#include <graze/broad/contacts/2d/contact_kernels_2d.hpp>
#include <graze/broad/contacts/2d/cores-inl.hpp>
#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/broad/contacts/manifold_points-inl.hpp>
#include <graze/broad/contacts/round_lanes-inl.hpp>
#include <graze/query/manifold.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

/// The manifolds of a group of pairs, to be written one by one.
template <class T>
class FlatContacts {
 public:
  HWY_INLINE FlatContacts(const FlatLookLanes& look, std::uint32_t turned)
      : clear_(bits_of<double>(look.is_clear)), two_(bits_of<double>(look.has_two)), turned_(turned) {
    const DoublesMask turns = mask_of(Tag<double>(), turned);
    rows_.set(in_space(look.normal), look.error, turns);
    for (std::size_t i = 0; i < 2; ++i) {
      const FlatPointLanes& point = look.points[i];
      const FlatPoint middle = point.on_first * both(0.5) + point.on_second * both(0.5);
      points_[i].set(in_space(point.on_first), in_space(point.on_second), in_space(middle), point.depth, turns);
      store(point.of_first, features_[i][0]);
      store(point.of_second, features_[i][1]);
    }
  }

  bool is_clear(std::size_t lane) const { return (clear_ >> lane & 1U) != 0; }

  void write(std::size_t lane, Manifold<2, T>& to) const {
    write_point(0, lane, to.points[0]);
    const std::size_t size = 1 + (two_ >> lane & 1U);
    if (size > 1) write_point(1, lane, to.points[1]);
    rows_.write(lane, size, to);
  }

 private:
  void write_point(std::size_t place, std::size_t lane, ManifoldPoint<2, T>& to) const {
    const std::size_t first = turned_ >> lane & 1U;
    points_[place].write(lane, to);
    write_feature(feature(place, first, lane), to.id.a);
    write_feature(feature(place, 1 - first, lane), to.id.b);
  }

  const Feature& feature(std::size_t place, std::size_t of_second, std::size_t lane) const {
    return (*all_features_)[static_cast<std::size_t>(features_[place][of_second].of[lane])];
  }

  const TouchedFeatures* all_features_ = &touched_features();
  std::uint32_t clear_;
  std::uint32_t two_;
  std::uint32_t turned_;
  ManifoldRows<T, 2> rows_;
  PointRows<T, 2> points_[2];
  Row<double> features_[2][2];
};

// ---- Where a pair is seen from, as flat_origin

HWY_INLINE FlatPoint flat_origin_of(const CapsuleLanes& capsule) { return in_plane(capsule.start); }
HWY_INLINE FlatPoint flat_origin_of(const FlatObbLanes& box) { return box.center; }
HWY_INLINE FlatPoint flat_origin_of(const FlatAabbLanes& box) { return box.min; }

template <class T, class First, class Second>
HWY_INLINE FlatContacts<T> flat_contacts_of(const First& first, const Second& second, std::uint32_t turned) {
  const FlatPoint origin = flat_origin_of(first);
  const auto core_of_first = flat_core_of(first, origin);
  const auto core_of_second = flat_core_of(second, origin);
  FlatLookLanes look;
  FlatTouchLanes(origin, core_of_first, core_of_second).run(look);
  return FlatContacts<T>(look, turned);
}

/// Of shapes whose numbers lie at these places.
template <FlatKind kind, class T>
HWY_INLINE FlatContacts<T> flat_contacts(const T* const* first, const T* const* second, std::uint32_t turned) {
  if constexpr (kind == FlatKind::obb_obb) {
    return flat_contacts_of<T>(FlatObbLanes(first), FlatObbLanes(second), turned);
  } else if constexpr (kind == FlatKind::aabb_aabb) {
    const FlatAabbLanes a(first);
    const FlatAabbLanes b(second);
    FlatLookLanes look;
    FlatAabbTouch(a, b).run(look);
    return FlatContacts<T>(look, turned);
  } else if constexpr (kind == FlatKind::obb_aabb) {
    return flat_contacts_of<T>(FlatObbLanes(first), FlatAabbLanes(second), turned);
  } else {
    const CapsuleLanes capsule = CapsuleLanes::load<2>(second);
    if constexpr (kind == FlatKind::obb_capsule) {
      return flat_contacts_of<T>(FlatObbLanes(first), capsule, turned);
    } else if constexpr (kind == FlatKind::aabb_capsule) {
      return flat_contacts_of<T>(FlatAabbLanes(first), capsule, turned);
    } else {
      return flat_contacts_of<T>(CapsuleLanes::load<2>(first), capsule, turned);
    }
  }
}

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
