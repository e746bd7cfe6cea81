// SPDX-License-Identifier: MIT
// Two boxes in space, of which one at least is oriented, as the quick way of their contact sees them: in double, from a
// point near both. Include closest_points.hpp.
#pragma once

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/obb_axes.hpp>
#include <graze/query/oriented_box.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// Two oriented boxes, seen from the first one's center.
template <class T>
class SeenObbs {
 public:
  [[gnu::always_inline]] SeenObbs(const Obb<3, T>& first, const Obb<3, T>& second) : first_(first), second_(second) {}

  [[gnu::always_inline]] Vec<3, double> origin() const { return reference(first_); }

  /// The boxes, and where their centers are seen.
  [[gnu::always_inline]] const Obb<3, T>& first() const { return first_; }
  [[gnu::always_inline]] const Obb<3, T>& second() const { return second_; }
  [[gnu::always_inline]] Vec<3, double> first_center() const { return Vec<3, double>(0.0); }
  [[gnu::always_inline]] Vec<3, double> second_center() const { return reference(second_) - reference(first_); }

  /// The same for the careful way.
  Obb<3, double> first_seen() const { return seen_from(origin(), first_); }
  Obb<3, double> second_seen() const { return seen_from(origin(), second_); }

  [[gnu::always_inline]] ObbAxes axes() const { return axes_of(first_, second_); }
  bool are_apart_for_certain() const { return decide(first_, second_) == Relation::apart; }

  /// What the boxes that are seen may be off, relative to their size.
  static constexpr double error = 0;

 private:
  const Obb<3, T>& first_;
  const Obb<3, T>& second_;
};

/// A box along the coordinate axes as an oriented one, and an oriented one, seen from this one's center.
template <class T>
class SeenAabbAndObb {
 public:
  SeenAabbAndObb(const Aabb<3, T>& first, const Obb<3, T>& second)
      : stored_first_(first),
        stored_second_(second),
        first_(oriented_box_from(origin(), first)),
        second_(oriented_box_from(origin(), second)) {}

  Vec<3, double> origin() const { return wide<3, T>(stored_second_.center); }

  const Obb<3, double>& first() const { return first_; }
  const Obb<3, double>& second() const { return second_; }
  const Vec<3, double>& first_center() const { return first_.center; }
  const Vec<3, double>& second_center() const { return second_.center; }
  const Obb<3, double>& first_seen() const { return first_; }
  const Obb<3, double>& second_seen() const { return second_; }

  ObbAxes axes() const { return axes_of(first_, second_); }
  bool are_apart_for_certain() const { return decide(stored_first_, stored_second_) == Relation::apart; }

  /// As oriented_box_from has it.
  static constexpr double error = 4 * tolerance::epsilon;

 private:
  const Aabb<3, T>& stored_first_;
  const Obb<3, T>& stored_second_;
  Obb<3, double> first_;
  Obb<3, double> second_;
};

/// Two boxes in the order of their contact, `turned` if that is not the one in which they are given.
template <class T>
[[gnu::always_inline]] inline SeenObbs<T> seen_in_order(const Obb<3, T>& a, const Obb<3, T>& b, bool turned) {
  return turned ? SeenObbs<T>(b, a) : SeenObbs<T>(a, b);
}
template <class T>
SeenAabbAndObb<T> seen_in_order(const Aabb<3, T>& a, const Obb<3, T>& b, bool /*turned*/) {
  return SeenAabbAndObb<T>(a, b);
}
template <class T>
SeenAabbAndObb<T> seen_in_order(const Obb<3, T>& a, const Aabb<3, T>& b, bool /*turned*/) {
  return SeenAabbAndObb<T>(b, a);
}

}  // namespace graze::detail
#endif
