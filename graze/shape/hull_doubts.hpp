// SPDX-License-Identifier: MIT
// hull_of(frame): the convex hull of points in space as triangles, decided exactly.
//
// Where many points are on an edge or a face of the hull up to the rounding of their coordinates, doubles cannot tell
// which of them stick out, and to ask that of each exactly takes far longer than all else. But nearly all are inside of
// the hull of those beside them on the same edge or face: under a map that makes this hull as thick as long
// (HullShear), they are a cloud as any other, of which quickhull in doubles finds the outer ones.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/hull_core.hpp>
#include <graze/shape/hull_flat.hpp>
#include <graze/shape/hull_frame.hpp>
#include <graze/shape/quickhull.hpp>

namespace graze::detail {

/// The longest side of a hull's triangle whose line a point is all but on, as a half-edge; or none.
template <class T>
std::uint32_t side_near(const Quickhull<T>& hull, std::uint32_t face, const Vec<3, double>& place) {
  std::uint32_t nearest = HullPoint::none;
  double longest = 0;
  for (std::uint32_t edge = 4 * face; edge < 4 * face + 3; ++edge) {
    const Vec<3, double>& start = hull.corners()[hull.origin(edge)].place;
    const Vec<3, double> way = hull.corners()[hull.origin(Quickhull<T>::next(edge))].place - start;
    const double size = dot(way, way);
    const Vec<3, double> across = cross(way, place - start);
    if (!(dot(across, across) < tolerance::hull_needle * tolerance::hull_needle * size) || size <= longest) continue;
    longest = size;
    nearest = edge;
  }
  return nearest;
}

/// The side of a hull's triangle that a point near its plane is farthest beyond, as a half-edge; or none.
template <class T>
std::uint32_t side_beyond(const Quickhull<T>& hull, std::uint32_t face, const Vec<3, double>& place) {
  std::uint32_t side = HullPoint::none;
  double farthest = 0;
  for (std::uint32_t edge = 4 * face; edge < 4 * face + 3; ++edge) {
    const Vec<3, double>& start = hull.corners()[hull.origin(edge)].place;
    const Vec<3, double> way = hull.corners()[hull.origin(Quickhull<T>::next(edge))].place - start;
    const double inward = dot(hull.faces()[face].plane.normal, cross(way, place - start));
    if (!(inward < farthest)) continue;
    farthest = inward;
    side = edge;
  }
  return side;
}

/// The part of a hull's surface that a point in doubt about a face is near: an edge, as the lesser one of its two
/// half-edges, or the inside of a face, as 4 * face + 3. Flat parts come in several faces, so others are tried on the
/// way to it. It is only for what is seen together: any answer would do.
template <class T>
std::uint32_t part_near(const Quickhull<T>& hull, std::uint32_t face, const Vec<3, double>& place) {
  constexpr int most_steps = 16;
  for (int step = 0; step < most_steps; ++step) {
    const std::uint32_t near = side_near(hull, face, place);
    if (near != HullPoint::none) return std::min(near, hull.twin(near));
    const std::uint32_t side = side_beyond(hull, face, place);
    if (side == HullPoint::none) break;
    const std::uint32_t beyond = hull.twin(side) / 4;
    const HullPlane& plane = hull.faces()[beyond].plane;
    if (!(std::fabs(plane.height(place)) <= plane.doubt)) break;
    face = beyond;
  }
  return 4 * face + 3;
}

/// The points in doubt that are near faces, those near the same edge or the same face together.
template <class T>
std::vector<std::vector<std::uint32_t>> groups_in_doubt(const Quickhull<T>& hull) {
  std::vector<std::vector<std::uint32_t>> groups;
  std::vector<std::uint32_t> group_of_part(4 * hull.faces().size(), HullPoint::none);
  for (std::uint32_t face = 0; face < hull.faces().size(); ++face) {
    if (!hull.faces()[face].is_alive) continue;
    hull.for_each_doubted(face, [&](std::uint32_t point) {
      std::uint32_t& group = group_of_part[part_near(hull, face, hull.frame().at(point).place)];
      if (group == HullPoint::none) {
        group = static_cast<std::uint32_t>(groups.size());
        groups.emplace_back();
      }
      groups[group].push_back(point);
    });
  }
  return groups;
}

/// The corners of a hull's faces, as places of points.
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

/// Memory for the hulls of groups.
template <class T>
struct GroupMemory {
  std::vector<Vec<3, T>> points;
  std::vector<HullPoint> candidates;
  Quickhull<T> hull;
};

/// Some of a group's points, none missing that are corners of its hull.
template <class T>
std::vector<std::uint32_t> outer_of(const HullFrame<T>& frame, std::vector<std::uint32_t> group,
                                    GroupMemory<T>& memory) {
  constexpr std::size_t few = 32;
  if (group.size() < few) return group;
  memory.points.clear();
  for (const std::uint32_t point : group) memory.points.push_back(frame.point(point));
  const HullFrame<T> sheared = HullFrame<T>::sheared(memory.points);
  put_candidates(sheared, memory.candidates);
  Quickhull<T>& hull = memory.hull;
  hull.start(sheared, memory.candidates);
  hull.finish();
  std::vector<std::uint32_t> outer = hull.base().size() < 4 ? flat_vertices(hull) : corners_of_faces(hull);
  outer.insert(outer.end(), hull.loose().begin(), hull.loose().end());
  for (std::uint32_t face = 0; face < hull.faces().size(); ++face) {
    if (hull.faces()[face].is_alive) hull.for_each_doubted(face, [&](std::uint32_t point) { outer.push_back(point); });
  }
  for (std::uint32_t& point : outer) point = group[point];
  return outer;
}

/// Some of the points in doubt, none missing that are corners of the hull of all.
template <class T>
std::vector<std::uint32_t> outer_in_doubt(const Quickhull<T>& hull, GroupMemory<T>& memory) {
  if (!hull.has_doubts()) return {};
  std::vector<std::uint32_t> result(hull.loose().begin(), hull.loose().end());
  for (std::vector<std::uint32_t>& group : groups_in_doubt(hull)) {
    const std::vector<std::uint32_t> outer = outer_of(hull.frame(), std::move(group), memory);
    result.insert(result.end(), outer.begin(), outer.end());
  }
  return result;
}

/// Memory for hulls and for those of their groups.
template <class T>
struct HullMemory {
  Quickhull<T> hull;
  GroupMemory<T> groups;
};

/// The hull of candidates, but for those in doubt, which are sifted as often as needed. In exchange for the candidates
/// there is memory for others.
template <class T>
Quickhull<T>& clear_hull(const HullFrame<T>& frame, std::vector<HullPoint>& candidates, HullMemory<T>& memory) {
  Quickhull<T>& hull = memory.hull;
  hull.start(frame, candidates);
  while (!hull.is_finished()) {
    std::vector<bool> is_outer(frame.size(), false);
    for (const std::uint32_t point : outer_in_doubt(hull, memory.groups)) is_outer[point] = true;
    hull.sift(is_outer);
  }
  return hull;
}

/// Adds some of the candidates to others, none missing that are corners of the hull of all. What the candidates are
/// then is memory for more.
template <class T>
void add_sifted(const HullFrame<T>& frame, std::vector<HullPoint>& candidates, HullMemory<T>& memory,
                std::vector<HullPoint>& result) {
  const Quickhull<T>& hull = clear_hull(frame, candidates, memory);
  result.insert(result.end(), hull.flat_candidates().begin(), hull.flat_candidates().end());
  for (const std::uint32_t point : corners_of_faces(hull)) result.push_back(frame.at(point));
  for (const std::uint32_t point : outer_in_doubt(hull, memory.groups)) result.push_back(frame.at(point));
}

/// Whether the core leaves most of a few points, and most of these are not near the surface of their hull.
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

/// The points of a frame that may be corners. Where most are on some lines and planes, from pieces that a processor's
/// cache holds.
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

/// The hull of the points of a frame, which must outlive it.
template <class T>
Quickhull<T> hull_of(const HullFrame<T>& frame) {
  HullMemory<T> memory;
  std::vector<HullPoint> candidates = sifted_candidates(frame, memory);
  Quickhull<T>& hull = clear_hull(frame, candidates, memory);
  if (hull.has_doubts()) hull.add(outer_in_doubt(hull, memory.groups));
  return std::move(hull);
}

}  // namespace graze::detail
