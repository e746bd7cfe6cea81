// SPDX-License-Identifier: MIT
// FaceOverFace of query/fast_contact/obb/faces.hpp for many pairs, bit-identical. Included once per instruction set, so
// it has no ordinary include guard.
#if defined(GRAZE_BROAD_CONTACTS_OBB_CLIP_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_OBB_CLIP_INL_HPP
#undef GRAZE_BROAD_CONTACTS_OBB_CLIP_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_OBB_CLIP_INL_HPP
#endif

#include <cstddef>

#include <hwy/highway.h>

#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/query/fast_contact/obb/faces.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

/// A face like BoxFace: middle + x * right + y * up.
struct FaceLanes {
  Point middle;
  Point right;
  Point up;
  Doubles half_right;
  Doubles half_up;
};

/// The contact's normal away from the reference face, and that face's own, which equals it up to 1e-5.
struct UpwardLanes {
  Point up;
  Point normal;
};

/// A position in the incident face, in units of its half edges.
struct Place {
  Doubles at[2];
};

HWY_INLINE Place one_of(DoublesMask mask, const Place& yes, const Place& no) {
  return {{hn::IfThenElse(mask, yes.at[0], no.at[0]), hn::IfThenElse(mask, yes.at[1], no.at[1])}};
}

/// What remains of the incident faces.
class ClipLanes {
 public:
  /// Whether rounding hides the orientation, or the reference face is nearly degenerate.
  DoublesMask is_open() const { return is_open_; }

  /// The height above the reference face.
  HWY_INLINE Doubles height_of(Doubles x, Doubles y) const {
    return hn::Add(height_, hn::Add(hn::Mul(climb_[0], x), hn::Mul(climb_[1], y)));
  }
  Doubles climb(std::size_t k) const { return climb_[k]; }

  /// The lines on which sides remain.
  Bits left() const { return left_; }
  DoublesMask is_left(std::size_t line) const { return has_bit(left_, line); }

  // For the side on a line, if any remains: its start, one of the corners.

  Doubles within(std::size_t line, std::size_t k) const { return start_[line].at[k]; }
  /// As line_pair.
  Bits lines(std::size_t line) const { return lines_[line]; }
  /// As in places_on_faces.
  Bits turns() const { return turns_; }

 private:
  friend class FaceClip;

  DoublesMask is_open_;
  Bits left_;
  Bits turns_;
  Doubles height_;
  Doubles climb_[2];
  Place start_[face_lines];
  Bits lines_[face_lines];
};

/// Calculates a ClipLanes. A separate class, because its members would be stored to memory if they were part of the
/// result.
class FaceClip {
 public:
  HWY_INLINE FaceClip(const FaceLanes& incident, const FaceLanes& reference, const UpwardLanes& upward, Doubles slack)
      : slack_(slack) {
    left_ = hn::Zero(BitsTag());
    place_incident(incident, reference, upward);
    cut_sides();
    find_corners_of_reference();
    close();
    const Doubles highest = hn::Add(height_, hn::Add(hn::Abs(climb_[0]), hn::Abs(climb_[1])));
    const DoublesMask may_be = hn::Gt(highest, slack_);
    start_[top_line] = start_[0];
    lines_[top_line] = hn::Zero(BitsTag());
    if (hn::AllFalse(Tag<double>(), may_be)) return;
    const DoublesMask needed = hn::And(may_be, is_high(incident, reference));
    if (!hn::AllFalse(Tag<double>(), needed)) cut_top(needed);
  }

  HWY_INLINE void give(ClipLanes& to) const {
    to.is_open_ = is_open_;
    to.left_ = left_;
    to.turns_ = turns_;
    to.height_ = height_;
    unrolled<2>([&](auto k) GRAZE_INLINE_LAMBDA { to.climb_[k] = climb_[k]; });
    unrolled<face_lines>([&](auto line) GRAZE_INLINE_LAMBDA {
      unrolled<2>([&](auto k) GRAZE_INLINE_LAMBDA { to.start_[line].at[k] = start_[line].at[k]; });
      to.lines_[line] = lines_[line];
    });
  }

