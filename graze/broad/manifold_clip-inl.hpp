// SPDX-License-Identifier: MIT
// FaceOverFace of query/obb_faces.hpp for many pairs at a time, to the bit. What is left of an incident face has at
// most one side on each of nine lines, its own four and those that cut it, and that is where each lane keeps it:
// nothing is moved from place to place. Included once for each instruction set, hence no ordinary guard.
#if defined(GRAZE_BROAD_MANIFOLD_CLIP_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_MANIFOLD_CLIP_INL_HPP
#undef GRAZE_BROAD_MANIFOLD_CLIP_INL_HPP
#else
#define GRAZE_BROAD_MANIFOLD_CLIP_INL_HPP
#endif

#include <cstddef>

#include <hwy/highway.h>

#include <graze/broad/manifold_lanes-inl.hpp>
#include <graze/broad/manifold_lines.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

/// One of a number for each line, by an operation on two of them. By pairs, and pairs of pairs: what goes through all
/// one after the other waits nine times.
template <class Operation, class Number>
HWY_INLINE auto over_lines(const Operation& operation, const Number& number) {
  static_assert(clip_lines == 9);
  const auto low = operation(operation(number(0), number(1)), operation(number(2), number(3)));
  const auto high = operation(operation(number(4), number(5)), operation(number(6), number(7)));
  return operation(operation(low, high), number(8));
}

struct Least {
  template <class V>
  HWY_INLINE V operator()(const V& a, const V& b) const {
    return hn::Min(a, b);
  }
};
struct Largest {
  template <class V>
  HWY_INLINE V operator()(const V& a, const V& b) const {
    return hn::Max(a, b);
  }
};
struct Total {
  template <class V>
  HWY_INLINE V operator()(const V& a, const V& b) const {
    return hn::Add(a, b);
  }
};
/// Of numbers that are zero, or all the same.
struct Common {
  template <class V>
  HWY_INLINE V operator()(const V& a, const V& b) const {
    return hn::Or(a, b);
  }
};

/// A face as BoxFace: middle + x * right + y * up.
struct FaceLanes {
  Point middle;
  Point right;
  Point up;
};

/// Where a corner is over the reference face, and in the incident one, in halves of their edges.
struct CornerLanes {
  Doubles at[4];  ///< Along x and y over the one, then within the other.
};

/// The contact's normal away from the reference face, and that face's own, which is equal to it but for 1e-5 at most.
struct UpwardLanes {
  Point up;
  Point normal;
};

class ClipLanes {
 public:
  HWY_INLINE ClipLanes(const FaceLanes& incident, const FaceLanes& reference, const UpwardLanes& upward, Doubles slack)
      : slack_(slack), is_open_(no_lane()) {
    place_incident(incident, reference, upward);
    const auto least = [this](std::size_t k) { return hn::Sub(middle_[k], reach_[k]); };
    const auto most = [this](std::size_t k) { return hn::Add(middle_[k], reach_[k]); };
    const Doubles limit[2] = {hn::Add(slack_in_halves_[0], both(1)), hn::Add(slack_in_halves_[1], both(1))};
    const Doubles zero = both(0);
    cut<4>(hn::Lt(hn::Add(least(1), limit[1]), zero), slack_in_halves_[1],
           [](const CornerLanes& corner) { return hn::Sub(both(-1), corner.at[1]); });
    cut<5>(hn::Gt(hn::Sub(most(0), limit[0]), zero), slack_in_halves_[0],
           [](const CornerLanes& corner) { return hn::Sub(corner.at[0], both(1)); });
    cut<6>(hn::Gt(hn::Sub(most(1), limit[1]), zero), slack_in_halves_[1],
           [](const CornerLanes& corner) { return hn::Sub(corner.at[1], both(1)); });
    cut<7>(hn::Lt(hn::Add(least(0), limit[0]), zero), slack_in_halves_[0],
           [](const CornerLanes& corner) { return hn::Sub(both(-1), corner.at[0]); });
    const Doubles highest = hn::Add(height_, hn::Add(hn::Abs(climb_[0]), hn::Abs(climb_[1])));
    cut<8>(hn::Gt(highest, slack_), slack_,
           [this](const CornerLanes& corner) { return height_of(corner.at[2], corner.at[3]); });
  }

