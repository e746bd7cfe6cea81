// SPDX-License-Identifier: MIT
// hull_of(frame): the convex hull of 3D points as triangles, decided exactly.
//
// If many points are on an edge or a face of the hull up to rounding, doubles cannot decide which of them are corners,
// and an exact test of each takes far longer than everything else. But nearly all of them are inside the hull of their
// neighbours on the same edge or face. HullShear maps such a group to a cloud that is as thick as long, and quickhull
// in double finds its outer points. For each of these, HullVisibility finds the one face of the hull of all others that
// the ray from the center to the point crosses; this face alone decides whether the point is outside.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/hull/core.hpp>
#include <graze/shape/hull/flat_parts.hpp>
#include <graze/shape/hull/flat_points.hpp>
#include <graze/shape/hull/frame.hpp>
#include <graze/shape/hull/lexicographic.hpp>
#include <graze/shape/hull/quickhull.hpp>
#include <graze/shape/hull/visibility.hpp>

namespace graze::detail {

/// The indices of the points that are corners of a hull's faces.
template <class T>
std::vector<std::uint32_t> corners_of_faces(const Quickhull<T>& hull) {
  std::vector<bool> is_corner(hull.corners().size(), false);
  for (const auto& face : hull.faces()) {
    if (!face.is_alive) continue;
    for (const std::uint32_t corner : face.corners) is_corner[corner] = true;
  }
  std::vector<std::uint32_t> result;
  for (std::size_t i = 0; i < is_corner.size(); ++i) {
    if (is_corner[i]) result.push_back(hull.corners()[i].index);
  }
  return result;
}

/// Points outside a hull that may be corners of the complete hull, including all that are. For each: the face of the
/// hull that it faces, or several candidates for that face, stored consecutively. No faces if unknown.
struct UndecidedPoints {
  struct UndecidedPoint {
    std::uint32_t point;
    std::uint32_t face_count;
    std::size_t first_face;
  };

  std::vector<UndecidedPoint> undecided;
  std::vector<std::uint32_t> faces;

  std::span<const std::uint32_t> faces_of(const UndecidedPoint& doubt) const {
    return std::span(faces).subspan(doubt.first_face, doubt.face_count);
  }

  void add(std::uint32_t point, std::span<const std::uint32_t> before) {
    undecided.push_back({point, static_cast<std::uint32_t>(before.size()), faces.size()});
    for (const std::uint32_t face : before) faces.push_back(face);
  }
};

/// Sorts points into those that are clearly outside of a hull and those that may be, some of which are undecided about
/// other faces.
template <class T>
class UndecidedPointSearch {
 public:
  using Facing = typename Quickhull<T>::Facing;

  /// Reserves memory for `count` points.
  UndecidedPointSearch(const Quickhull<T>& hull, HullVisibility<T>& verdict, std::size_t count)
      : hull_(&hull), verdict_(&verdict) {
    found_.undecided.reserve(count);
    found_.faces.reserve(count);
  }

  void ask(const Facing& aside) {
    HullPoint point = hull_->frame().at(aside.point);
    point.link = aside.face;
    const std::span<const std::uint32_t> faces = verdict_->faces_before(point);
    bool is_in_doubt = faces.empty() && !verdict_->is_at_corner();
    for (const std::uint32_t place : faces) {
      const HullPlane& plane = hull_->faces()[place].plane;
      const double height = plane.height(point.place);
      if (height > plane.doubt) {
        outside_.push_back({place, point.index});
        return;
      }
      is_in_doubt = is_in_doubt || height > -plane.doubt;
    }
    if (is_in_doubt) found_.add(point.index, faces);
  }

  const std::vector<Facing>& outside() const { return outside_; }
  UndecidedPoints& undecided() { return found_; }

 private:
  const Quickhull<T>* hull_;
  HullVisibility<T>* verdict_;
  UndecidedPoints found_;
  std::vector<Facing> outside_;
};

/// Adds the points set aside that are clearly outside of a hull, and returns the others that may be.
template <class T>
UndecidedPoints settle_clear(Quickhull<T>& hull) {
  constexpr int most_rounds = 8;
  std::vector<typename Quickhull<T>::Facing> points = hull.take_aside();
  for (int round = 0; round < most_rounds && !points.empty(); ++round) {
    HullVisibility<T> verdict(hull);
    if (!verdict.is_clear()) break;
    UndecidedPointSearch<T> doubter(hull, verdict, points.size());
    for (const auto& point : points) doubter.ask(point);
    if (doubter.outside().empty()) return std::move(doubter.undecided());
    hull.add_outside(doubter.outside());
    points = hull.take_aside();
    for (const auto& doubt : doubter.undecided().undecided) points.push_back({HullPoint::none, doubt.point});
  }
  UndecidedPoints result;
  for (const auto& point : points) result.add(point.point, {});
  return result;
}

/// Groups undecided points: those facing the same flat part of a hull's surface, those facing an edge between two
/// parts, and those whose face is unknown.
template <class T>
class UndecidedGroups {
 public:
  UndecidedGroups(const Quickhull<T>& hull, const UndecidedPoints& undecided)
      : parts_(hull), first_(hull.faces().size() + 1, none) {
    for (std::uint32_t i = 0; i < undecided.undecided.size(); ++i) {
      group_before(undecided.faces_of(undecided.undecided[i])).push_back(i);
    }
  }