 private:
  HWY_INLINE Doubles height_of(Doubles x, Doubles y) const {
    return hn::Add(height_, hn::Add(hn::Mul(climb_[0], x), hn::Mul(climb_[1], y)));
  }
  DoublesMask is_left(std::size_t line) const { return has_bit(left_, line); }

  HWY_INLINE void place_incident(const FaceLanes& incident, const FaceLanes& reference, const UpwardLanes& upward) {
    const Point& up = upward.up;
    is_open_ = hn::Not(hn::Gt(min_of(reference.half_right, reference.half_up), hn::Mul(both(1e3), slack_)));
    const Point across[2] = {cross(reference.up, up), cross(up, reference.right)};
    const Doubles inverse = hn::Div(both(1), dot(across[0], reference.right));
    const Point way = incident.middle - reference.middle;
    const auto seen = [&](std::size_t k, const Point& v) { return hn::Mul(dot(across[k], v), inverse); };
    for (std::size_t k = 0; k < 2; ++k) {
      middle_[k] = seen(k, way);
      right_[k] = seen(k, incident.right);
      up_side_[k] = seen(k, incident.up);
    }
    turn_around();
    const Doubles by_area = hn::Mul(slack_, hn::Abs(inverse));
    const Doubles by_both = hn::Mul(by_area, inverse_area_);
    limit_[0] = hn::Add(hn::Mul(reference.half_up, by_area), both(1));
    limit_[1] = hn::Add(hn::Mul(reference.half_right, by_area), both(1));
    limit_within_[0] = hn::Sub(both(1), hn::Mul(incident.half_up, by_both));
    limit_within_[1] = hn::Sub(both(1), hn::Mul(incident.half_right, by_both));
    const Point rise = upward.normal * hn::Div(both(1), dot(upward.normal, up));
    height_ = dot(rise, way);
    climb_[0] = dot(rise, incident.right);
    climb_[1] = dot(rise, incident.up);
  }

  /// So that x grows along the incident face's right, and both faces have the same orientation.
  HWY_INLINE void turn_around() {
    const Doubles area = hn::Sub(hn::Mul(right_[0], up_side_[1]), hn::Mul(right_[1], up_side_[0]));
    inverse_area_ = hn::Div(both(1), hn::Abs(area));
    const Doubles turned_x = hn::CopySign(both(1), right_[0]);
    const Doubles turned[2] = {turned_x, hn::Mul(turned_x, hn::CopySign(both(1), area))};
    for (std::size_t k = 0; k < 2; ++k) {
      middle_[k] = hn::Mul(middle_[k], turned[k]);
      right_[k] = hn::Mul(right_[k], turned[k]);
      up_side_[k] = hn::Mul(up_side_[k], turned[k]);
    }
    turns_ = hn::Or(bit_where(hn::Lt(turned[0], both(0)), 0), bit_where(hn::Lt(turned[1], both(0)), 1));
  }

  /// A side of the incident face, and the lines where its remaining part starts and ends, in the form of line_pair: the
  /// previous side's and its own if nothing is cut off, negative if nothing remains.
  struct Edge {
    Place start;
    Place end;
    Doubles begins;
    Doubles finishes;
  };

  HWY_INLINE static Bits pair_of(std::size_t ends, std::size_t starts) {
    return hn::Set(BitsTag(), line_pair(ends, starts));
  }
  HWY_INLINE static Doubles ending(std::size_t line) { return both(static_cast<double>(line_pair(line, 0))); }

  /// Where sides enter and leave the strips |x| <= 1 and |y| <= 1.
  struct Direction {
    Doubles inverse[2];
    Doubles near[2];
    Doubles far[2];

    HWY_INLINE explicit Direction(const Doubles (&along)[2]) {
      const DoublesMask by_x = hn::Gt(along[0], both(0));
      const DoublesMask by_y = hn::Gt(along[1], both(0));
      for (std::size_t k = 0; k < 2; ++k) inverse[k] = hn::Div(both(1), along[k]);
      near[0] = hn::IfThenElse(by_x, ending(7), ending(5));
      far[0] = hn::IfThenElse(by_x, ending(5), ending(7));
      near[1] = hn::IfThenElse(by_y, ending(4), ending(6));
      far[1] = hn::IfThenElse(by_y, ending(6), ending(4));
    }
  };

