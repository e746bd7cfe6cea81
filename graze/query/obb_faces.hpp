// SPDX-License-Identifier: MIT
// One face of a box laid over one of another: what clipped_patch.hpp does for any two, for two rectangles in the
// coordinates of one of them, where sides are |x| <= 1 and |y| <= 1.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <graze/math/vec.hpp>
#include <graze/query/clipped_patch.hpp>
#include <graze/query/core_features.hpp>
#include <graze/query/lanes.hpp>
#include <graze/query/manifold_points.hpp>
#include <graze/query/patch.hpp>
#include <graze/shape/obb.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// An oriented box, two coordinates at a time: read as they were written, or the processor waits for what was.
struct PairedBox {
  PairedVec center;
  PairedVec axes[3];
  PairedVec half_edges[3];
  double half[3];  ///< Their lengths but for those of the axes, which are about 1.
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
};

[[gnu::always_inline]] inline BoxFace face_of_box(const PairedBox& box, const BoxFaceNumbers& numbers) {
  return {numbers, box.center + box.half_edges[numbers.axis] * (numbers.is_far ? 1.0 : -1.0),
          box.half_edges[numbers.next()], box.half_edges[numbers.last()]};
}

/// A contact point on the surfaces of two boxes, as SurfacePair.
struct PairedPoints {
  PairedVec point_a;
  PairedVec point_b;
  double depth;
  Feature feature_a;
  Feature feature_b;
};

// ---- What a corner of a face over a face lies on, by the lines that meet there: 0 to 3 are the sides of the reference
// face, 4 to 7 those of the incident one, 8 is the reference plane itself. From tables, since what differs from corner
// to corner is guessed wrong.

struct LinesOfFaces {
  static constexpr std::uint32_t incident_side = 4;
  static constexpr std::uint32_t top = 8;
  static constexpr std::uint32_t nothing = 9;
};

/// The features of each side of a box in space, by BoxFaceNumbers::face(): itself, its edges, its vertices.
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

/// The line on which the corner was, and the one that cut it off.
constexpr std::uint32_t place_on_reference(std::uint32_t from, std::uint32_t cut_by) {
  if (cut_by == LinesOfFaces::nothing) return face_place;
  if (from >= LinesOfFaces::incident_side) return cut_by == LinesOfFaces::top ? face_place : edge_place + cut_by;
  if (cut_by == LinesOfFaces::top) return edge_place + from;
  const bool is_before = ((from + 1) & 3U) == cut_by;
  return vertex_place + (is_before ? cut_by : (cut_by + 1) & 3U);
}

constexpr std::uint32_t place_on_incident(std::uint32_t from, std::uint32_t cut_by) {
  if (from < LinesOfFaces::incident_side) return face_place;
  return (cut_by == LinesOfFaces::nothing ? vertex_place : edge_place) + (from & 3U);
}

using PlacesByLines = std::array<std::array<std::uint8_t, 10>, 10>;

template <class Place>
constexpr PlacesByLines places_by_lines(const Place& place) {
  PlacesByLines places{};
  for (std::uint32_t from = 0; from < 8; ++from) {
    for (std::uint32_t cut_by = 0; cut_by < 10; ++cut_by) {
      places[from][cut_by] = static_cast<std::uint8_t>(place(from, cut_by));
    }
  }
  return places;
}
inline constexpr PlacesByLines places_on_reference = places_by_lines(place_on_reference);
inline constexpr PlacesByLines places_on_incident = places_by_lines(place_on_incident);

/// The incident face over the reference face, cut side by side: Sutherland and Hodgman, as in ClippedPatch, with the
/// same corners in the same order. Polygons are convex, so that there is one way out over a side and one back; a corner
/// keeps by numbers what it was made of.
class FaceOverFace : private LinesOfFaces {
 public:
  static constexpr std::size_t most_corners = 9;

  /// Seen along the contact's normal `up`, of length 1, which `normal`, the reference face's own, is equal to but for
  /// 1e-5 at most. What is above by up to `slack` stays.
  [[gnu::always_inline]] FaceOverFace(const BoxFace& incident, const BoxFace& reference, const PairedVec& up,
                                      const PairedVec& normal, double slack)
      : incident_(incident), reference_(reference), up_(up), normal_(normal), slack_(slack) {}

