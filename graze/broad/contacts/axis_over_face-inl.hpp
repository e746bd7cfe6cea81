// SPDX-License-Identifier: MIT
// Axes of capsules over faces of boxes, a lane for each pair: AxisOverFace of query/fast_contact/axis_over_face.hpp, to
// the bit. Included once for each instruction set, hence no ordinary guard.
#if defined(GRAZE_BROAD_CONTACTS_AXIS_OVER_FACE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_AXIS_OVER_FACE_INL_HPP
#undef GRAZE_BROAD_CONTACTS_AXIS_OVER_FACE_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_AXIS_OVER_FACE_INL_HPP
#endif

#include <cstddef>

#include <hwy/highway.h>

#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/broad/contacts/round_lanes-inl.hpp>
#include <graze/broad/contacts/sphere_box-inl.hpp>
#include <graze/math/tolerance.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

HWY_INLINE Point negated(const Point& v) { return {{hn::Neg(v.at[0]), hn::Neg(v.at[1]), hn::Neg(v.at[2])}}; }
HWY_INLINE Doubles max_abs(const Point& v) {
  return hn::Max(hn::Max(hn::Abs(v.at[0]), hn::Abs(v.at[1])), hn::Abs(v.at[2]));
}

/// As CapsuleAndBox.
struct CapsuleAndBoxLanes {
  Point origin;
  Point way;
  Doubles radius;
  Point center;
  Point half;
  Point axes[3];
  Doubles size;

  template <bool along, class T>
  HWY_INLINE void load(const T* const* capsules, const T* const* boxes) {
    const CapsuleLanes capsule = CapsuleLanes::load<3>(capsules);
    origin = capsule.start;
    way = capsule.end - capsule.start;
    radius = capsule.radius;
    const BoxLanesInFrame<along> box(boxes, origin);
    center = box.center;
    half = box.half;
    for (std::size_t i = 0; i < 3; ++i) {
      if constexpr (along) {
        axes[i] = zero_point();
        axes[i].at[i] = both(1);
      } else {
        axes[i] = box.axes[i];
      }
    }
    size = hn::Add(sum(sum_abs(way), sum_abs(center), sum_abs(half)), radius);
  }
};

/// One of three, by a number, 0, 1 or 2.
struct OneOfThree {
  DoublesMask is_second;
  DoublesMask is_third;

  HWY_INLINE explicit OneOfThree(Doubles number)
      : is_second(hn::Eq(number, both(1))), is_third(hn::Eq(number, both(2))) {}

  HWY_INLINE Doubles of(Doubles a, Doubles b, Doubles c) const {
    return hn::IfThenElse(is_third, c, hn::IfThenElse(is_second, b, a));
  }
  HWY_INLINE Point of(const Point& a, const Point& b, const Point& c) const {
    return one_of(is_third, c, one_of(is_second, b, a));
  }
  HWY_INLINE Doubles of(const Point& v) const { return of(v.at[0], v.at[1], v.at[2]); }
};

/// A contact point, and its features by their places in `touched_features`.
struct CapsulePointLanes {
  Point on_box;
  Point on_capsule;
  Doubles depth;
  Doubles of_box;
  Doubles of_capsule;
};

/// What a CapsuleLook says of pairs whose manifold is plain to see.
struct CapsuleTouchLanes {
  Point normal;  ///< From the box to the capsule.
  Doubles error;
  CapsulePointLanes points[2];
  DoublesMask has_two;
  DoublesMask is_clear;
};

HWY_INLINE CapsuleTouchLanes no_touch() {
  const CapsulePointLanes point{zero_point(), zero_point(), both(0), both(0), both(0)};
  return {zero_point(), both(0), {point, point}, no_lane(), no_lane()};
}

