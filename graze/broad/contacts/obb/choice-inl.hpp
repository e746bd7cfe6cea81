// SPDX-License-Identifier: MIT
// LaneChoice of query/fast_contact/obb/choice.hpp for many pairs: selects four of more corners, by the same
// calculations in float. Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_CONTACTS_OBB_CHOICE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_OBB_CHOICE_INL_HPP
#undef GRAZE_BROAD_CONTACTS_OBB_CHOICE_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_OBB_CHOICE_INL_HPP
#endif

#include <cstddef>

#include <hwy/highway.h>

#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/broad/contacts/obb/clip-inl.hpp>
#include <graze/broad/contacts/obb/lines-inl.hpp>
#include <graze/math/tolerance.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

/// As many floats as there are pairs in a group.
using FloatTag = hn::Rebind<float, Tag<double>>;
HWY_INLINE hn::Vec<FloatTag> narrowed(Doubles v) { return hn::DemoteTo(FloatTag(), v); }

/// The floats of two groups, which fill a vector.
using TwoTag = hn::Repartition<float, Tag<double>>;
using Floats = hn::Vec<TwoTag>;

HWY_INLINE Floats all_floats(float value) { return hn::Set(TwoTag(), value); }
HWY_INLINE Floats joined(Doubles first, Doubles second) {
  return hn::Combine(TwoTag(), narrowed(second), narrowed(first));
}

/// How the corners of a face over a face are measured in the incident one, as in LaneChoice.
struct MeasuresLanes {
  Doubles xx, yy, xy;
  Doubles area;
  Doubles sink[2];

  /// `on_incident` where the points are on the second box.
  HWY_INLINE MeasuresLanes(const ClipLanes& clip, const FaceLanes& face, const Point& normal, DoublesMask on_incident) {
    const Doubles longest = max_of(dot(face.right, face.right), dot(face.up, face.up));
    const Doubles down = hn::Div(both(-1), hn::Sqrt(longest));
    const Doubles scale = hn::Mul(down, down);
    const Doubles flat[2] = {hn::IfThenZeroElse(on_incident, clip.climb(0)),
                             hn::IfThenZeroElse(on_incident, clip.climb(1))};
    const auto measured = [&](const Point& a, const Point& b, Doubles high) { return hn::Sub(dot(a, b), high); };
    xx = hn::Mul(measured(face.right, face.right, hn::Mul(flat[0], flat[0])), scale);
    yy = hn::Mul(measured(face.up, face.up, hn::Mul(flat[1], flat[1])), scale);
    xy = hn::Mul(hn::Mul(both(2), measured(face.right, face.up, hn::Mul(flat[0], flat[1]))), scale);
    area = hn::Mul(dot(cross(face.right, face.up), normal), scale);
    sink[0] = hn::Mul(clip.climb(0), down);
    sink[1] = hn::Mul(clip.climb(1), down);
  }
};

/// Lines as bits, for the pairs of two groups.
using LinesTag = hn::RebindToUnsigned<TwoTag>;
using Lines = hn::Vec<LinesTag>;

HWY_INLINE Lines line_bit(std::size_t line) { return hn::Load(LinesTag(), bits_in_lanes<std::uint32_t>.of[line]); }
HWY_INLINE hn::Mask<TwoTag> has_line(Lines lines, std::size_t line) {
  return hn::RebindMask(TwoTag(), hn::TestBit(lines, line_bit(line)));
}
HWY_INLINE Lines line_where(hn::Mask<TwoTag> mask, std::size_t line) {
  return hn::IfThenElseZero(hn::RebindMask(LinesTag(), mask), line_bit(line));
}

using HalfLinesTag = hn::RebindToUnsigned<FloatTag>;
HWY_INLINE Lines joined(Bits first, Bits second) {
  const HalfLinesTag half;
  return hn::Combine(LinesTag(), hn::TruncateTo(half, second), hn::TruncateTo(half, first));
}
HWY_INLINE Bits widened(Lines both_groups, std::size_t group) {
  return hn::PromoteTo(
      BitsTag(), group == 0 ? hn::LowerHalf(HalfLinesTag(), both_groups) : hn::UpperHalf(HalfLinesTag(), both_groups));
}

/// All lines except the first.
HWY_INLINE Lines but_the_first(Lines lines) { return hn::And(lines, hn::Sub(lines, hn::Set(LinesTag(), 1))); }
HWY_INLINE hn::Mask<TwoTag> are_none(Lines lines) {
  return hn::RebindMask(TwoTag(), hn::Eq(lines, hn::Zero(LinesTag())));
}
HWY_INLINE Lines first_of(Lines lines) { return hn::And(lines, hn::Sub(hn::Zero(LinesTag()), lines)); }
/// The remaining corners, relative to the first one, which also replaces missing ones.
struct CornersLanes {
  Doubles x[face_lines];
  Doubles y[face_lines];

  HWY_INLINE explicit CornersLanes(const ClipLanes& clip) {
    Doubles first[2] = {clip.within(face_lines - 1, 0), clip.within(face_lines - 1, 1)};
    for (std::size_t s = face_lines - 1; s-- > 0;) {
      for (std::size_t k = 0; k < 2; ++k) first[k] = hn::IfThenElse(clip.is_left(s), clip.within(s, k), first[k]);
    }
    for (std::size_t s = 0; s < face_lines; ++s) {
      x[s] = hn::IfThenElseZero(clip.is_left(s), hn::Sub(clip.within(s, 0), first[0]));
      y[s] = hn::IfThenElseZero(clip.is_left(s), hn::Sub(clip.within(s, 1), first[1]));
    }
  }
};

