// SPDX-License-Identifier: MIT
// How many pairs of capsules and boxes touch each other, a lane for each: the find_fast_contact of
// query/fast_contact/capsule_box.hpp and its points, to the bit. Included once for each instruction set, hence no
// ordinary guard.
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

#include <graze/broad/contacts/axis_over_face-inl.hpp>
#include <graze/broad/contacts/contact_kernels.hpp>
#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/broad/contacts/manifold_points-inl.hpp>
#include <graze/broad/contacts/minimum_translation-inl.hpp>
#include <graze/broad/contacts/obb/axes-inl.hpp>
#include <graze/broad/contacts/round_lanes-inl.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/query/manifold.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

/// As CapsuleTouch. A group goes all the ways that one of its lanes has to, and each lane keeps what its own has found.
class CapsuleOnBoxLanes {
 public:
  HWY_INLINE explicit CapsuleOnBoxLanes(const CapsuleAndBoxLanes& pair) : pair_(pair) {
    constexpr double least_orthonormality_error = 1e-10;  // as CapsuleTouch has it
    doubt_ = hn::Mul(hn::Mul(both(2 * tolerance::box_filter),
                             hn::Add(orthonormality_error_of_axes(pair.axes), both(least_orthonormality_error))),
                     pair.size);
  }

  HWY_INLINE void run(CapsuleTouchLanes& touch) {
    const WayLanes way(pair_);
    const Doubles t = way.nearest();
    const Point place = way.at(t);
    const PlaceLanes by_faces(place, pair_.half, doubt_);
    const Doubles reach = hn::Add(pair_.radius, doubt_);
    const Doubles thickness = min_of(min_of(pair_.half.at[0], pair_.half.at[1]), pair_.half.at[2]);
    const DoublesMask is_open = hn::AndNot(hn::Gt(by_faces.squared, hn::Mul(reach, reach)), hn::Gt(thickness, doubt_));
    const DoublesMask is_in = hn::Le(by_faces.squared, hn::Mul(doubt_, doubt_));
    const MinimumTranslationLanes out(way, doubt_, hn::Mul(both(tolerance::rounding), pair_.size), is_in);
    const DoublesMask lies =
        hn::Or(hn::And(is_in, hn::And(out.is_known, out.is_face)), hn::AndNot(is_in, by_faces.is_one));
    const DoublesMask is_past = hn::AndNot(is_at_end(t), hn::And(by_faces.is_two, by_faces.is_clear));
    const DoublesMask crosses =
        hn::Or(hn::And(is_in, hn::AndNot(out.is_face, out.is_known)), hn::AndNot(is_in, is_past));
    touch.error = hn::Mul(both(2 * tolerance::rounding), pair_.size);
    touch.has_two = lies;
    if (is_any(hn::Not(hn::Or(is_in, hn::Or(lies, crosses))))) pass_by(t, place, by_faces, touch);
    touch.is_clear = hn::AndNot(is_in, touch.is_clear);
    if (is_any(crosses)) cross_edges(crosses, {t, place, by_faces, is_in, out}, touch);
    if (is_any(lies)) lie_on_faces({t, place, by_faces, is_in, out}, touch);
    touch.is_clear = hn::And(touch.is_clear, hn::And(is_open, is_usual_size(pair_.size)));
  }

 private:
  /// Where the axes are seen to be.
  struct Seen {
    Doubles t;
    const Point& place;
    const PlaceLanes& by_faces;
    const DoublesMask& is_in;
    const MinimumTranslationLanes& out;
  };

  HWY_INLINE static bool is_any(const DoublesMask& lanes) { return !hn::AllFalse(Tag<double>(), lanes); }

  /// An edge or a corner of each box.
  struct FeatureLanes {
    Point middle;
    Doubles of_box;
    Point edge;
    Doubles half;

    HWY_INLINE FeatureLanes(const CapsuleAndBoxLanes& pair, const Point& place, const DoublesMask (&is_beyond)[3]) {
      middle = pair.center;
      of_box = both(first_of_box);
      for (std::size_t i = 0; i < 3; ++i) {
        const Doubles side = hn::IfThenElseZero(is_beyond[i], hn::CopySign(pair.half.at[i], place.at[i]));
        middle = middle + pair.axes[i] * side;
        const Doubles bit = both(static_cast<double>(1U << i));
        const Doubles of_side = hn::IfThenElseZero(hn::Gt(place.at[i], both(0)), hn::Mul(both(8), bit));
        of_box = hn::Add(of_box, hn::Add(hn::IfThenElseZero(is_beyond[i], bit), of_side));
      }
      const OneOfThree along(hn::IfThenElseZero(is_beyond[0], hn::IfThenElse(is_beyond[1], both(2), both(1))));
      edge = along.of(pair.axes[0], pair.axes[1], pair.axes[2]);
      half = along.of(pair.half);
    }
  };

  HWY_INLINE static DoublesMask is_at_end(Doubles t) { return hn::Or(hn::Le(t, both(0)), hn::Ge(t, both(1))); }