  /// Where rounding hides the way around, or the reference face is hardly one.
  DoublesMask is_open() const { return is_open_; }

  HWY_INLINE Doubles height_of(Doubles x, Doubles y) const {
    return hn::Add(height_, hn::Add(hn::Mul(climb_[0], x), hn::Mul(climb_[1], y)));
  }

  // Of the side on line `slot`, if any is left: its start, one of the corners. The first corner has the least rank.
  DoublesMask is_left(std::size_t slot) const { return is_left_[slot]; }
  Doubles rank(std::size_t slot) const { return rank_[slot]; }
  Doubles within(std::size_t slot, std::size_t k) const { return start_[slot].at[2 + k]; }
  Doubles lines(std::size_t slot) const { return lines_[slot]; }
  Doubles climb(std::size_t k) const { return climb_[k]; }

 private:
  HWY_INLINE void place_incident(const FaceLanes& incident, const FaceLanes& reference, const UpwardLanes& upward) {
    const Point& up = upward.up;
    const Point across_up = cross(reference.up, up);
    const Point across_right = cross(up, reference.right);
    const Doubles area = dot(across_up, reference.right);
    const Doubles length_right = hn::Sqrt(dot(reference.right, reference.right));
    const Doubles length_up = hn::Sqrt(dot(reference.up, reference.up));
    is_open_ = hn::Not(hn::Gt(min_of(length_right, length_up), hn::Mul(both(1e3), slack_)));
    slack_in_halves_[0] = hn::Div(slack_, length_right);
    slack_in_halves_[1] = hn::Div(slack_, length_up);
    const Doubles inverse = hn::Div(both(1), area);
    const Point way = incident.middle - reference.middle;
    Doubles x[2];
    Doubles y[2];
    const Point& of_x = across_up;
    const Point& of_y = across_right;
    for (std::size_t k = 0; k < 2; ++k) {
      const Point& across = k == 0 ? of_x : of_y;
      middle_[k] = hn::Mul(dot(across, way), inverse);
      x[k] = hn::Mul(dot(across, incident.right), inverse);
      y[k] = hn::Mul(dot(across, incident.up), inverse);
      reach_[k] = hn::Add(hn::Abs(x[k]), hn::Abs(y[k]));
    }
    const Point rise = upward.normal / dot(upward.normal, up);
    height_ = dot(rise, way);
    climb_[0] = dot(rise, incident.right);
    climb_[1] = dot(rise, incident.up);
    place_corners(x, y);
  }

  HWY_INLINE void place_corners(const Doubles (&x)[2], const Doubles (&y)[2]) {
    CornerLanes corners[4];
    for (std::size_t k = 0; k < 2; ++k) {
      const Doubles less = hn::Sub(middle_[k], x[k]);
      const Doubles more = hn::Add(middle_[k], x[k]);
      corners[0].at[k] = hn::Sub(less, y[k]);
      corners[1].at[k] = hn::Sub(more, y[k]);
      corners[2].at[k] = hn::Add(more, y[k]);
      corners[3].at[k] = hn::Add(less, y[k]);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      corners[i].at[2] = both(i == 1 || i == 2 ? 1 : -1);
      corners[i].at[3] = both(i >= 2 ? 1 : -1);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      start_[i] = corners[i];
      end_[i] = corners[(i + 1) % 4];
      rank_[i] = both(static_cast<double>(i));
      lines_[i] = both(line_pair_number((i + 3) % 4, i));
      is_left_[i] = hn::Eq(rank_[i], rank_[i]);
    }
    for (std::size_t i = 4; i < clip_lines; ++i) {
      is_left_[i] = no_lane();
      rank_[i] = lines_[i] = both(0);
    }
  }

  /// What the cuts after this one, and the contact points, need of a corner: each number of it takes time to move.
  static constexpr bool is_needed_after(std::size_t line, std::size_t number) {
    return number >= 2 || line <= 5 || (line == 6 && number == 0);
  }

