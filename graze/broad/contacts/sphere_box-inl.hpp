// SPDX-License-Identifier: MIT
// How spheres touch boxes, a lane for each pair: the find_fast_contact of query/fast_contact/sphere_box.hpp, to the
// bit. Included once for each instruction set, hence no ordinary guard.
#if defined(GRAZE_BROAD_CONTACTS_SPHERE_BOX_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_SPHERE_BOX_INL_HPP
#undef GRAZE_BROAD_CONTACTS_SPHERE_BOX_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_SPHERE_BOX_INL_HPP
#endif

#include <cstddef>

#include <hwy/highway.h>

#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/broad/contacts/round_lanes-inl.hpp>
#include <graze/math/tolerance.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

/// A box as a sphere's center sees it, whose axes are those of the coordinates if it is `along` them.
template <bool along>
struct BoxLanesInFrame {
  Point center;
  Point half;
  Point axes[3];  ///< Not set if it is along them.

  template <class T>
  HWY_INLINE BoxLanesInFrame(const T* const* rows, const Point& origin) {
    if constexpr (along) {
      Doubles numbers[6];
      load_wide(rows, numbers);
      const Point min{{numbers[0], numbers[1], numbers[2]}};
      const Point max{{numbers[3], numbers[4], numbers[5]}};
      center = ((min - origin) + (max - origin)) * both(0.5);
      half = (max - min) * both(0.5);
    } else {
      Doubles numbers[15];
      load_numbers_of_boxes(rows, numbers);
      center = Point{{numbers[0], numbers[1], numbers[2]}} - origin;
      half = {{numbers[3], numbers[4], numbers[5]}};
      for (std::size_t i = 0; i < 3; ++i) {
        axes[i] = {{numbers[6 + 3 * i], numbers[7 + 3 * i], numbers[8 + 3 * i]}};
      }
    }
  }

  HWY_INLINE Doubles along_axis(const Point& v, std::size_t i) const { return along ? v.at[i] : dot(v, axes[i]); }
};

/// SphereContact of query/fast_contact/sphere_box.hpp.
template <bool along>
class SphereContactLanes {
 public:
  HWY_INLINE SphereContactLanes(const SphereLanes& sphere, const BoxLanesInFrame<along>& box)
      : sphere_(sphere),
        box_(box),
        size_(hn::Add(sum_abs(box.center), sum_abs(box.half))),
        place_(zero_point()),
        off_{{hn::Neg(box.center.at[0]), hn::Neg(box.center.at[1]), hn::Neg(box.center.at[2])}} {}

  HWY_INLINE RoundTouch run() {
    const Doubles whole = hn::Add(size_, sphere_.radius);
    const Doubles doubt = hn::Mul(both(tolerance::coarse), whole);
    Doubles moved = descend(hn::Eq(whole, whole));
    const Doubles first_undecided = hn::Mul(both(tolerance::box_filter * tolerance::orthonormal), whole);
    const Doubles reach = hn::Add(sphere_.radius, along ? doubt : first_undecided);
    const DoublesMask is_far = hn::Gt(dot(off_, off_), hn::Mul(reach, reach));
    if constexpr (!along) descend_to_noise(moved);
    const Doubles squared = dot(off_, off_);
    const Doubles clear = hn::Mul(both(tolerance::known_direction), size_);
    const Doubles distance = hn::Sqrt(squared);
    RoundTouch touch;
    touch.feature_first = both(0);
    touch.depth = hn::Sub(sphere_.radius, distance);
    const DoublesMask is_outside = hn::Gt(squared, hn::Mul(clear, clear));
    touch.is_clear = hn::AndNot(is_far, hn::And(is_outside, hn::Gt(touch.depth, doubt)));
    find_feature(clear, distance, touch);
    touch.normal = off_ * hn::Div(both(-1), distance);
    touch.on_first = sphere_.center + touch.normal * sphere_.radius;
    touch.on_second = sphere_.center - off_;
    const DoublesMask is_inside = hn::Not(hn::Or(is_far, is_outside));
    if (!hn::AllFalse(Tag<double>(), is_inside)) take_inside(is_inside, touch);
    touch.is_clear = hn::And(touch.is_clear, is_usual_size(whole));
    touch.error = hn::Mul(both(2 * tolerance::rounding), whole);
    return touch;
  }

 private:
  static constexpr int rounds = 5;  // as SphereContact has both
  static constexpr double shrinks_to = 4 * tolerance::orthonormal;

  /// One round, in some lanes; by how much it has moved the place.
  HWY_INLINE Doubles descend(const DoublesMask& lanes) {
    Point step;
    for (std::size_t i = 0; i < 3; ++i) {
      const Doubles wanted = hn::Add(place_.at[i], box_.along_axis(off_, i));
      const Doubles half = box_.half.at[i];
      step.at[i] = hn::Sub(min_of(max_of(wanted, hn::Neg(half)), half), place_.at[i]);
    }
    place_ = one_of(lanes, place_ + step, place_);
    if constexpr (along) {
      off_ = off_ - step;
    } else {
      off_ = one_of(lanes, ((off_ - box_.axes[0] * step.at[0]) - box_.axes[1] * step.at[1]) - box_.axes[2] * step.at[2],
                    off_);
    }
    return sum_abs(step);
  }

  HWY_INLINE void descend_to_noise(Doubles moved) {
    const Doubles noise = hn::Mul(both(tolerance::epsilon), sum_abs(box_.center));
    DoublesMask lanes = is_above_noise(moved, noise);
    for (int round = 1; round < rounds && !hn::AllFalse(Tag<double>(), lanes); ++round) {
      moved = descend(lanes);
      lanes = hn::And(lanes, is_above_noise(moved, noise));
    }
  }