  /// On a face that the normal is hardly turned from it would be laid flat.
  HWY_INLINE static DoublesMask is_steep(const PlaceLanes& by_faces) {
    constexpr double least_cosine = 16 * tolerance::aligned;
    return hn::Gt(by_faces.least_beyond, hn::Mul(both(least_cosine), hn::Sqrt(by_faces.squared)));
  }

  HWY_INLINE DoublesMask meets(Doubles depth) const {
    return hn::Gt(depth, hn::Mul(both(tolerance::coarse), pair_.size));
  }

  /// An end beside an edge or a corner, or the axis beside a corner: sets everything.
  HWY_INLINE void pass_by(Doubles t, const Point& place, const PlaceLanes& by_faces, CapsuleTouchLanes& touch) const {
    const FeatureLanes feature(pair_, place, by_faces.is_beyond);
    const Point& way = pair_.way;
    const DoublesMask at_end = is_at_end(t);
    const DoublesMask at_start = hn::Le(t, both(0));
    const Doubles end = hn::IfThenElse(at_start, both(0), both(1));
    const Doubles beside_corner = hn::Div(dot(way, feature.middle), dot(way, way));
    const Point on_axis = way * hn::IfThenElse(at_end, end, beside_corner);
    const Doubles on_edge = hn::Div(dot(feature.edge, on_axis - feature.middle), dot(feature.edge, feature.edge));
    const Point on_box = one_of(by_faces.is_two, feature.middle + feature.edge * on_edge, feature.middle);
    const Point between = on_axis - on_box;
    const Doubles distance = hn::Sqrt(dot(between, between));
    CapsulePointLanes& point = touch.points[0];
    point.depth = hn::Sub(pair_.radius, distance);
    touch.normal = between * hn::Div(both(1), distance);
    point.on_box = pair_.origin + on_box;
    point.on_capsule = pair_.origin + (on_axis - touch.normal * pair_.radius);
    point.of_box = feature.of_box;
    point.of_capsule = hn::IfThenElse(at_end, end, both(2));

    const Doubles climb = dot(way, touch.normal);
    const Doubles away = hn::IfThenElse(at_start, climb, hn::Neg(climb));
    const DoublesMask leads_away = hn::Ge(away, hn::Mul(both(-tolerance::rounding), sum_abs(way)));
    const DoublesMask is_on_edge = hn::Or(hn::Not(by_faces.is_two), hn::Lt(hn::Abs(on_edge), feature.half));
    const DoublesMask is_end_known = hn::And(leads_away, is_on_edge);
    const DoublesMask is_inner = hn::And(hn::Gt(beside_corner, both(0)), hn::Lt(beside_corner, both(1)));
    const DoublesMask is_corner_known =
        hn::AndNot(by_faces.is_two, hn::And(is_inner, is_along_clear(hn::Mul(t, max_abs(way)))));
    const DoublesMask is_where = hn::Or(hn::And(at_end, is_end_known), hn::AndNot(at_end, is_corner_known));
    const DoublesMask is_known =
        hn::And(hn::And(by_faces.is_clear, hn::Gt(distance, hn::Mul(both(tolerance::known_direction), pair_.size))),
                hn::And(meets(point.depth), is_steep(by_faces)));
    touch.is_clear = hn::And(is_where, is_known);
  }

  HWY_INLINE DoublesMask is_along_clear(Doubles along) const {
    return hn::And(hn::Gt(along, doubt_), hn::Gt(hn::Sub(max_abs(pair_.way), along), doubt_));
  }