/// As AxisOverFace, over a face across each lane's `axis`.
class AxisOverFaceLanes {
 public:
  HWY_INLINE AxisOverFaceLanes(const CapsuleAndBoxLanes& pair, Doubles axis, const DoublesMask& is_far)
      : pair_(pair),
        axis_(axis),
        is_far_(is_far),
        margin_(hn::Mul(both(1e-7), pair.size)),  // as AxisOverFace has it
        thin_(hn::Mul(both(tolerance::known_direction), pair.size)) {
    const OneOfThree turned(axis);
    const Point across_axis = turned.of(pair.axes[0], pair.axes[1], pair.axes[2]);
    const Point next = turned.of(pair.axes[1], pair.axes[2], pair.axes[0]);
    const Point last = turned.of(pair.axes[2], pair.axes[0], pair.axes[1]);
    const Point& half = pair.half;
    const Point adjoint = cross(next, last);
    const Point across = adjoint * hn::Div(both(1), hn::Sqrt(dot(adjoint, adjoint)));
    const Doubles climb = dot(across, across_axis);
    const DoublesMask is_turned = hn::Not(hn::Xor(hn::Lt(climb, both(0)), is_far));
    up_ = one_of(is_turned, negated(across), across);
    const Doubles height = turned.of(half);
    const Point middle = pair.center + across_axis * hn::IfThenElse(is_far, height, hn::Neg(height));
    top_ = dot(up_, middle);
    rise_ = dot(up_, pair.way);
    set_slab(cross(last, up_), next, middle, slabs_[0]);
    set_slab(cross(next, up_), last, middle, slabs_[1]);
    slabs_[0].half = turned.of(half.at[1], half.at[2], half.at[0]);
    slabs_[1].half = turned.of(half.at[2], half.at[0], half.at[1]);
    find_low();
    find_high();
    is_level_ = hn::Le(hn::Abs(rise_), hn::Mul(both(tolerance::rounding), pair.size));
    is_clear_ = hn::And(hn::And(low_.is_clear, high_.is_clear),
                        hn::And(hn::Gt(slabs_[0].half, thin_), hn::Gt(slabs_[1].half, thin_)));
  }

  const Point& up() const { return up_; }

  /// Where all is told, and the capsule meets the box.
  HWY_INLINE DoublesMask is_clear(const DoublesMask& has_to_be_level) const {
    const DoublesMask is_end_over = hn::AndNot(low_.is_vertex, high_.is_vertex);
    const DoublesMask is_end_lowest =
        hn::Or(hn::And(is_level_, is_end_over), hn::AndNot(is_level_, hn::Lt(rise_, both(0))));
    const DoublesMask is_end =
        hn::Or(hn::And(is_end_lowest, high_.is_vertex), hn::AndNot(is_end_lowest, low_.is_vertex));
    const Doubles lowest = hn::IfThenElse(is_end_lowest, high_.place, low_.place);
    const Doubles depth = hn::Sub(pair_.radius, gap(lowest));
    const DoublesMask meets = hn::Gt(depth, hn::Mul(both(tolerance::coarse), pair_.size));
    const DoublesMask is_lowest_over = hn::Or(is_level_, hn::AndNot(has_to_be_level, is_end));
    return hn::And(is_clear_, hn::And(is_lowest_over, meets));
  }

  HWY_INLINE void set_points(CapsulePointLanes (&points)[2]) const {
    set_point(low_, both(0), points[0]);
    set_point(high_, both(1), points[1]);
  }

 private:
  struct Slab {
    Doubles start;
    Doubles way;
    Doubles per_way;
    Doubles half;

    HWY_INLINE Doubles enters() const { return hn::Mul(hn::Sub(hn::Neg(hn::CopySign(half, way)), start), per_way); }
    HWY_INLINE Doubles leaves() const { return hn::Mul(hn::Sub(hn::CopySign(half, way), start), per_way); }
    HWY_INLINE Doubles at(Doubles place) const { return hn::Add(start, hn::Mul(way, place)); }
    HWY_INLINE Doubles room(Doubles place) const { return hn::Sub(half, hn::Abs(at(place))); }
  };

  struct End {
    Doubles place;
    DoublesMask is_vertex;
    Doubles side;
    DoublesMask is_clear;
  };

  HWY_INLINE void set_slab(const Point& along, const Point& axis, const Point& middle, Slab& slab) const {
    const Doubles scale = hn::Div(both(1), dot(along, axis));
    slab.start = hn::Neg(hn::Mul(dot(along, middle), scale));
    slab.way = hn::Mul(dot(along, pair_.way), scale);
    slab.per_way = hn::Div(both(1), slab.way);
  }

  HWY_INLINE Doubles gap(Doubles place) const { return hn::Sub(hn::Mul(rise_, place), top_); }
  HWY_INLINE Doubles at_height() const { return hn::Div(hn::Add(pair_.radius, top_), rise_); }

