// SPDX-License-Identifier: MIT
// Segments as boxes see them, a lane for each pair: WayPastBox and PlaceByFaces of query/fast_contact/capsule_box.hpp,
// and MinimumTranslationSearch of query/fast_contact/minimum_translation.hpp, to the bit. Included once for each
// instruction set, hence no ordinary guard.
#if defined(GRAZE_BROAD_CONTACTS_MINIMUM_TRANSLATION_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_MINIMUM_TRANSLATION_INL_HPP
#undef GRAZE_BROAD_CONTACTS_MINIMUM_TRANSLATION_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_MINIMUM_TRANSLATION_INL_HPP
#endif

#include <cstddef>
#include <limits>

#include <hwy/highway.h>

#include <graze/broad/contacts/axis_over_face-inl.hpp>
#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/math/tolerance.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

/// As WayPastBox.
struct WayLanes {
  Point start;
  Point way;
  Point half;

  HWY_INLINE explicit WayLanes(const CapsuleAndBoxLanes& pair) : half(pair.half) {
    for (std::size_t i = 0; i < 3; ++i) {
      start.at[i] = hn::Neg(dot(pair.center, pair.axes[i]));
      way.at[i] = dot(pair.way, pair.axes[i]);
    }
  }

  HWY_INLINE Point at(Doubles t) const { return start + way * t; }

  HWY_INLINE Doubles slope(Doubles t) const {
    Point terms;
    for (std::size_t i = 0; i < 3; ++i) {
      const Doubles x = hn::Add(start.at[i], hn::Mul(way.at[i], t));
      const Doubles inside = min_of(max_of(x, hn::Neg(half.at[i])), half.at[i]);
      terms.at[i] = hn::Mul(way.at[i], hn::Sub(x, inside));
    }
    return sum(terms.at[0], terms.at[1], terms.at[2]);
  }

  HWY_INLINE Doubles nearest() const {
    Doubles low = both(0);
    Doubles high = both(1);
    Doubles slope_low = slope(low);
    Doubles slope_high = slope(high);
    const DoublesMask is_start = hn::Ge(slope_low, both(0));
    const DoublesMask is_end = hn::Le(slope_high, both(0));
    for (std::size_t i = 0; i < 3; ++i) {
      const Doubles per_way = hn::Div(both(1), way.at[i]);
      for (const bool is_far : {false, true}) {
        const Doubles side = is_far ? half.at[i] : hn::Neg(half.at[i]);
        const Doubles t = hn::Mul(hn::Sub(side, start.at[i]), per_way);
        const DoublesMask is_between = hn::And(hn::Gt(t, low), hn::Lt(t, high));
        const Doubles here = slope(t);
        const DoublesMask is_below = hn::And(is_between, hn::Lt(here, both(0)));
        const DoublesMask is_above = hn::AndNot(is_below, is_between);
        low = hn::IfThenElse(is_below, t, low);
        slope_low = hn::IfThenElse(is_below, here, slope_low);
        high = hn::IfThenElse(is_above, t, high);
        slope_high = hn::IfThenElse(is_above, here, slope_high);
      }
    }
    const Doubles between =
        hn::Sub(low, hn::Div(hn::Mul(slope_low, hn::Sub(high, low)), hn::Sub(slope_high, slope_low)));
    return hn::IfThenElse(is_start, both(0), hn::IfThenElse(is_end, both(1), between));
  }
};

/// As PlaceByFaces.
struct PlaceLanes {
  DoublesMask is_beyond[3];
  DoublesMask is_one;  ///< Beyond the faces across one axis only, ...
  DoublesMask is_two;  ///< ... or two.
  Doubles last;
  DoublesMask is_clear;
  Doubles squared;
  Doubles least_beyond;

  HWY_INLINE PlaceLanes(const Point& place, const Point& half, Doubles doubt) {
    is_clear = hn::Eq(doubt, doubt);
    squared = both(0);
    last = both(0);
    least_beyond = both(std::numeric_limits<double>::infinity());
    Doubles count = both(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const Doubles beyond = hn::Sub(hn::Abs(place.at[i]), half.at[i]);
      is_clear = hn::And(is_clear, hn::Gt(hn::Abs(beyond), doubt));
      const Doubles off = max_of(beyond, both(0));
      squared = hn::Add(squared, hn::Mul(off, off));
      is_beyond[i] = hn::Gt(beyond, doubt);
      count = hn::Add(count, hn::IfThenElseZero(is_beyond[i], both(1)));
      last = hn::IfThenElse(is_beyond[i], both(static_cast<double>(i)), last);
      least_beyond = hn::IfThenElse(is_beyond[i], min_of(least_beyond, beyond), least_beyond);
    }
    is_one = hn::Eq(count, both(1));
    is_two = hn::Eq(count, both(2));
  }
};