  std::vector<std::vector<std::uint32_t>>& groups() { return groups_; }

 private:
  static constexpr std::uint32_t none = HullPoint::none;

  /// The second part of a group, or none, and the next group with the same first part.
  struct Link {
    std::uint32_t other;
    std::uint32_t next;
  };

  std::vector<std::uint32_t>& group_before(std::span<const std::uint32_t> faces) {
    auto least = static_cast<std::uint32_t>(first_.size() - 1);
    std::uint32_t other = none;
    for (const std::uint32_t face : faces) {
      const std::uint32_t part = parts_.of(face);
      if (part == least) continue;
      if (least + 1 < first_.size()) other = std::min(other, std::max(part, least));
      least = std::min(part, least);
    }
    std::uint32_t group = first_[least];
    while (group != none && links_[group].other != other) group = links_[group].next;
    if (group == none) {
      group = static_cast<std::uint32_t>(groups_.size());
      groups_.emplace_back();
      links_.push_back({other, std::exchange(first_[least], group)});
    }
    return groups_[group];
  }

  FlatParts<T> parts_;
  std::vector<std::uint32_t> first_;  // first group of each part
  std::vector<Link> links_;
  std::vector<std::vector<std::uint32_t>> groups_;
};

/// Memory for the hulls of groups.
template <class T>
struct GroupMemory {
  std::vector<Vec<3, T>> points;
  std::vector<HullPoint> candidates;
  Quickhull<T> hull;
};

/// The points set aside, without duplicates.
template <class T>
std::vector<std::uint32_t> distinct_aside(const Quickhull<T>& hull) {
  std::vector<std::uint32_t> points;
  for (const auto& aside : hull.aside()) points.push_back(aside.point);
  const auto at = [&hull](std::uint32_t i) -> const Vec<3, T>& { return hull.frame().point(i); };
  std::sort(points.begin(), points.end(), [&at](auto a, auto b) { return lexicographically_less<3, T>(at(a), at(b)); });
  points.erase(std::unique(points.begin(), points.end(), [&at](auto a, auto b) { return at(a) == at(b); }),
               points.end());
  return points;
}

/// Removes points from a group that are not corners of the group's hull.
template <class T>
void keep_outer(const HullFrame<T>& frame, const UndecidedPoints& undecided, std::vector<std::uint32_t>& group,
                GroupMemory<T>& memory) {
  constexpr std::size_t few = 32;
  if (group.size() < few) return;
  memory.points.clear();
  for (const std::uint32_t doubt : group) memory.points.push_back(frame.point(undecided.undecided[doubt].point));
  const HullFrame<T> sheared = HullFrame<T>::sheared(memory.points);
  put_candidates(sheared, memory.candidates);
  Quickhull<T>& hull = memory.hull;
  hull.start(sheared, memory.candidates);
  std::vector<std::uint32_t> outer = hull.base().size() < 4 ? flat_vertices(hull) : corners_of_faces(hull);
  for (const std::uint32_t point : distinct_aside(hull)) outer.push_back(point);
  for (std::uint32_t& place : outer) place = group[place];
  group.swap(outer);
}

/// Removes undecided points that are not corners of their group's hull.
template <class T>
void keep_outer(const Quickhull<T>& hull, UndecidedPoints& undecided, GroupMemory<T>& memory) {
  constexpr std::size_t few = 64;
  if (undecided.undecided.size() < few) return;
  UndecidedGroups<T> groups(hull, undecided);
  std::vector<UndecidedPoints::UndecidedPoint> outer;
  for (std::vector<std::uint32_t>& group : groups.groups()) {
    keep_outer(hull.frame(), undecided, group, memory);
    for (const std::uint32_t doubt : group) outer.push_back(undecided.undecided[doubt]);
  }
  undecided.undecided.swap(outer);
}

/// Adds the undecided points to their hull, which is then complete, exactly.
template <class T>
void settle(Quickhull<T>& hull, const UndecidedPoints& undecided) {
  std::vector<typename Quickhull<T>::Facing> outside;
  std::vector<std::uint32_t> others;
  for (const auto& doubt : undecided.undecided) {
    const auto faces = undecided.faces_of(doubt);
    if (faces.empty()) others.push_back(doubt.point);
    const HullPoint point = hull.frame().at(doubt.point);
    const auto seen = std::find_if(faces.begin(), faces.end(), [&](auto face) { return hull.is_outside(face, point); });
    if (seen != faces.end()) outside.push_back({*seen, doubt.point});
  }
  hull.settle_undecided();
  hull.add_outside(std::move(outside));
  if (!others.empty()) hull.add(others);
}

/// Memory for a hull and for those of its groups.
template <class T>
struct HullMemory {
  Quickhull<T> hull;
  GroupMemory<T> groups;
};

/// Starts the hull of the candidates and returns the points that may be outside of it. `candidates` is swapped with a
/// list that has memory.
template <class T>
UndecidedPoints start_hull(const HullFrame<T>& frame, std::vector<HullPoint>& candidates, HullMemory<T>& memory) {
  memory.hull.start(frame, candidates);
  UndecidedPoints undecided = settle_clear(memory.hull);
  keep_outer(memory.hull, undecided, memory.groups);
  return undecided;
}

/// Appends those candidates to `result` that may be corners of the complete hull. `candidates` then holds only memory.
template <class T>
void add_sifted(const HullFrame<T>& frame, std::vector<HullPoint>& candidates, HullMemory<T>& memory,
                std::vector<HullPoint>& result) {
  const UndecidedPoints undecided = start_hull(frame, candidates, memory);
  const Quickhull<T>& hull = memory.hull;
  result.insert(result.end(), hull.flat_candidates().begin(), hull.flat_candidates().end());
  for (const std::uint32_t point : corners_of_faces(hull)) result.push_back(frame.at(point));
  for (const auto& doubt : undecided.undecided) result.push_back(frame.at(doubt.point));
}

/// Whether sifting pays: the core leaves most points of a sample, and most of these are not near the surface of their
/// hull.
template <class T>
bool pays_to_sift(const HullFrame<T>& frame, const HullCore& core, HullMemory<T>& memory) {
  constexpr std::size_t enough = 4096;
  std::vector<HullPoint> sample = sample_of(frame, enough);
  sample.erase(std::remove_if(sample.begin(), sample.end(), [&](const HullPoint& p) { return core.holds(p.place); }),
               sample.end());
  if (sample.size() < enough / 2) return false;
  std::vector<HullPoint> sifted;
  add_sifted(frame, sample, memory, sifted);
  return sifted.size() < enough / 2;
}

/// The points of a frame that may be corners. If most are on a few lines and planes, they are sifted in pieces that fit
/// the cache.
template <class T>
std::vector<HullPoint> sifted_candidates(const HullFrame<T>& frame, HullMemory<T>& memory) {
  constexpr std::uint32_t piece = 1U << 15U;
  const HullCore core = core_of(frame);
  std::vector<HullPoint> result;
  if (frame.size() < 2 * piece || !pays_to_sift(frame, core, memory)) {
    put_points_beside(core, frame, 0, frame.size(), result);
    return result;
  }
  std::vector<HullPoint> candidates;
  for (std::uint32_t first = 0; first < frame.size();) {
    const std::uint32_t last = first + std::min(piece, frame.size() - first);
    put_points_beside(core, frame, first, last, candidates);
    add_sifted(frame, candidates, memory, result);
    first = last;
  }
  return result;
}

/// The hull of the points of a frame, which must outlive it. For many points: sifts the undecided ones first.
template <class T>
Quickhull<T> sifted_hull(const HullFrame<T>& frame) {
  HullMemory<T> memory;
  std::vector<HullPoint> candidates = sifted_candidates(frame, memory);
  settle(memory.hull, start_hull(frame, candidates, memory));
  return std::move(memory.hull);
}

/// The hull of the points of a frame, which must outlive it. For few points, deciding all exactly is faster than
/// sifting.
template <class T>
Quickhull<T> hull_of(const HullFrame<T>& frame) {
  constexpr std::uint32_t few = 4000;
  if (frame.size() >= few) return sifted_hull(frame);
  std::vector<HullPoint> candidates = all_points(frame);
  Quickhull<T> hull;
  hull.start(frame, candidates, true);
  return hull;
}

}  // namespace graze::detail