  /// Sets those whose axis is nearest to an edge between its ends, or the soonest out of the box past one.
  HWY_INLINE void cross_edges(const DoublesMask& lanes, const Seen& seen, CapsuleTouchLanes& touch) const {
    const auto& [t, outer_place, by_faces, is_in, out] = seen;
    const Point& way = pair_.way;
    const Point place = one_of(is_in, out.outward, outer_place);
    DoublesMask is_beyond[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const DoublesMask of_out = hn::Ne(out.edge, both(static_cast<double>(i)));
      is_beyond[i] = hn::Or(hn::And(is_in, of_out), hn::AndNot(is_in, by_faces.is_beyond[i]));
    }
    const FeatureLanes feature(pair_, place, is_beyond);
    const Doubles uu = dot(way, way);
    const Doubles vv = dot(feature.edge, feature.edge);
    const Doubles uv = dot(way, feature.edge);
    const Doubles uw = dot(way, feature.middle);
    const Doubles vw = dot(feature.edge, feature.middle);
    const Doubles det = hn::Sub(hn::Mul(uu, vv), hn::Mul(uv, uv));
    const Doubles per_det = hn::Div(both(1), det);
    const Doubles on_axis = hn::Mul(hn::Sub(hn::Mul(uw, vv), hn::Mul(vw, uv)), per_det);
    const Doubles on_edge = hn::Mul(hn::Sub(hn::Mul(uw, uv), hn::Mul(vw, uu)), per_det);
    const Point across = cross(way, feature.edge);
    const Doubles length = hn::Sqrt(dot(across, across));
    const Doubles side = hn::CopySign(both(1), dot(across, feature.middle - pair_.center));
    const Point normal = across * hn::Div(side, length);
    const Doubles depth = hn::Sub(pair_.radius, hn::Neg(dot(normal, feature.middle)));

    const DoublesMask is_outside_clear = hn::And(is_along_clear(hn::Mul(t, max_abs(way))), is_steep(by_faces));
    const DoublesMask is_single = hn::Or(hn::And(is_in, out.is_oblique), hn::AndNot(is_in, is_outside_clear));
    constexpr double least_sine_squared = 1.0 / 64;
    const DoublesMask is_crossed = hn::Gt(det, hn::Mul(both(least_sine_squared), hn::Mul(uu, vv)));
    const DoublesMask is_inner = hn::And(is_along_clear(hn::Mul(on_axis, max_abs(way))),
                                         hn::Gt(hn::Sub(feature.half, hn::Abs(on_edge)), doubt_));
    const DoublesMask is_known = hn::And(hn::And(is_crossed, is_inner), hn::And(is_single, meets(depth)));
    const CapsulePointLanes point{pair_.origin + (feature.middle + feature.edge * on_edge),
                                  pair_.origin + (way * on_axis - normal * pair_.radius), depth, feature.of_box,
                                  both(2)};
    take(lanes, point, touch.points[0]);
    touch.normal = one_of(lanes, normal, touch.normal);
    touch.is_clear = hn::Or(hn::And(lanes, is_known), hn::AndNot(lanes, touch.is_clear));
  }

  /// Sets those that lie on a face, or are the soonest out of the box across it.
  HWY_INLINE void lie_on_faces(const Seen& seen, CapsuleTouchLanes& touch) const {
    const auto& [t, place, by_faces, is_in, out] = seen;
    const Doubles axis = hn::IfThenElse(is_in, out.face, by_faces.last);
    const DoublesMask is_far_outside = hn::Gt(OneOfThree(by_faces.last).of(place), both(0));
    const DoublesMask is_far = hn::Or(hn::And(is_in, out.is_far), hn::AndNot(is_in, is_far_outside));
    const AxisOverFaceLanes over(pair_, axis, is_far);
    CapsulePointLanes points[2];
    over.set_points(points);
    take(touch.has_two, points[0], touch.points[0]);
    touch.points[1] = points[1];
    touch.normal = one_of(touch.has_two, over.up(), touch.normal);
    const DoublesMask is_known = over.is_clear(hn::And(is_in, out.is_level));
    touch.is_clear = hn::Or(hn::And(touch.has_two, is_known), hn::AndNot(touch.has_two, touch.is_clear));
  }

  HWY_INLINE static void take(const DoublesMask& lanes, const CapsulePointLanes& from, CapsulePointLanes& to) {
    to.on_box = one_of(lanes, from.on_box, to.on_box);
    to.on_capsule = one_of(lanes, from.on_capsule, to.on_capsule);
    to.depth = hn::IfThenElse(lanes, from.depth, to.depth);
    to.of_box = hn::IfThenElse(lanes, from.of_box, to.of_box);
    to.of_capsule = hn::IfThenElse(lanes, from.of_capsule, to.of_capsule);
  }

  const CapsuleAndBoxLanes& pair_;
  Doubles doubt_;
};

/// The manifolds of a group of pairs of capsules and boxes, to be written one by one.
template <class T>
class CapsuleContacts {
 public:
  HWY_INLINE CapsuleContacts(const CapsuleTouchLanes& touch, std::uint32_t turned)
      : clear_(bits_of<double>(touch.is_clear)), two_(bits_of<double>(touch.has_two)), turned_(turned) {
    const DoublesMask turns = hn::Not(mask_of(Tag<double>(), turned));  // what comes from the box, it is by nature
    rows_.set(touch.normal, touch.error, turns);
    for (std::size_t i = 0; i < 2; ++i) {
      const CapsulePointLanes& point = touch.points[i];
      points_[i].set(point.on_box, point.on_capsule, point.depth, turns);
      store(point.of_capsule, features_[i][0]);
      store(point.of_box, features_[i][1]);
    }
  }

  bool is_clear(std::size_t lane) const { return (clear_ >> lane & 1U) != 0; }

  void write(std::size_t lane, Manifold<3, T>& to) const {
    write_point(0, lane, to.points[0]);
    const std::size_t size = 1 + (two_ >> lane & 1U);
    if (size > 1) write_point(1, lane, to.points[1]);
    rows_.write(lane, size, to);
  }

 private:
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
  CapsuleAndBoxLanes pair;
  pair.load<kind == PrimitiveKind::capsule_aabb>(capsules, boxes);
  CapsuleTouchLanes touch = no_touch();
  CapsuleOnBoxLanes(pair).run(touch);
  return CapsuleContacts<T>(touch, turned);
}

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
