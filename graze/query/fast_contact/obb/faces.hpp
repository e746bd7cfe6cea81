// SPDX-License-Identifier: MIT
// Clips one face of a box to another: what patch/clipped.hpp does for any two polygons, specialised for two rectangles
// in the coordinates of one of them, whose sides are |x| <= 1 and |y| <= 1. Sides are clipped by strips as in Liang and
// Barsky (A New Concept and Method for Line Clipping, 1984), each independently, so that a corner depends only on its
// two lines.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <graze/math/lanes/lanes.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cores/features.hpp>
#include <graze/query/patch/clipped.hpp>
#include <graze/query/patch/manifold_points.hpp>
#include <graze/query/patch/patch.hpp>
#include <graze/shape/obb.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// An oriented box, two coordinates at a time: read as they were written, so that store forwarding works.
struct PairedBox {
  PairedVec center;
  PairedVec axes[3];
  PairedVec half_edges[3];
  double half[3];  ///< The half lengths, except for the lengths of the axes, which are about 1.
};

template <class T>
[[gnu::always_inline]] inline PairedBox paired_box(const Obb<3, T>& box, const Vec<3, double>& center) {
  const PairedVec x(box.axes[0]);
  const PairedVec y(box.axes[1]);
  const PairedVec z(box.axes[2]);
  const Vec<3, double> half(box.half_extents);
  return {PairedVec(center), {x, y, z}, {x * half.x, y * half.y, z * half.z}, {half.x, half.y, half.z}};
}

/// A face of a box, as the rectangle middle + x * right + y * up with |x|, |y| <= 1, where `right` belongs to the next
/// axis and `up` to the one after it.
struct BoxFace {
  BoxFaceNumbers numbers;
  PairedVec middle;
  PairedVec right;
  PairedVec up;
  double half_right;  ///< Their lengths, as in PairedBox.
  double half_up;
};

[[gnu::always_inline]] inline BoxFace face_of_box(const PairedBox& box, const BoxFaceNumbers& numbers) {
  return {numbers,
          box.center + box.half_edges[numbers.axis] * (numbers.is_far ? 1.0 : -1.0),
          box.half_edges[numbers.next()],
          box.half_edges[numbers.last()],
          box.half[numbers.next()],
          box.half[numbers.last()]};
}

/// A contact point on the surfaces of two boxes, as SurfacePair.
struct PairedPoints {
  PairedVec point_a;
  PairedVec point_b;
  double depth;
  Feature feature_a;
  Feature feature_b;
};

// ---- The features that a corner of a clipped face lies on, by the lines that meet there. From tables, since branches
// that differ from corner to corner are mispredicted.

/// The lines that bound the clipped face: 0 to 3 are the sides of the incident face, in order; 4 to 7 those of the
/// reference face, in the same sense of rotation after its coordinates are mirrored, y = -1 first; 8 is its plane. Two
/// consecutive lines meet in a corner, which is identified by the line that starts there.
inline constexpr std::size_t face_lines = 9;
inline constexpr std::size_t reference_lines = 4;
inline constexpr std::size_t top_line = 8;

/// The corner where the side on one line ends and that on another starts.
constexpr std::size_t line_pair(std::size_t ends, std::size_t starts) { return face_lines * ends + starts; }

/// The features of each side of a 3D box, by BoxFaceNumbers::face(): itself, its edges, its vertices.
inline constexpr std::uint32_t face_place = 0;
inline constexpr std::uint32_t edge_place = 1;
inline constexpr std::uint32_t vertex_place = 5;

inline constexpr auto features_of_faces = [] {
  std::array<std::array<Feature, 9>, 6> features{};
  for (std::uint32_t side = 0; side < 6; ++side) {
    const BoxFaceNumbers numbers{static_cast<Dim>(side / 2), side % 2 != 0};
    features[side][face_place] = {FeatureKind::face, side};
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
      features[side][edge_place + corner] = {FeatureKind::edge, numbers.edge(corner)};
      features[side][vertex_place + corner] = {FeatureKind::vertex, numbers.vertex(corner)};
    }
  }
  return features;
}();

