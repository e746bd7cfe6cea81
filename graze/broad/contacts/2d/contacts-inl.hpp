// SPDX-License-Identifier: MIT
// The manifolds of many pairs of 2D capsules and boxes. Included once per instruction set, so it has no ordinary
// include guard.
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
#include <graze/broad/contacts/2d/fast_contact_2d-inl.hpp>
#include <graze/broad/contacts/fast_contact-inl.hpp>
#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/broad/contacts/manifold_points-inl.hpp>
#include <graze/query/manifold.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

/// The manifolds of a group of pairs, written one by one.
template <class T>
class Contacts2d {
 public:
  HWY_INLINE Contacts2d(const FastContactLanes2d& look, std::uint32_t turned)
      : clear_(bits_of<double>(look.is_clear)), two_(bits_of<double>(look.has_two)), turned_(turned) {
    const DoublesMask turns = mask_of(Tag<double>(), turned);
    rows_.set(look.normal, look.error, turns);
    for (std::size_t i = 0; i < 2; ++i) {
      const PointLanes2d& point = look.points[i];
      const Point2d middle = point.on_first * both(0.5) + point.on_second * both(0.5);
      points_[i].set(point.on_first, point.on_second, middle, point.depth, turns);
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

template <class T, class First, class Second>
HWY_INLINE Contacts2d<T> contacts_2d_of(const First& first, const Second& second, std::uint32_t turned) {
  const Point2d origin = origin_2d(first);
  const auto core_of_first = core_2d(first, origin);
  const auto core_of_second = core_2d(second, origin);
  FastContactLanes2d look;
  ContactLanes2d(origin, core_of_first, core_of_second).run(look);
  return Contacts2d<T>(look, turned);
}

/// For shapes whose numbers are at these addresses.
template <Kind2d kind, class T>
HWY_INLINE Contacts2d<T> contacts_2d(const T* const* first, const T* const* second, std::uint32_t turned) {
  if constexpr (kind == Kind2d::obb_obb) {
    return contacts_2d_of<T>(load_obbs_2d(first), load_obbs_2d(second), turned);
  } else if constexpr (kind == Kind2d::aabb_aabb) {
    const AabbNumbers2d a = load_aabbs_2d(first);
    const AabbNumbers2d b = load_aabbs_2d(second);
    FastContactLanes2d look;
    AabbContact2d(a, b).run(look);
    return Contacts2d<T>(look, turned);
  } else if constexpr (kind == Kind2d::obb_aabb) {
    return contacts_2d_of<T>(load_obbs_2d(first), load_aabbs_2d(second), turned);
  } else {
    const CapsuleNumbers<Point2d> capsule = load_capsules<2>(second);
    if constexpr (kind == Kind2d::obb_capsule) {
      return contacts_2d_of<T>(load_obbs_2d(first), capsule, turned);
    } else if constexpr (kind == Kind2d::aabb_capsule) {
      return contacts_2d_of<T>(load_aabbs_2d(first), capsule, turned);
    } else {
      return contacts_2d_of<T>(load_capsules<2>(first), capsule, turned);
    }
  }
}

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