  HWY_INLINE void find_low() {
    const Doubles a = slabs_[0].enters();
    const Doubles b = slabs_[1].enters();
    const Doubles c = hn::IfThenElse(hn::Lt(rise_, both(0)), at_height(), both(-1));
    const Doubles last = max_of(max_of(a, b), c);
    set_end(max_of(last, both(0)), hn::Not(hn::Gt(last, both(0))), b, c, low_);
    const Doubles before = max_of(max_of(min_of(a, b), min_of(max_of(a, b), c)), both(0));
    low_.is_clear = hn::And(low_.is_clear, hn::Or(low_.is_vertex, is_cut_clear(hn::Sub(last, before), low_.side)));
  }

  HWY_INLINE void find_high() {
    const Doubles a = slabs_[0].leaves();
    const Doubles b = slabs_[1].leaves();
    const Doubles c = hn::IfThenElse(hn::Gt(rise_, both(0)), at_height(), both(2));
    const Doubles first = min_of(min_of(a, b), c);
    set_end(min_of(first, both(1)), hn::Not(hn::Lt(first, both(1))), b, c, high_);
    const Doubles next = min_of(min_of(max_of(a, b), max_of(min_of(a, b), c)), both(1));
    high_.is_clear = hn::And(high_.is_clear, hn::Or(high_.is_vertex, is_cut_clear(hn::Sub(next, first), high_.side)));
  }

  HWY_INLINE void set_end(Doubles place, const DoublesMask& is_vertex, Doubles second, Doubles third, End& end) const {
    end.place = place;
    end.is_vertex = is_vertex;
    end.side = hn::IfThenElse(hn::Eq(place, third), both(2), hn::IfThenElseZero(hn::Eq(place, second), both(1)));
    end.is_clear = hn::Eq(place, place);
    const Doubles rooms[3] = {slabs_[0].room(place), slabs_[1].room(place), hn::Sub(pair_.radius, gap(place))};
    for (std::size_t i = 0; i < 3; ++i) {
      const DoublesMask is_at = hn::AndNot(is_vertex, hn::Eq(end.side, both(static_cast<double>(i))));
      end.is_clear = hn::And(end.is_clear, hn::Or(is_at, hn::Gt(rooms[i], margin_)));
    }
  }

  HWY_INLINE DoublesMask is_cut_clear(Doubles share, Doubles side) const {
    const Doubles rate = hn::Abs(OneOfThree(side).of(slabs_[0].way, slabs_[1].way, rise_));
    return hn::And(hn::Gt(hn::Mul(share, rate), margin_), hn::Gt(rate, thin_));
  }

  HWY_INLINE void set_point(const End& end, Doubles vertex, CapsulePointLanes& point) const {
    const Point on_axis = pair_.way * end.place;
    const Doubles its_gap = gap(end.place);
    point.on_box = pair_.origin + (on_axis - up_ * its_gap);
    point.on_capsule = pair_.origin + (on_axis - up_ * pair_.radius);
    point.depth = max_of(both(0), hn::Sub(pair_.radius, its_gap));
    point.of_capsule = hn::IfThenElse(end.is_vertex, vertex, both(2));
    // The face, or with one more axis, on that axis' side, the edge there.
    const Doubles of_axis = bit_of(axis_);
    const Doubles of_face = hn::Add(of_axis, hn::IfThenElseZero(is_far_, hn::Mul(both(8), of_axis)));
    const DoublesMask is_first = hn::Eq(end.side, both(0));
    const Doubles other = one_on(hn::IfThenElse(is_first, axis_, one_on(axis_)));
    const Doubles of_other = bit_of(other);
    const Doubles x = hn::IfThenElse(is_first, slabs_[0].at(end.place), slabs_[1].at(end.place));
    const Doubles of_side = hn::Add(of_other, hn::IfThenElseZero(hn::Gt(x, both(0)), hn::Mul(both(8), of_other)));
    const DoublesMask is_on_face = hn::Or(end.is_vertex, hn::Eq(end.side, both(2)));
    point.of_box = hn::Add(hn::Add(both(first_of_box), of_face), hn::IfThenZeroElse(is_on_face, of_side));
  }

  /// 1, 2 or 4.
  HWY_INLINE static Doubles bit_of(Doubles axis) { return OneOfThree(axis).of(both(1), both(2), both(4)); }
  HWY_INLINE static Doubles one_on(Doubles axis) { return OneOfThree(axis).of(both(1), both(2), both(0)); }

  const CapsuleAndBoxLanes& pair_;
  Doubles axis_;
  DoublesMask is_far_;
  Doubles margin_;
  Doubles thin_;
  Point up_;
  Doubles top_;
  Doubles rise_;
  Slab slabs_[2];
  End low_;
  End high_;
  DoublesMask is_level_;
  DoublesMask is_clear_;
};

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