/// The features of the two faces that a corner lies on, as indices into features_of_faces.
struct PlacesOnFaces {
  static constexpr std::size_t reference = 0;
  static constexpr std::size_t incident = 1;

  std::uint8_t on[2];
};

/// `turns` has bit 0 set if x was mirrored, and bit 1 if y was: that exchanges the sides across it.
constexpr PlacesOnFaces places_on_faces(std::uint32_t turns, std::uint32_t ends, std::uint32_t starts) {
  constexpr auto reference = static_cast<std::uint32_t>(reference_lines);
  constexpr auto top = static_cast<std::uint32_t>(top_line);
  const auto side = [turns](std::uint32_t line) {
    const std::uint32_t number = line - reference;
    return number ^ ((number % 2 != 0 ? turns & 1U : turns >> 1U) * 2);
  };
  const auto is_reference = [](std::uint32_t line) { return line >= reference && line < top; };
  PlacesOnFaces places{{face_place, face_place}};
  if (is_reference(ends) && is_reference(starts)) {
    const bool is_after = ((side(ends) + 1) & 3U) == side(starts);
    places.on[PlacesOnFaces::reference] = static_cast<std::uint8_t>(vertex_place + side(is_after ? starts : ends));
  } else if (is_reference(ends) || is_reference(starts)) {
    places.on[PlacesOnFaces::reference] =
        static_cast<std::uint8_t>(edge_place + side(is_reference(ends) ? ends : starts));
  }
  if (ends < reference && starts < reference) {
    places.on[PlacesOnFaces::incident] = static_cast<std::uint8_t>(vertex_place + starts);
  } else if (ends < reference || starts < reference) {
    places.on[PlacesOnFaces::incident] = static_cast<std::uint8_t>(edge_place + std::min(ends, starts));
  }
  return places;
}

inline constexpr auto places_by_lines = [] {
  std::array<std::array<PlacesOnFaces, face_lines * face_lines>, 4> places{};
  for (std::uint32_t turns = 0; turns < 4; ++turns) {
    for (std::uint32_t ends = 0; ends < face_lines; ++ends) {
      for (std::uint32_t starts = 0; starts < face_lines; ++starts) {
        places[turns][line_pair(ends, starts)] = places_on_faces(turns, ends, starts);
      }
    }
  }
  return places;
}();

/// The incident face clipped to the reference face. The result has at most one side on each line, and its start is a
/// corner.
class FaceOverFace {
 public:
  /// Projected along the contact's unit normal `up`, which equals `normal`, the reference face's own, up to 1e-5.
  /// Anything above or outside by up to `slack` is kept; everything is kept if nothing is above by more than `flush`,
  /// as in FacingPatches.
  [[gnu::always_inline]] FaceOverFace(const BoxFace& incident, const BoxFace& reference, const PairedVec& up,
                                      const PairedVec& normal, double slack, double flush)
      : incident_(incident), reference_(reference), up_(up), normal_(normal), slack_(slack), flush_(flush) {}

  /// False if rounding hides the order of the corners, or the reference face is degenerate.
  bool run() {
    if (!place_incident()) return false;
    cut_sides();
    find_corners_of_reference();
    if (!is_closed()) return false;
    const LanePair climb = magnitude(climb_);
    if (!(height_ + (climb[0] + climb[1]) > slack_)) return true;
    return cut_top();
  }

  /// The lines that still have sides, as bits.
  unsigned left() const { return left_; }
  /// The number of corners over the reference face and not above it.
  std::size_t size() const { return static_cast<std::size_t>(std::popcount(left_)); }
  /// The first of all corners, if there is any.
  std::size_t first() const { return static_cast<std::size_t>(std::countr_zero(left_)); }

  // Properties of the corner where the side on a line starts.

  double depth(std::size_t line) const { return std::max(0.0, -height_of(sides_[line].start)); }
  /// Its position in the incident face, in half edges.
  LanePair within(std::size_t line) const { return sides_[line].start; }