  /// As in FaceOverFace: a strip cuts off only corners that are outside of it.
  struct Part {
    Doubles low;
    Doubles high;
    Doubles low_line;
    Doubles high_line;

    HWY_INLINE Part(const Direction& along, const Doubles (&base)[2], const DoublesMask (&low_is_out)[2],
                    const DoublesMask (&high_is_out)[2], Doubles low_own, Doubles high_own) {
      Doubles near[2];
      Doubles far[2];
      for (std::size_t k = 0; k < 2; ++k) {
        const Doubles at_minus = hn::Mul(hn::Sub(both(-1), base[k]), along.inverse[k]);
        const Doubles at_plus = hn::Mul(hn::Sub(both(1), base[k]), along.inverse[k]);
        near[k] = hn::IfThenElse(low_is_out[k], hn::Min(at_minus, at_plus), both(-1));
        far[k] = hn::IfThenElse(high_is_out[k], hn::Max(at_minus, at_plus), both(1));
      }
      low = hn::Max(hn::Max(near[0], near[1]), both(-1));
      high = hn::Min(hn::Min(far[0], far[1]), both(1));
      const DoublesMask is_left = hn::Lt(low, high);
      const Doubles entry = hn::IfThenElse(hn::Gt(near[1], near[0]), along.near[1], along.near[0]);
      const Doubles exit = hn::IfThenElse(hn::Lt(far[1], far[0]), along.far[1], along.far[0]);
      low_line = hn::IfThenElse(is_left, hn::IfThenElse(hn::Gt(low, both(-1)), entry, low_own), both(-1));
      high_line = hn::IfThenElse(is_left, hn::IfThenElse(hn::Lt(high, both(1)), exit, high_own), both(-1));
    }
  };