  /// False where rounding hides the way around, or the reference face is hardly one.
  bool run() {
    if (!place_incident()) return false;
    const LanePair slack = slack_in_halves_;
    const LanePair lowest = middle_ - reach_ + (slack + 1.0);
    const LanePair highest = middle_ + reach_ - (slack + 1.0);
    if (lowest[1] < 0 && !cut<4>(0, slack[1], [](const Corner& corner) { return -1 - corner.over[1]; })) return false;
    if (highest[0] > 0 && !cut<5>(1, slack[0], [](const Corner& corner) { return corner.over[0] - 1; })) return false;
    if (highest[1] > 0 && !cut<6>(2, slack[1], [](const Corner& corner) { return corner.over[1] - 1; })) return false;
    if (lowest[0] < 0 && !cut<7>(3, slack[0], [](const Corner& corner) { return -1 - corner.over[0]; })) return false;
    const LanePair climb = magnitude(climb_);
    if (!(height_ + (climb[0] + climb[1]) > slack_)) return true;
    return cut<8>(top, slack_, [&](const Corner& corner) { return height_of(corner); });
  }

  /// How many corners lie over the reference face and not above it.
  std::size_t size() const { return size_; }
  double depth(std::size_t i) const { return std::max(0.0, -height_of(corners_[at(i)])); }
  /// The first of several.
  std::size_t deepest() const {
    std::size_t deepest = 0;
    for (std::size_t i = 1; i < size_; ++i) {
      if (depth(i) > depth(deepest)) deepest = i;
    }
    return deepest;
  }
  /// Where a corner is in the incident face, in halves of its edges.
  LanePair within(std::size_t i) const { return corners_[at(i)].within; }
  const BoxFace& incident() const { return incident_; }
  /// How much higher the ends of the incident face's right and up are than its middle.
  LanePair climb() const { return climb_; }
  /// With the reference face's box as the first.
  [[gnu::always_inline]] PairedPoints pair(std::size_t i) const {
    const Corner& corner = corners_[at(i)];
    const double height = height_of(corner);
    const PairedVec point = incident_.middle + incident_.right * corner.within[0] + incident_.up * corner.within[1];
    return {point - up_ * height, point, std::max(0.0, -height),
            features_of_faces[reference_.numbers.face()][places_on_reference[corner.from()][corner.cut_by()]],
            features_of_faces[incident_.numbers.face()][places_on_incident[corner.from()][corner.cut_by()]]};
  }

 private:
  /// Where it is over the reference face, and in the incident one, in halves of their edges; the line from which it
  /// came, the one that cut it off, and the one to the next corner. A corner of the incident face itself comes from
  /// nowhere: `from` is the line that starts there, and so is `next`.
  struct Corner {
    LanePair over;
    LanePair within;
    std::uint32_t lines;  ///< Together, so that copies need not wait for three stores.

    std::uint32_t from() const { return lines & 0xffU; }
    std::uint32_t cut_by() const { return lines >> 8U & 0xffU; }
    std::uint32_t next() const { return lines >> 16U; }
  };

  static constexpr std::uint32_t lines_of(std::uint32_t from, std::uint32_t cut_by, std::uint32_t next) {
    return from | cut_by << 8U | next << 16U;
  }

  /// A point's coordinates across Y, X and the plane: x = n . (p x Y) / n . (X x Y), y = n . (X x p) / n . (X x Y).
  bool place_incident() {
    const PairedVec across_up = cross(reference_.up, up_);
    const PairedVec across_right = cross(up_, reference_.right);
    const double area = dot(across_up, reference_.right);
    const double right = std::sqrt(dot(reference_.right, reference_.right));
    const double up = std::sqrt(dot(reference_.up, reference_.up));
    if (!(std::min(right, up) > 1e3 * slack_)) return false;
    slack_in_halves_ = LanePair{slack_ / right, slack_ / up};
    const auto seen = [&, inverse = 1 / area](const PairedVec& v) {
      return LanePair{dot(across_up, v) * inverse, dot(across_right, v) * inverse};
    };
    const PairedVec way = incident_.middle - reference_.middle;
    const LanePair middle = seen(way);
    const LanePair x = seen(incident_.right);
    const LanePair y = seen(incident_.up);
    const PairedVec rise = normal_ / dot(normal_, up_);  // about 1
    height_ = dot(rise, way);
    climb_ = LanePair{dot(rise, incident_.right), dot(rise, incident_.up)};
    middle_ = middle;
    reach_ = magnitude(x) + magnitude(y);
    corners_[0] = {middle - x - y, LanePair{-1, -1}, lines_of(4, nothing, 4)};
    corners_[1] = {middle + x - y, LanePair{1, -1}, lines_of(5, nothing, 5)};
    corners_[2] = {middle + x + y, LanePair{1, 1}, lines_of(6, nothing, 6)};
    corners_[3] = {middle - x + y, LanePair{-1, 1}, lines_of(7, nothing, 7)};
    count_ = size_ = 4;
    order_ = 0x3210;
    return true;
  }