  /// The first of several.
  std::size_t deepest() const {
    std::size_t deepest = first();
    for (unsigned rest = left_; rest != 0; rest &= rest - 1) {
      const auto line = static_cast<std::size_t>(std::countr_zero(rest));
      if (depth(line) > depth(deepest)) deepest = line;
    }
    return deepest;
  }
  const BoxFace& incident() const { return incident_; }
  /// How much higher the incident face's right and up are than its middle.
  LanePair climb() const { return climb_; }
  /// With the reference face's box as the first.
  [[gnu::always_inline]] PairedPoints pair(std::size_t line) const {
    const Side& side = sides_[line];
    const double depth = this->depth(line);
    const PairedVec point = incident_.middle + incident_.right * side.start[0] + incident_.up * side.start[1];
    const PlacesOnFaces& places = places_by_lines[turns_][line_pair(side.before, line)];
    return {point + up_ * depth, point, depth,
            features_of_faces[reference_.numbers.face()][places.on[PlacesOnFaces::reference]],
            features_of_faces[incident_.numbers.face()][places.on[PlacesOnFaces::incident]]};
  }

 private:
  /// Its ends in the incident face, and the line of the side before it.
  struct Side {
    LanePair start;
    LanePair end;
    std::size_t before;
  };

  static constexpr std::size_t nowhere = face_lines;

  /// A point's coordinates across Y, X and the plane: x = n . (p x Y) / n . (X x Y), y = n . (X x p) / n . (X x Y).
  /// They are then mirrored so that x increases along the incident face's right and both faces have the same
  /// orientation.
  bool place_incident() {
    if (!(std::min(reference_.half_right, reference_.half_up) > 1e3 * slack_)) return false;
    const PairedVec across_up = cross(reference_.up, up_);
    const PairedVec across_right = cross(up_, reference_.right);
    const double inverse = 1 / dot(across_up, reference_.right);
    const auto seen = [&](const PairedVec& v) {
      return LanePair{dot(across_up, v) * inverse, dot(across_right, v) * inverse};
    };
    const PairedVec way = incident_.middle - reference_.middle;
    right_ = seen(incident_.right);
    up_side_ = seen(incident_.up);
    const double area = right_[0] * up_side_[1] - right_[1] * up_side_[0];
    const double turn = std::copysign(1.0, right_[0]);
    const LanePair turned{turn, turn * std::copysign(1.0, area)};
    middle_ = seen(way) * turned;
    right_ = right_ * turned;
    up_side_ = up_side_ * turned;
    turns_ = (turned[0] < 0 ? 1U : 0U) | (turned[1] < 0 ? 2U : 0U);
    inverse_area_ = 1 / std::fabs(area);
    const double by_area = slack_ * std::fabs(inverse);
    limit_ = LanePair{reference_.half_up, reference_.half_right} * by_area + 1.0;
    limit_within_ = 1.0 - LanePair{incident_.half_up, incident_.half_right} * (by_area * inverse_area_);
    const PairedVec rise = normal_ * (1 / dot(normal_, up_));  // about 1
    height_ = dot(rise, way);
    climb_ = LanePair{dot(rise, incident_.right), dot(rise, incident_.up)};
    return true;
  }

  [[gnu::always_inline]] double height_of(LanePair within) const {
    const LanePair rise = climb_ * within;
    return height_ + (rise[0] + rise[1]);
  }

  /// The part of a side over the reference face: base + t * direction for t from -1 to 1, clipped to the two strips |x|
  /// <= 1 and |y| <= 1, and the lines of these that clip it.
  struct Part {
    double low;
    double high;
    std::size_t low_line;  ///< None if it extends to its end.
    std::size_t high_line;
    bool is_left;
  };

  /// Two opposite sides have a common direction, and common parameters at the strips.
  struct Direction {
    LanePair inverse;
    std::size_t near[2];
    std::size_t far[2];

    [[gnu::always_inline]] explicit Direction(LanePair along) : inverse(1.0 / along) {
      near[0] = along[0] > 0 ? 7 : 5;
      near[1] = along[1] > 0 ? 4 : 6;
      far[0] = 7 + 5 - near[0];
      far[1] = 4 + 6 - near[1];
    }
  };