/// Selects four corners for each pair of two groups.
class ChoiceLanes {
 public:
  /// `left`: the lines with corners.
  HWY_INLINE ChoiceLanes(Lines left, const ClipLanes& a, const MeasuresLanes& of_a, const ClipLanes& b,
                         const MeasuresLanes& of_b)
      : left_(left),
        is_clear_(hn::FirstN(TwoTag(), hn::Lanes(TwoTag()))),
        xx_(joined(of_a.xx, of_b.xx)),
        yy_(joined(of_a.yy, of_b.yy)),
        xy_(joined(of_a.xy, of_b.xy)),
        area_(joined(of_a.area, of_b.area)),
        sink_{joined(of_a.sink[0], of_b.sink[0]), joined(of_a.sink[1], of_b.sink[1])} {
    const CornersLanes local_a(a);
    const CornersLanes local_b(b);
    for (std::size_t s = 0; s < face_lines; ++s) {
      x_[s] = joined(local_a.x[s], local_b.x[s]);
      y_[s] = joined(local_a.y[s], local_b.y[s]);
    }
    run();
  }

  /// The lines of the four.
  Lines chosen() const { return chosen_; }

  /// False where corners are too close to equally good to decide which is the first of the best.
  hn::Mask<TwoTag> is_clear() const { return is_clear_; }

 private:
  struct Values {
    Floats at[face_lines];
  };

  HWY_INLINE void run() {
    const Floats equal = all_floats(static_cast<float>(tolerance::aligned));
    const Floats squared = largest(squares(x_, y_));
    Values values;
    for (std::size_t s = 0; s < face_lines; ++s) {
      values.at[s] = hn::Add(hn::Mul(x_[s], sink_[0]), hn::Mul(y_[s], sink_[1]));
    }
    const Lines start = best(values, hn::Mul(equal, hn::Sqrt(squared)));
    const LineOfEach<TwoTag> at_start(start);
    const Floats start_x = at_start.of([this](std::size_t s) { return x_[s]; });
    const Floats start_y = at_start.of([this](std::size_t s) { return y_[s]; });
    Floats x[face_lines];
    Floats y[face_lines];
    for (std::size_t s = 0; s < face_lines; ++s) {
      x[s] = hn::Sub(x_[s], start_x);
      y[s] = hn::Sub(y_[s], start_y);
    }
    const Floats slack = hn::Mul(equal, squared);
    const Lines end = best(squares(x, y), slack);
    const LineOfEach<TwoTag> at_end(end);
    const Floats way_x = hn::Mul(at_end.of([&x](std::size_t s) { return x[s]; }), area_);
    const Floats way_y = hn::Mul(at_end.of([&y](std::size_t s) { return y[s]; }), area_);
    Values opposite;
    for (std::size_t s = 0; s < face_lines; ++s) {
      values.at[s] = hn::Sub(hn::Mul(way_x, y[s]), hn::Mul(way_y, x[s]));
      opposite.at[s] = hn::Neg(values.at[s]);
    }
    chosen_ = hn::Or(hn::Or(start, end), hn::Or(best(values, slack), best(opposite, slack)));
  }

  HWY_INLINE Values squares(const Floats (&x)[face_lines], const Floats (&y)[face_lines]) const {
    Values result;
    for (std::size_t s = 0; s < face_lines; ++s) {
      result.at[s] = hn::Add(hn::Mul(hn::Mul(x[s], x[s]), xx_),
                             hn::Add(hn::Mul(hn::Mul(y[s], y[s]), yy_), hn::Mul(hn::Mul(x[s], y[s]), xy_)));
    }
    return result;
  }

  HWY_INLINE static Floats largest(const Values& values) {
    return over_lines(Largest(), [&](std::size_t s) { return values.at[s]; });
  }

  /// The first of those as good as the best up to the slack, if it is the first corner or the only one.
  HWY_INLINE Lines best(const Values& values, Floats slack) {
    const Floats least = hn::Sub(largest(values), slack);
    const Lines good =
        hn::And(left_, over_lines(All(), [&](std::size_t s) { return line_where(hn::Ge(values.at[s], least), s); }));
    const Lines chosen = first_of(good);
    const auto is_first = hn::RebindMask(TwoTag(), hn::Eq(chosen, first_of(left_)));
    const auto is_sure = hn::Or(is_first, are_none(but_the_first(good)));
    if (!hn::AllTrue(TwoTag(), is_sure)) {
      is_clear_ = hn::And(is_clear_, hn::Or(is_sure, is_first_of_good(chosen, values, slack)));
    }
    return chosen;
  }

  /// Whether a sequential search, which takes each corner that is better by more than the slack, ends with this one: it
  /// is better than all that are not as good as the best, and none is better than it.
  HWY_NOINLINE static hn::Mask<TwoTag> is_first_of_good(Lines chosen, const Values& values, Floats slack) {
    const Floats least = hn::Sub(largest(values), slack);
    const Floats value = LineOfEach<TwoTag>(chosen).of([&values](std::size_t s) { return values.at[s]; });
    const Floats limit = hn::Add(value, slack);
    auto result = hn::RebindMask(TwoTag(), hn::Ne(chosen, hn::Zero(LinesTag())));
    for (std::size_t s = 0; s < face_lines; ++s) {
      const auto is_good = hn::Ge(values.at[s], least);
      const auto is_less = hn::Gt(value, hn::Add(values.at[s], slack));
      result = hn::And(result, hn::And(hn::Le(values.at[s], limit), hn::Or(is_good, is_less)));
    }
    return result;
  }

  Lines left_;
  Lines chosen_;
  hn::Mask<TwoTag> is_clear_;
  Floats xx_, yy_, xy_, area_;
  Floats sink_[2];
  Floats x_[face_lines], y_[face_lines];
};

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