  HWY_INLINE void cut_sides() {
    Doubles low[2], high[2], left[2], right[2];
    DoublesMask out[4][2];
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = hn::Sub(middle_[k], up_side_[k]);
      high[k] = hn::Add(middle_[k], up_side_[k]);
      left[k] = hn::Sub(middle_[k], right_[k]);
      right[k] = hn::Add(middle_[k], right_[k]);
      const auto is_out = [&](Doubles corner) { return hn::Gt(hn::Abs(corner), limit_[k]); };
      out[0][k] = is_out(hn::Sub(left[k], up_side_[k]));
      out[1][k] = is_out(hn::Sub(right[k], up_side_[k]));
      out[2][k] = is_out(hn::Add(right[k], up_side_[k]));
      out[3][k] = is_out(hn::Add(left[k], up_side_[k]));
    }
    const Direction across(right_);
    const Direction along(up_side_);
    const Part bottom(across, low, out[0], out[1], ending(3), ending(0));
    const Part end(along, right, out[1], out[2], ending(0), ending(1));
    const Part top(across, high, out[3], out[2], ending(2), ending(1));
    const Part begin(along, left, out[0], out[3], ending(3), ending(2));
    put<0>({{{bottom.low, both(-1)}}, {{bottom.high, both(-1)}}, bottom.low_line, bottom.high_line});
    put<1>({{{both(1), end.low}}, {{both(1), end.high}}, end.low_line, end.high_line});
    put<2>({{{top.high, both(1)}}, {{top.low, both(1)}}, top.high_line, top.low_line});
    put<3>({{{both(-1), begin.high}}, {{both(-1), begin.low}}, begin.high_line, begin.low_line});
  }

  template <std::size_t line>
  HWY_INLINE void put(const Edge& edge) {
    edges_[line] = edge;
    start_[line] = edge.start;
    lines_[line] = whole(hn::Add(hn::Max(edge.begins, both(0)), both(static_cast<double>(line))));
    left_ = hn::Or(left_, bit_where(hn::Ge(edge.begins, both(0)), line));
  }

  /// The corners of the reference face that are inside the incident face, farther from its sides than the slack.
  HWY_INLINE void find_corners_of_reference() {
    Doubles by_right[2][2];  // y of the other face from x at -1 and 1, and x from y; the lesser and the greater of them
    Doubles by_up[2][2];
    unrolled<2>([&](auto k) GRAZE_INLINE_LAMBDA {
      const Doubles low = hn::Sub(both(-1), middle_[k]);
      const Doubles high = hn::Sub(both(1), middle_[k]);
      by_right[k][0] = hn::Mul(low, right_[1 - k]);
      by_right[k][1] = hn::Mul(high, right_[1 - k]);
      by_up[k][0] = hn::Mul(low, up_side_[1 - k]);
      by_up[k][1] = hn::Mul(high, up_side_[1 - k]);
    });
    const auto corner = [&](std::size_t number, std::size_t x, std::size_t y) {
      Place& place = corners_[number];
      place.at[0] = hn::Mul(hn::Sub(by_up[0][x], by_up[1][y]), inverse_area_);
      place.at[1] = hn::Mul(hn::Sub(by_right[1][y], by_right[0][x]), inverse_area_);
      is_corner_[number] =
          hn::And(hn::Lt(hn::Abs(place.at[0]), limit_within_[0]), hn::Lt(hn::Abs(place.at[1]), limit_within_[1]));
    };
    corner(0, 0, 0);
    corner(1, 1, 0);
    corner(2, 1, 1);
    corner(3, 0, 1);
  }

  /// Calls use(edge, where) for the sides of the incident face that may leave or enter through a line of the reference
  /// face. The first one's x increases, and the third one's decreases.
  template <std::size_t line, bool leaving, class Use>
  HWY_INLINE void for_each_cut(const Use& use) const {
    unrolled<4>([&](auto e) GRAZE_INLINE_LAMBDA {
      if ((line == 5 && e == (leaving ? 2 : 0)) || (line == 7 && e == (leaving ? 0 : 2))) return;
      use(e, hn::Eq(leaving ? edges_[e].finishes : edges_[e].begins, ending(line)));
    });
  }

  /// The side on a line of the reference face starts where one of the incident face leaves through it, or at a corner.
  template <std::size_t line>
  HWY_INLINE void put_side() {
    constexpr std::size_t corner = line - reference_lines;
    DoublesMask starts = is_corner_[corner];
    Place start = corners_[corner];
    Bits lines = pair_of(reference_lines + (corner + 3) % 4, line);
    DoublesMask is_open = no_lane();
    for_each_cut<line, true>([&](std::size_t e, DoublesMask where) GRAZE_INLINE_LAMBDA {
      is_open = hn::Or(is_open, hn::And(starts, where));
      starts = hn::Or(starts, where);
      start = one_of(where, edges_[e].end, start);
      lines = hn::IfThenElse(hn::RebindMask(BitsTag(), where), pair_of(e, line), lines);
    });
    DoublesMask ends = is_corner_[(corner + 1) % 4];
    for_each_cut<line, false>([&](std::size_t, DoublesMask where) GRAZE_INLINE_LAMBDA { ends = hn::Or(ends, where); });
    is_open_ = hn::Or(is_open_, hn::Or(is_open, hn::Xor(starts, ends)));
    left_ = hn::Or(left_, bit_where(starts, line));
    start_[line] = start;
    lines_[line] = lines;
  }

  HWY_INLINE void close() {
    put_side<4>();
    put_side<5>();
    put_side<6>();
    put_side<7>();
    unrolled<4>([&](auto e) GRAZE_INLINE_LAMBDA {
      const DoublesMask ends_whole = hn::Eq(edges_[e].finishes, ending(e));
      const DoublesMask starts_whole = hn::Eq(edges_[(e + 1) % 4].begins, ending(e));
      is_open_ = hn::Or(is_open_, hn::Xor(ends_whole, starts_whole));
    });
  }

  template <std::size_t line>
  HWY_INLINE Place end_of_side() const {
    Place end = corners_[(line - reference_lines + 1) % 4];
    for_each_cut<line, false>([&](std::size_t e, DoublesMask where)
                                  GRAZE_INLINE_LAMBDA { end = one_of(where, edges_[e].start, end); });
    return end;
  }

  /// Whether a corner is too high above the reference face for resting, as in FaceOverFace::resting_height.
  HWY_INLINE DoublesMask is_high(const FaceLanes& incident, const FaceLanes& reference) const {
    const Doubles halves =
        min_of(hn::Add(incident.half_right, incident.half_up), hn::Add(reference.half_right, reference.half_up));
    const Doubles resting = hn::Mul(both(2 * tolerance::aligned), halves);
    DoublesMask result = no_lane();
    unrolled<top_line>([&](auto line) GRAZE_INLINE_LAMBDA {
      const Doubles at_start = height_of(start_[line].at[0], start_[line].at[1]);
      result = hn::Or(result, hn::And(is_left(line), hn::Gt(at_start, resting)));
    });
    return result;
  }

  /// Removes what is above the reference face by more than the slack, in the lanes that need it. The side that leads
  /// out ends where the new one starts, and the one that leads back starts where it ends.
  HWY_INLINE void cut_top(DoublesMask needed) {
    const Place ends[top_line] = {edges_[0].end,    edges_[1].end,    edges_[2].end,    edges_[3].end,
                                  end_of_side<4>(), end_of_side<5>(), end_of_side<6>(), end_of_side<7>()};
    DoublesMask has_exit = no_lane();
    DoublesMask has_entry = no_lane();
    DoublesMask has_outside = no_lane();
    Place start = start_[0];
    Bits lines = hn::Zero(BitsTag());
    unrolled<top_line>([&](auto line) GRAZE_INLINE_LAMBDA {
      const Place& end = ends[line];
      const Doubles at_start = height_of(start_[line].at[0], start_[line].at[1]);
      const Doubles at_end = height_of(end.at[0], end.at[1]);
      const DoublesMask looked_at = hn::And(needed, is_left(line));
      const DoublesMask starts_out = hn::And(looked_at, hn::Gt(at_start, slack_));
      const DoublesMask ends_out = hn::And(looked_at, hn::Gt(at_end, slack_));
      left_ = hn::AndNot(bit_where(hn::And(starts_out, ends_out), line), left_);
      has_outside = hn::Or(has_outside, starts_out);
      const DoublesMask is_exit = hn::AndNot(starts_out, ends_out);
      const DoublesMask is_entry = hn::AndNot(ends_out, starts_out);
      is_open_ = hn::Or(is_open_, hn::Or(hn::And(has_exit, is_exit), hn::And(has_entry, is_entry)));
      has_exit = hn::Or(has_exit, is_exit);
      has_entry = hn::Or(has_entry, is_entry);
      const Place crossing = between(start_[line], end, hn::Div(at_start, hn::Sub(at_start, at_end)));
      start = one_of(is_exit, crossing, start);
      lines = hn::IfThenElse(hn::RebindMask(BitsTag(), is_exit), pair_of(line, top_line), lines);
      start_[line] = one_of(is_entry, crossing, start_[line]);
      lines_[line] = hn::IfThenElse(hn::RebindMask(BitsTag(), is_entry), pair_of(top_line, line), lines_[line]);
    });
    is_open_ = hn::Or(is_open_, hn::AndNot(hn::And(has_exit, has_entry), has_outside));
    left_ = hn::Or(left_, bit_where(has_exit, top_line));
    start_[top_line] = start;
    lines_[top_line] = lines;
  }

  HWY_INLINE static Place between(const Place& start, const Place& end, Doubles share) {
    const Doubles part = hn::Min(hn::Max(share, both(0)), both(1));
    Place result;
    for (std::size_t k = 0; k < 2; ++k) {
      result.at[k] = hn::Add(start.at[k], hn::Mul(hn::Sub(end.at[k], start.at[k]), part));
    }
    return result;
  }

  Doubles slack_;
  DoublesMask is_open_;
  Bits left_;
  Doubles height_;
  Doubles climb_[2];
  Doubles middle_[2];
  Doubles right_[2];
  Doubles up_side_[2];
  Doubles limit_[2];
  Doubles limit_within_[2];
  Doubles inverse_area_;
  Bits turns_;
  Edge edges_[4];
  Place corners_[4];  ///< Of the reference face.
  DoublesMask is_corner_[4];
  Place start_[face_lines];
  Bits lines_[face_lines];
};

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