  /// A strip only clips corners that are outside of it.
  [[gnu::always_inline]] static Part part_of(const Direction& along, LanePair base, LanePairBits low_is_out,
                                             LanePairBits high_is_out) {
    const LanePair at_minus = (-1.0 - base) * along.inverse;
    const LanePair at_plus = (1.0 - base) * along.inverse;
    const LanePair near = one_of(LanePair{-1, -1}, at_minus < at_plus ? at_minus : at_plus, low_is_out);
    const LanePair far = one_of(LanePair{1, 1}, at_minus < at_plus ? at_plus : at_minus, high_is_out);
    const double low = std::max(std::max(near[0], near[1]), -1.0);
    const double high = std::min(std::min(far[0], far[1]), 1.0);
    return {low, high, low > -1 ? along.near[near[1] > near[0] ? 1 : 0] : nowhere,
            high < 1 ? along.far[far[1] < far[0] ? 1 : 0] : nowhere, low < high};
  }

  [[gnu::always_inline]] void cut_sides() {
    const auto is_out = [this](LanePair corner) { return bit_cast<LanePairBits>(magnitude(corner) > limit_); };
    const LanePair low = middle_ - up_side_;
    const LanePair high = middle_ + up_side_;
    const LanePair left = middle_ - right_;
    const LanePair right = middle_ + right_;
    const LanePairBits out[4] = {is_out(left - up_side_), is_out(right - up_side_), is_out(right + up_side_),
                                 is_out(left + up_side_)};
    const Direction across(right_);
    const Direction along(up_side_);
    const Part bottom = part_of(across, low, out[0], out[1]);
    const Part end = part_of(along, right, out[1], out[2]);
    const Part top = part_of(across, high, out[3], out[2]);
    const Part begin = part_of(along, left, out[0], out[3]);
    put<0>({LanePair{bottom.low, -1}, LanePair{bottom.high, -1}, bottom.low_line}, bottom.high_line, bottom.is_left);
    put<1>({LanePair{1, end.low}, LanePair{1, end.high}, end.low_line}, end.high_line, end.is_left);
    put<2>({LanePair{top.high, 1}, LanePair{top.low, 1}, top.high_line}, top.low_line, top.is_left);
    put<3>({LanePair{-1, begin.high}, LanePair{-1, begin.low}, begin.high_line}, begin.low_line, begin.is_left);
  }

  /// A side of the incident face; where it is clipped, a side of the reference face ends and another one starts.
  /// Branch-free: missing sides are stored in an unused entry.
  template <std::size_t line>
  [[gnu::always_inline]] void put(Side side, std::size_t cut_at_end, bool is_left) {
    const std::size_t from = is_left ? side.before : nowhere;
    const std::size_t to = is_left ? cut_at_end : nowhere;
    left_ |= (is_left ? 1U : 0U) << line;
    whole_starts_ |= (is_left && from == nowhere ? 1U : 0U) << line;
    whole_ends_ |= (is_left && to == nowhere ? 1U : 0U) << line;
    end(from, side.start);
    start(to, side.end, line);
    if (from == nowhere) side.before = (line + 3) % 4;
    sides_[line] = side;
  }

  [[gnu::always_inline]] void start(std::size_t line, LanePair at, std::size_t before) {
    sides_[line].start = at;
    sides_[line].before = before;
    twice_ |= started_ & 1U << line;
    started_ |= 1U << line;
  }

  [[gnu::always_inline]] void end(std::size_t line, LanePair at) {
    sides_[line].end = at;
    ended_ |= 1U << line;
  }

  /// Those that lie in the incident face, farther from its sides than the slack: two sides of the reference face meet
  /// there.
  [[gnu::always_inline]] void find_corners_of_reference() {
    const LanePair low = -1.0 - middle_;
    const LanePair high = 1.0 - middle_;
    const auto put_corner = [this](std::size_t corner, double x, double y) {
      const LanePair at = LanePair{x * up_side_[1] - y * up_side_[0], y * right_[0] - x * right_[1]} * inverse_area_;
      const auto is_in = bit_cast<LanePairBits>(magnitude(at) < limit_within_);
      const bool is_corner = (is_in[0] & is_in[1]) != 0;
      start(is_corner ? reference_lines + corner : nowhere, at, reference_lines + (corner + 3) % 4);
      end(is_corner ? reference_lines + (corner + 3) % 4 : nowhere, at);
    };
    put_corner(0, low[0], low[1]);
    put_corner(1, high[0], low[1]);
    put_corner(2, high[0], high[1]);
    put_corner(3, low[0], high[1]);
  }

