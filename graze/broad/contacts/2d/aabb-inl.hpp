// SPDX-License-Identifier: MIT
// Contacts of 2D AABBs, one pair per lane: bit-identical to penetration_of_simple and query/patch/aabb_manifold.hpp.
// Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_CONTACTS_2D_AABB_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_2D_AABB_INL_HPP
#undef GRAZE_BROAD_CONTACTS_2D_AABB_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_2D_AABB_INL_HPP
#endif

#include <cstddef>
#include <limits>

#include <hwy/highway.h>

#include <graze/broad/contacts/2d/boxes-inl.hpp>
#include <graze/broad/contacts/2d/fast_contact_2d-inl.hpp>
#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/math/tolerance.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

/// The contact of two boxes in their contact order.
class AabbContact2d {
 public:
  HWY_INLINE AabbContact2d(const AabbNumbers2d& a, const AabbNumbers2d& b) : a_(a), b_(b) {
    const Doubles across_x = depth_along(0, is_far_);
    DoublesMask is_far_along_y;
    const Doubles across_y = depth_along(1, is_far_along_y);
    across_second_ = hn::Lt(across_y, across_x);
    depth_ = hn::IfThenElse(across_second_, across_y, across_x);
    is_far_ = hn::Or(hn::And(across_second_, is_far_along_y), hn::AndNot(across_second_, is_far_));
  }

  HWY_INLINE void run(FastContactLanes2d& look) const {
    look.is_clear =
        hn::And(hn::And(has_faces(a_), has_faces(b_)), hn::Lt(depth_, both(std::numeric_limits<double>::infinity())));
    look.has_two = all(true);
    look.error = hn::Mul(both(tolerance::epsilon), depth_);
    const Doubles side = hn::IfThenElse(is_far_, both(1), both(-1));
    look.normal = placed(side, both(0));
    const Doubles slack = hn::Mul(both(tolerance::coarse), hn::Add(sum_abs(a_.max - a_.min), sum_abs(b_.max - b_.min)));
    const Doubles of_a = hn::IfThenElse(is_far_, across(a_.max), across(a_.min));
    const Doubles of_b = hn::IfThenElse(is_far_, across(b_.min), across(b_.max));
    for (std::size_t i = 0; i < 2; ++i) {
      const Point2d& end_of_a = i == 0 ? a_.min : a_.max;
      const Point2d& end_of_b = i == 0 ? b_.min : b_.max;
      const DoublesMask is_reference = is_beyond(i, along(end_of_b), along(end_of_a), slack);
      const Doubles place = hn::IfThenElse(is_reference, along(end_of_a), along(end_of_b));
      const Doubles end = both(i == 0 ? -1 : 1);
      PointLanes2d& point = look.points[i];
      point.on_first = placed(of_a, place);
      point.on_second = placed(of_b, place);
      point.depth = depth_;
      point.of_first =
          hn::IfThenElse(is_reference, corner_feature_2d(placed(side, end)), side_feature_2d(across_second_, side));
      point.of_second = hn::IfThenElse(is_reference, side_feature_2d(across_second_, hn::Neg(side)),
                                       corner_feature_2d(placed(hn::Neg(side), end)));
    }
  }

 private:
  /// The depth along an axis, and whether the first box's far side is in the second one.
  HWY_INLINE Doubles depth_along(std::size_t axis, DoublesMask& is_far) const {
    const Doubles ahead = hn::Sub(a_.max.at[axis], b_.min.at[axis]);
    const Doubles behind = hn::Sub(b_.max.at[axis], a_.min.at[axis]);
    is_far = hn::Le(ahead, behind);
    return min_of(ahead, behind);
  }

  HWY_INLINE static DoublesMask has_faces(const AabbNumbers2d& box) {
    return hn::And(hn::Lt(box.min.at[0], box.max.at[0]), hn::Lt(box.min.at[1], box.max.at[1]));
  }

  /// Whether an end of the second box is beyond the first one's, as in shared_range.
  HWY_INLINE static DoublesMask is_beyond(std::size_t end, Doubles of_b, Doubles of_a, Doubles slack) {
    return end == 0 ? hn::Lt(of_b, hn::Sub(of_a, slack)) : hn::Gt(of_b, hn::Add(of_a, slack));
  }

  /// The coordinate along the axis of least depth, and the one along the other axis; and a point from these two.
  HWY_INLINE Doubles across(const Point2d& v) const { return hn::IfThenElse(across_second_, v.at[1], v.at[0]); }
  HWY_INLINE Doubles along(const Point2d& v) const { return hn::IfThenElse(across_second_, v.at[0], v.at[1]); }
  HWY_INLINE Point2d placed(Doubles on_axis, Doubles on_other) const {
    return {{hn::IfThenElse(across_second_, on_other, on_axis), hn::IfThenElse(across_second_, on_axis, on_other)}};
  }

  const AabbNumbers2d& a_;
  const AabbNumbers2d& b_;
  DoublesMask across_second_;
  DoublesMask is_far_;
  Doubles depth_;
};

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