  template <std::size_t line>
  HWY_INLINE static CornerLanes crossing(const CornerLanes& start, const CornerLanes& end, Doubles height,
                                         Doubles height_of_end) {
    const Doubles share = hn::Div(height, hn::Sub(height, height_of_end));
    const Doubles between = hn::Min(hn::Max(share, both(0)), both(1));
    CornerLanes result = start;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!is_needed_after(line, k)) continue;
      result.at[k] = hn::Add(start.at[k], hn::Mul(hn::Sub(end.at[k], start.at[k]), between));
    }
    return result;
  }

  template <std::size_t line>
  HWY_INLINE static void put(CornerLanes& corner, const CornerLanes& other, DoublesMask where) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (is_needed_after(line, k)) corner.at[k] = hn::IfThenElse(where, other.at[k], corner.at[k]);
    }
  }

  /// The side on the line that cuts, as it is found from the sides that it cuts.
  struct NewSide {
    CornerLanes start;
    CornerLanes end;
    DoublesMask has_exit;
    DoublesMask has_outside;
    Doubles rank_of_exit;
    Doubles rank_of_entry;
    Doubles lines;
  };

  /// Leaves what is not above the line by more than the slack, in those lanes that need it. The side that leads out
  /// ends where the new one starts, and the one that leads back starts where it ends.
  template <std::size_t line, class Height>
  HWY_INLINE void cut(DoublesMask needed, Doubles slack, const Height& height) {
    if (hn::AllFalse(Tag<double>(), needed)) return;
    const Doubles zero = both(0);
    NewSide side{start_[0], start_[0], no_lane(), no_lane(), zero, zero, zero};
    for (std::size_t s = 0; s < line; ++s) {
      const CornerLanes from = start_[s];
      const CornerLanes to = end_[s];
      const DoublesMask looked_at = hn::And(needed, is_left_[s]);
      const Doubles height_from = height(from);
      const Doubles height_to = height(to);
      const DoublesMask is_start_out = hn::And(looked_at, hn::Gt(height_from, slack));
      const DoublesMask is_end_out = hn::And(looked_at, hn::Gt(height_to, slack));
      is_left_[s] = hn::AndNot(hn::And(is_start_out, is_end_out), is_left_[s]);
      side.has_outside = hn::Or(side.has_outside, is_start_out);
      const CornerLanes corner = crossing<line>(from, to, height_from, height_to);
      cut_side<line>(s, side, corner, hn::AndNot(is_start_out, is_end_out), hn::AndNot(is_end_out, is_start_out));
    }
    is_open_ = hn::Or(is_open_, hn::AndNot(side.has_exit, side.has_outside));
    is_left_[line] = side.has_exit;
    start_[line] = side.start;
    end_[line] = side.end;
    lines_[line] = side.lines;
    // The entry is the first corner if what was is cut off, and what starts at the exit the last one.
    rank_[line] = hn::IfThenElse(hn::Gt(side.rank_of_entry, side.rank_of_exit),
                                 hn::Mul(both(0.5), hn::Add(side.rank_of_exit, side.rank_of_entry)),
                                 hn::Add(side.rank_of_exit, both(1)));
  }

  /// With the corner where it crosses the line.
  template <std::size_t line>
  HWY_INLINE void cut_side(std::size_t s, NewSide& side, const CornerLanes& corner, DoublesMask is_exit,
                           DoublesMask is_entry) {
    is_open_ = hn::Or(is_open_, hn::And(side.has_exit, is_exit));
    side.has_exit = hn::Or(side.has_exit, is_exit);
    put<line>(end_[s], corner, is_exit);
    put<line>(side.start, corner, is_exit);
    side.rank_of_exit = hn::IfThenElse(is_exit, rank_[s], side.rank_of_exit);
    side.lines = hn::IfThenElse(is_exit, both(line_pair_number(s, line)), side.lines);
    put<line>(start_[s], corner, is_entry);
    put<line>(side.end, corner, is_entry);
    side.rank_of_entry = hn::IfThenElse(is_entry, rank_[s], side.rank_of_entry);
    lines_[s] = hn::IfThenElse(is_entry, both(line_pair_number(line, s)), lines_[s]);
  }

  Doubles slack_;
  DoublesMask is_open_;
  Doubles slack_in_halves_[2];
  Doubles height_;
  Doubles climb_[2];
  Doubles middle_[2];
  Doubles reach_[2];
  CornerLanes start_[clip_lines];
  CornerLanes end_[clip_lines];
  Doubles rank_[clip_lines];
  Doubles lines_[clip_lines];
  DoublesMask is_left_[clip_lines];
};

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