  /// Whether every side ends where another one starts. Adds the sides of the reference face to the others.
  [[gnu::always_inline]] bool is_closed() {
    constexpr unsigned reference = 0xf0;
    const unsigned after_ends = (whole_ends_ << 1U | whole_ends_ >> 3U) & 0xfU;
    left_ |= started_ & reference;
    return ((started_ ^ ended_) & reference) == 0 && (twice_ & reference) == 0 && after_ends == whole_starts_;
  }

  /// If nothing is higher above the reference face than this, the whole face rests on it.
  double resting_height() const {
    const double halves =
        std::min(incident_.half_right + incident_.half_up, reference_.half_right + reference_.half_up);
    return 2 * flush_ * halves;
  }

  /// Removes what is above the reference face by more than the slack, unless the whole face rests on it. False if the
  /// removed part is not contiguous.
  bool cut_top() {
    std::array<double, top_line> at_start;
    std::array<double, top_line> at_end;
    unsigned start_is_out = 0;
    unsigned end_is_out = 0;
    unsigned is_high = 0;
    const double resting = resting_height();
#pragma GCC unroll 8
    for (std::size_t line = 0; line < top_line; ++line) {
      at_start[line] = height_of(sides_[line].start);
      at_end[line] = height_of(sides_[line].end);
      start_is_out |= (at_start[line] > slack_ ? 1U : 0U) << line;
      end_is_out |= (at_end[line] > slack_ ? 1U : 0U) << line;
      is_high |= (at_start[line] > resting ? 1U : 0U) << line;
    }
    start_is_out &= left_;
    end_is_out &= left_;
    if (start_is_out == 0 || (is_high & left_) == 0) return true;
    const unsigned exits = end_is_out & ~start_is_out;
    const unsigned entries = start_is_out & ~end_is_out;
    left_ &= ~(start_is_out & end_is_out);
    if (exits == 0 || entries == 0 || (exits & (exits - 1)) != 0 || (entries & (entries - 1)) != 0) return left_ == 0;
    const auto crossing = [&](std::size_t line) {
      const double share = at_start[line] / (at_start[line] - at_end[line]);  // they differ
      const double between = std::min(std::max(share, 0.0), 1.0);
      return sides_[line].start + (sides_[line].end - sides_[line].start) * between;
    };
    const auto exit = static_cast<std::size_t>(std::countr_zero(exits));
    const auto entry = static_cast<std::size_t>(std::countr_zero(entries));
    sides_[top_line].start = crossing(exit);
    sides_[top_line].before = exit;
    sides_[entry].start = crossing(entry);
    sides_[entry].before = top_line;
    left_ |= 1U << top_line;
    return true;
  }

  BoxFace incident_;
  BoxFace reference_;
  PairedVec up_;
  PairedVec normal_;
  double slack_;
  double flush_;
  double height_ = 0;  ///< The height of the middle above the reference face.
  LanePair climb_{};   ///< The slope of the incident face's right and up.
  LanePair middle_{};  ///< The middle of the incident face, over the reference face.
  LanePair right_{};   ///< Its right and up there.
  LanePair up_side_{};
  LanePair limit_{};         ///< For a corner over the reference face that is not clipped.
  LanePair limit_within_{};  ///< For a corner of the reference face in the incident one.
  double inverse_area_ = 0;  ///< Of right and up there.
  std::uint32_t turns_ = 0;  ///< As in places_on_faces.
  std::array<Side, face_lines + 1> sides_{};
  unsigned left_ = 0;
  unsigned whole_starts_ = 0;  ///< Sides of the incident face whose start, or end, is its own corner.
  unsigned whole_ends_ = 0;
  unsigned started_ = 0;
  unsigned ended_ = 0;
  unsigned twice_ = 0;  ///< Those that start twice.
};

}  // namespace graze::detail
#endif