  HWY_INLINE static DoublesMask is_above_noise(Doubles moved, Doubles noise) {
    return hn::Gt(hn::Mul(moved, both(shrinks_to)), noise);
  }

  /// The feature of the box, and where it is known.
  HWY_INLINE void find_feature(Doubles margin, Doubles distance, RoundTouch& touch) const {
    constexpr double least_cosine = 16 * tolerance::aligned;
    touch.feature_second = both(first_of_box);
    for (std::size_t i = 0; i < 3; ++i) {
      const Doubles half = box_.half.at[i];
      const Doubles room = hn::Sub(half, hn::Abs(place_.at[i]));
      const DoublesMask is_beyond = hn::Le(room, both(0));
      const DoublesMask is_steep = hn::Gt(hn::Abs(box_.along_axis(off_, i)), hn::Mul(both(least_cosine), distance));
      const DoublesMask is_out = hn::And(is_beyond, hn::And(hn::Gt(half, margin), is_steep));
      touch.is_clear = hn::And(touch.is_clear, hn::Or(hn::Gt(room, margin), is_out));
      const Doubles of_side = hn::IfThenElseZero(hn::Gt(place_.at[i], both(0)), both(8 << i));
      touch.feature_second =
          hn::Add(hn::Add(touch.feature_second, of_side), hn::IfThenElseZero(is_beyond, both(1 << i)));
    }
  }

  /// Of spheres whose center is in the box: across the nearest face.
  HWY_INLINE void take_inside(DoublesMask lanes, RoundTouch& touch) const {
    const Point room = box_.half - Point{{hn::Abs(place_.at[0]), hn::Abs(place_.at[1]), hn::Abs(place_.at[2])}};
    const DoublesMask is_y = hn::Lt(room.at[1], room.at[0]);
    const Doubles of_two = hn::IfThenElse(is_y, room.at[1], room.at[0]);
    const DoublesMask is_z = hn::Lt(room.at[2], of_two);
    const auto chosen = [&](const auto& of_x, const auto& of_y, const auto& of_z)
                            HWY_ATTR { return one_of(is_z, of_z, one_of(is_y, of_y, of_x)); };
    const Doubles least = chosen(room.at[0], room.at[1], room.at[2]);
    const Doubles second = chosen(min_of(room.at[1], room.at[2]), min_of(room.at[2], room.at[0]), of_two);
    const Doubles place = chosen(place_.at[0], place_.at[1], place_.at[2]);
    const Doubles clear = hn::Mul(both(tolerance::known_direction), size_);
    const Doubles doubt = hn::Mul(both(8 * tolerance::orthonormal), size_);
    const DoublesMask is_known =
        hn::And(hn::And(hn::Gt(least, clear), hn::Gt(hn::Sub(second, least), doubt)), hn::Gt(hn::Abs(place), clear));
    const Doubles face = chosen(both(1), both(2), both(4));
    const Doubles of_side = hn::IfThenElseZero(hn::Gt(place, both(0)), hn::Mul(face, both(8)));
    const FaceAhead ahead = face_ahead(chosen);
    touch.normal = one_of(lanes, ahead.normal, touch.normal);
    touch.depth = one_of(lanes, hn::Sub(sphere_.radius, ahead.gap), touch.depth);
    touch.on_first = one_of(lanes, sphere_.center + ahead.normal * sphere_.radius, touch.on_first);
    touch.on_second = one_of(lanes, sphere_.center + ahead.normal * ahead.gap, touch.on_second);
    touch.feature_second = one_of(lanes, hn::Add(hn::Add(both(first_of_box), face), of_side), touch.feature_second);
    touch.is_clear = hn::Or(hn::AndNot(lanes, touch.is_clear), hn::And(lanes, is_known));
  }

  /// The normal of a face from the sphere to the box, and how far the face is along it, below zero.
  struct FaceAhead {
    Point normal;
    Doubles gap;
  };

  /// Of the face across a chosen axis.
  template <class Chosen>
  HWY_INLINE FaceAhead face_ahead(const Chosen& chosen) const {
    Point across;
    Doubles reach;
    if constexpr (along) {
      across = chosen(unit_point(0), unit_point(1), unit_point(2));
      reach = chosen(box_.half.at[0], box_.half.at[1], box_.half.at[2]);
    } else {
      const Point adjoint = chosen(cross(box_.axes[1], box_.axes[2]), cross(box_.axes[2], box_.axes[0]),
                                   cross(box_.axes[0], box_.axes[1]));
      const Doubles length = hn::Sqrt(dot(adjoint, adjoint));
      for (std::size_t i = 0; i < 3; ++i) across.at[i] = hn::Div(adjoint.at[i], length);
      const auto reach_of = [&](std::size_t i)
                                HWY_ATTR { return hn::Abs(dot(across, box_.axes[i] * box_.half.at[i])); };
      reach = sum(reach_of(0), reach_of(1), reach_of(2));
    }
    const Doubles ahead = dot(across, box_.center);
    const DoublesMask is_behind = hn::Lt(ahead, both(0));
    return {one_of(is_behind, across * both(-1), across), hn::Sub(hn::Abs(ahead), reach)};
  }

  HWY_INLINE static Point unit_point(std::size_t axis) {
    Point result = zero_point();
    result.at[axis] = both(1);
    return result;
  }

  const SphereLanes& sphere_;
  const BoxLanesInFrame<along>& box_;
  Doubles size_;
  Point place_;
  Point off_;
};

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