/// As MinimumTranslationSearch.
class MinimumTranslationLanes {
 public:
  /// Of some lanes, if any.
  HWY_INLINE MinimumTranslationLanes(const WayLanes& way, Doubles doubt, Doubles noise, const DoublesMask& lanes) {
    if (hn::AllFalse(Tag<double>(), lanes)) return;
    for (std::size_t i = 0; i < 3; ++i) look_across_face(way, i);
    is_level = hn::Le(hn::Abs(OneOfThree(face).of(way.way)), noise);
    const Doubles squared_noise = hn::Mul(noise, noise);
    const Doubles least = hn::Mul(both(1e-8), dot(way.way, way.way));  // as MinimumTranslationSearch has it
    for (std::size_t i = 0; i < 3; ++i) look_along_edge(way, i, squared_noise, least);
    is_face = hn::Ge(face_gap_, edge_gap_);
    const Doubles best = hn::IfThenElse(is_face, face_gap_, edge_gap_);
    const Doubles second =
        max_of(min_of(face_gap_, edge_gap_), hn::IfThenElse(is_face, second_face_gap_, second_edge_gap_));
    is_known = hn::AndNot(is_in_doubt_, hn::And(hn::Lt(best, hn::Neg(doubt)), hn::Gt(hn::Sub(best, second), doubt)));
    find_edge_outward(way);
  }

  DoublesMask is_known = no_lane();
  DoublesMask is_face = no_lane();
  DoublesMask is_level = no_lane();
  DoublesMask is_far = no_lane();
  DoublesMask is_oblique = no_lane();
  Doubles face = both(0);
  Doubles edge = both(0);
  Point outward = zero_point();  ///< Of an edge.

 private:
  HWY_INLINE static Doubles nowhere() { return both(-std::numeric_limits<double>::infinity()); }

  HWY_INLINE void look_across_face(const WayLanes& way, std::size_t i) {
    const Doubles start = way.start.at[i];
    const Doubles end = hn::Add(start, way.way.at[i]);
    const Doubles ahead = hn::Sub(min_of(start, end), way.half.at[i]);
    const Doubles behind = hn::Sub(hn::Neg(way.half.at[i]), max_of(start, end));
    const Doubles gap = max_of(ahead, behind);
    second_face_gap_ = max_of(second_face_gap_, max_of(min_of(gap, face_gap_), min_of(ahead, behind)));
    const DoublesMask is_better = hn::Gt(gap, face_gap_);
    face_gap_ = hn::IfThenElse(is_better, gap, face_gap_);
    face = hn::IfThenElse(is_better, both(static_cast<double>(i)), face);
    is_far = hn::Or(hn::And(is_better, hn::Ge(ahead, behind)), hn::AndNot(is_better, is_far));
  }

  HWY_INLINE void look_along_edge(const WayLanes& way, std::size_t i, Doubles squared_noise, Doubles least) {
    const std::size_t next = (i + 1) % 3;
    const std::size_t last = (i + 2) % 3;
    const Doubles x = way.way.at[next];
    const Doubles y = way.way.at[last];
    const Doubles squared = hn::Add(hn::Mul(x, x), hn::Mul(y, y));
    const DoublesMask is_of_face = hn::AndNot(hn::Eq(face, both(static_cast<double>(i))), is_level);
    const DoublesMask counts = hn::Not(hn::Or(is_of_face, hn::Le(squared, squared_noise)));
    is_in_doubt_ = hn::Or(is_in_doubt_, hn::AndNot(hn::Gt(squared, least), counts));
    const Doubles height = hn::Sub(hn::Mul(way.start.at[next], y), hn::Mul(way.start.at[last], x));
    const Doubles reach = hn::Add(hn::Mul(way.half.at[next], hn::Abs(y)), hn::Mul(way.half.at[last], hn::Abs(x)));
    const Doubles per_length = hn::Div(both(1), hn::Sqrt(squared));
    const Doubles gap = hn::Mul(hn::Sub(hn::Abs(height), reach), per_length);
    const Doubles other = hn::Mul(hn::Sub(hn::Neg(hn::Abs(height)), reach), per_length);
    const Doubles second = max_of(second_edge_gap_, max_of(min_of(gap, edge_gap_), other));
    second_edge_gap_ = hn::IfThenElse(counts, second, second_edge_gap_);
    const DoublesMask is_better = hn::And(counts, hn::Gt(gap, edge_gap_));
    edge_gap_ = hn::IfThenElse(is_better, gap, edge_gap_);
    edge = hn::IfThenElse(is_better, both(static_cast<double>(i)), edge);
    height_ = hn::IfThenElse(is_better, height, height_);
  }

  HWY_INLINE void find_edge_outward(const WayLanes& way) {
    const OneOfThree along(edge);
    const Doubles side = hn::IfThenElse(hn::Gt(height_, both(0)), both(1), both(-1));
    const Point& w = way.way;
    const Doubles on_next = hn::Mul(side, along.of(w.at[2], w.at[0], w.at[1]));
    const Doubles on_last = hn::Mul(hn::Neg(side), along.of(w.at[1], w.at[2], w.at[0]));
    outward = {{along.of(both(0), on_last, on_next), along.of(on_next, both(0), on_last),
                along.of(on_last, on_next, both(0))}};
    constexpr double least_cosine = 16 * tolerance::aligned;
    const Doubles a = hn::Abs(on_next);
    const Doubles b = hn::Abs(on_last);
    is_oblique = hn::Gt(min_of(a, b), hn::Mul(both(least_cosine), max_of(a, b)));
  }

  Doubles face_gap_ = nowhere();
  Doubles second_face_gap_ = nowhere();
  Doubles edge_gap_ = nowhere();
  Doubles second_edge_gap_ = nowhere();
  Doubles height_ = both(0);
  DoublesMask is_in_doubt_ = no_lane();
};

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
