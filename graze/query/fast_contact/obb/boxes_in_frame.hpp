// SPDX-License-Identifier: MIT
// Two 3D boxes, at least one of them oriented, for their fast contact: in double, relative to a point near both.
// Include closest_points.hpp.
#pragma once

#include <graze/math/vec.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/fast_contact/obb/axes.hpp>
#include <graze/query/fast_contact/oriented_box.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/fields/shape_order.hpp>
#include <graze/shape/obb.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// Two oriented boxes, relative to the first one's center.
template <class T>
class ObbsInFrame {
 public:
  [[gnu::always_inline]] ObbsInFrame(const Obb<3, T>& first, const Obb<3, T>& second)
      : first_(first), second_(second) {}

  [[gnu::always_inline]] Vec<3, double> origin() const { return reference(first_); }

  /// The boxes, and the positions of their centers.
  [[gnu::always_inline]] const Obb<3, T>& first() const { return first_; }
  [[gnu::always_inline]] const Obb<3, T>& second() const { return second_; }
  [[gnu::always_inline]] Vec<3, double> first_center() const { return Vec<3, double>(0.0); }
  [[gnu::always_inline]] Vec<3, double> second_center() const { return reference(second_) - reference(first_); }

  /// The same for the general algorithm.
  Obb<3, double> first_local() const { return relative_to(origin(), first_); }
  Obb<3, double> second_local() const { return relative_to(origin(), second_); }

  [[gnu::always_inline]] ObbAxes axes() const { return axes_of(first_, second_); }
  bool are_apart_for_certain() const { return decide(first_, second_) == Relation::apart; }

 private:
  const Obb<3, T>& first_;
  const Obb<3, T>& second_;
};

/// An oriented and an axis-aligned box, both as oriented boxes in double, relative to the oriented one's center. The
/// error of `mixed_boxes`, four half roundings of the coordinates, is within what boxes_error allows for the rounding
/// of a gap, which is twice the actual number of roundings.
struct MixedBoxes {
  Obb<3, double> oriented;
  Obb<3, double> along_axes;
};

template <class T>
MixedBoxes mixed_boxes(const Obb<3, T>& oriented, const Aabb<3, T>& along_axes) {
  const Vec<3, double> origin = wide<3, T>(oriented.center);
  return {oriented_box_from(origin, oriented), oriented_box_from(origin, along_axes)};
}

/// The same in the order of a contact: the oriented box is the first.
template <class T>
class ObbAndAabbInFrame {
 public:
  ObbAndAabbInFrame(const Obb<3, T>& first, const Aabb<3, T>& second)
      : stored_first_(first), stored_second_(second), boxes_(mixed_boxes(first, second)) {}

  Vec<3, double> origin() const { return wide<3, T>(stored_first_.center); }

  const Obb<3, double>& first() const { return boxes_.oriented; }
  const Obb<3, double>& second() const { return boxes_.along_axes; }
  Vec<3, double> first_center() const { return Vec<3, double>(0.0); }
  const Vec<3, double>& second_center() const { return second().center; }
  const Obb<3, double>& first_local() const { return first(); }
  const Obb<3, double>& second_local() const { return second(); }

  ObbAxes axes() const { return axes_of(first(), second()); }
  bool are_apart_for_certain() const { return decide(stored_second_, stored_first_) == Relation::apart; }

 private:
  const Obb<3, T>& stored_first_;
  const Aabb<3, T>& stored_second_;
  MixedBoxes boxes_;
};

/// Whether the second of two boxes is the first in the order of their contact.
template <class T>
[[gnu::always_inline]] inline bool are_turned(const Obb<3, T>& a, const Obb<3, T>& b) {
  return !is_in_order(a, b);
}
template <class T>
constexpr bool are_turned(const Aabb<3, T>& /*a*/, const Obb<3, T>& /*b*/) {
  return true;
}
template <class T>
constexpr bool are_turned(const Obb<3, T>& /*a*/, const Aabb<3, T>& /*b*/) {
  return false;
}

/// Two boxes in that order, `turned` if it is not the one in which they are given.
template <class T>
[[gnu::always_inline]] inline ObbsInFrame<T> seen_in_order(const Obb<3, T>& a, const Obb<3, T>& b, bool turned) {
  return turned ? ObbsInFrame<T>(b, a) : ObbsInFrame<T>(a, b);
}
template <class T>
ObbAndAabbInFrame<T> seen_in_order(const Aabb<3, T>& a, const Obb<3, T>& b, bool /*turned*/) {
  return ObbAndAabbInFrame<T>(b, a);
}
template <class T>
ObbAndAabbInFrame<T> seen_in_order(const Obb<3, T>& a, const Aabb<3, T>& b, bool /*turned*/) {
  return ObbAndAabbInFrame<T>(a, b);
}

}  // namespace graze::detail
#endif