  [[gnu::always_inline]] double height_of(const Corner& corner) const {
    const LanePair rise = climb_ * corner.within;
    return height_ + (rise[0] + rise[1]);
  }

  /// The place of the polygon's corner i in corners_.
  std::size_t at(std::size_t i) const { return static_cast<std::size_t>(order_ >> 4 * i & 0xfU); }

  /// Leaves the corners that are not above the line by more than the slack. False if they are not all in a row. There
  /// are `most` corners at most; that many are looked at, since loops of ever different lengths are guessed wrong.
  template <std::size_t most, class Height>
  [[gnu::always_inline]] bool cut(std::uint32_t line, double slack, const Height& height) {
    std::array<double, most> heights;
    unsigned outside = 0;
#pragma GCC unroll 8
    for (std::size_t i = 0; i < most; ++i) {
      heights[i] = height(corners_[at(i)]);
      outside |= (heights[i] > slack ? 1U : 0U) << i;
    }
    const unsigned all = (1U << size_) - 1;
    outside &= all;
    if (outside == 0) return true;
    const unsigned inside = all & ~outside;
    const unsigned next_inside = inside >> 1U | (inside & 1U) << (size_ - 1);
    const unsigned exits = inside & ~next_inside;
    if (inside == 0 || (exits & (exits - 1)) != 0) {
      size_ = 0;
      return inside == 0;
    }
    const auto exit = static_cast<std::size_t>(std::countr_zero(exits));
    const auto entry = static_cast<std::size_t>(std::countr_zero(outside & next_inside));
    const auto crossing = [&](std::size_t from) {
      const std::size_t to = from + 1 < size_ ? from + 1 : 0;
      const Corner& start = corners_[at(from)];
      const Corner& end = corners_[at(to)];
      const double share = heights[from] / (heights[from] - heights[to]);  // they differ
      const double between = std::min(std::max(share, 0.0), 1.0);
      return Corner{start.over + (end.over - start.over) * between,
                    start.within + (end.within - start.within) * between, lines_of(start.next(), line, start.next())};
    };
    const Corner on_entry = crossing(entry);
    Corner on_exit = crossing(exit);
    on_exit.lines = lines_of(on_exit.from(), line, line);
    corners_[count_] = on_exit;
    corners_[count_ + 1] = on_entry;
    splice(exit, entry, (inside & 1U) != 0);
    count_ += 2;
    return true;
  }

  /// Puts in the last two corners for those after the exit, up to the entry. The first corner that is left is the
  /// first.
  [[gnu::always_inline]] void splice(std::size_t exit, std::size_t entry, bool first_stays) {
    const auto lowest = [](std::uint64_t order, std::size_t corners) {
      return order & ((std::uint64_t{1} << 4 * corners) - 1);
    };
    const std::uint64_t on_exit = count_;
    const std::uint64_t on_entry = count_ + 1;
    const std::uint64_t after_entry = order_ >> 4 * (entry + 1);
    const std::uint64_t from_first = lowest(order_, exit + 1) | (on_exit | on_entry << 4U | after_entry << 8U)
                                                                    << 4 * (exit + 1);
    const std::size_t run = exit - entry;  // of no meaning if the first stays
    const std::uint64_t from_entry = on_entry | lowest(after_entry, run & 7U) << 4U | on_exit << 4 * ((run & 7U) + 1);
    order_ = first_stays ? from_first : from_entry;
    size_ = first_stays ? size_ + run + 2 : run + 2;
  }

  BoxFace incident_;
  BoxFace reference_;
  PairedVec up_;
  PairedVec normal_;
  double slack_;
  LanePair slack_in_halves_{};
  double height_ = 0;                      ///< Of the middle over the reference face.
  LanePair climb_{};                       ///< Of the incident face's right and up.
  LanePair middle_{};                      ///< Of the incident face, over the reference face.
  LanePair reach_{};                       ///< How far from there its corners are at most.
  std::array<Corner, 4 + 2 * 5> corners_;  ///< All that there have been.
  std::size_t count_ = 0;
  std::uint64_t order_ = 0;  ///< Those that are left, by their places, four bits each.
  std::size_t size_ = 0;
};

}  // namespace graze::detail
#endif
