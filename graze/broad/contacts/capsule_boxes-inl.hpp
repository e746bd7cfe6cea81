// SPDX-License-Identifier: MIT
// The manifolds of many pairs of 3D capsules and boxes. Included once per instruction set, so it has no ordinary
// include guard.
#if defined(GRAZE_BROAD_CONTACTS_CAPSULE_BOXES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_CAPSULE_BOXES_INL_HPP
#undef GRAZE_BROAD_CONTACTS_CAPSULE_BOXES_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_CAPSULE_BOXES_INL_HPP
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

/// The manifolds of a group of pairs of capsules and boxes, written one by one.
template <class T>
class CapsuleContacts {
 public:
  HWY_INLINE CapsuleContacts(const CapsuleAndBox& pair, CapsuleContact& contact, std::uint32_t turned)
      : turned_(turned) {
    const Mask turns = hn::Not(mask_of(Tag<double>(), turned));  // the calculation goes from the box to the capsule
    rows_.set(contact.normal, contact.error, turns);
    Mask is_clear = contact.meets && is_usual_size(pair.size) && (contact.is_over || contact.is_single);
    if (any(contact.is_over)) {
      CapsulePoint ends[2];
      const Mask is_told = contact.over.put_points(ends);
      is_clear = is_clear && (is_told || !contact.is_over);
      take_point(contact.is_over, ends[0], contact.point);
      put_point(ends[1], turns, 1);
    }
    put_point(contact.point, turns, 0);
    clear_ = bits_of<double>(is_clear);
    two_ = bits_of<double>(contact.is_over);
  }

  bool is_clear(std::size_t lane) const { return (clear_ >> lane & 1U) != 0; }

  void write(std::size_t lane, Manifold<3, T>& to) const {
    write_point(0, lane, to.points[0]);
    const std::size_t size = 1 + (two_ >> lane & 1U);
    if (size > 1) write_point(1, lane, to.points[1]);
    rows_.write(lane, size, to);
  }

 private:
  HWY_INLINE void put_point(const CapsulePoint& point, const Mask& turns, std::size_t place) {
    points_[place].set(point.on_box, point.on_capsule, point.depth, turns);
    store(point.of_capsule, features_[place][0]);
    store(point.of_box, features_[place][1]);
  }

  void write_point(std::size_t place, std::size_t lane, ManifoldPoint<3, T>& to) const {
    const std::size_t first = turned_ >> lane & 1U;
    points_[place].write(lane, to);
    write_feature(feature(place, first, lane), to.id.a);
    write_feature(feature(place, 1 - first, lane), to.id.b);
  }

  const Feature& feature(std::size_t place, std::size_t of_box, std::size_t lane) const {
    return (*all_features_)[static_cast<std::size_t>(features_[place][of_box].of[lane])];
  }

  const TouchedFeatures* all_features_ = &touched_features();
  std::uint32_t clear_;
  std::uint32_t two_;
  std::uint32_t turned_;
  ManifoldRows<T> rows_;
  PointRows<T> points_[2];
  Row<double> features_[2][2];
};

template <PrimitiveKind kind, class T>
HWY_INLINE CapsuleContacts<T> capsule_contacts(const T* const* capsules, const T* const* boxes, std::uint32_t turned) {
  const CapsuleNumbers<Point> capsule = load_capsules<3>(capsules);
  constexpr bool along = kind == PrimitiveKind::capsule_aabb;
  BoxNumbers<along> box;
  load_boxes_from(capsule.start, boxes, box);
  CapsuleAndBox pair;
  pair.origin = capsule.start;
  pair.way = capsule.end - capsule.start;
  pair.radius = capsule.radius;
  pair.center = box.center;
  pair.half = box.half;
  unrolled<9>([&](auto i) GRAZE_INLINE_LAMBDA {
    if constexpr (along) {
      pair.axes[i / 3].at[i % 3] = all(i / 3 == i % 3 ? 1.0 : 0.0);
    } else {
      pair.axes[i / 3].at[i % 3] = box.axes[i / 3].at[i % 3];
    }
  });
  pair.find_size();
  CapsuleContact contact;
  contact.normal = zero<Point>();
  contact.point = {zero<Point>(), zero<Point>(), all(0.0), all(first_vertex), all(first_vertex)};
  CapsuleOnBox(pair, contact).run();
  return CapsuleContacts<T>(pair, contact, turned);
}

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
