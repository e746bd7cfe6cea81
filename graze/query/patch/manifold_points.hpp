// SPDX-License-Identifier: MIT
// From two faces to the few points of a manifold. Include manifold.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/inplace_vector.hpp>
#include <graze/query/cores/penetration.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/patch/clipped.hpp>
#include <graze/query/patch/patch.hpp>

namespace graze::detail {

/// A contact point on the surfaces of both shapes: point_a - point_b is normal * depth.
template <Dim N>
struct SurfacePair {
  Vec<N, double> point_a;
  Vec<N, double> point_b;
  double depth;
  Feature feature_a;
  Feature feature_b;
};

/// The points of a patch, before a few are selected.
template <Dim N>
using SurfacePairs = InplaceVector<SurfacePair<N>, ClippedPatch<N>::most_corners>;

/// The same of (b, a).
template <Dim N>
SurfacePair<N> exchanged(SurfacePair<N> pair) {
  std::swap(pair.point_a, pair.point_b);
  std::swap(pair.feature_a, pair.feature_b);
  return pair;
}

/// The faces of two cores that face each other along the normal of a penetration, and the radii around them.
template <Dim N>
struct FacingPatches {
  const Patch<N>& a;
  const Patch<N>& b;
  double radius_a = 0;
  double radius_b = 0;
  /// Without radii, everything over a face rests on it if nothing is higher above it than this share of half the
  /// circumference of the smaller face; otherwise what is above by more than rounding is clipped.
  double flush = 0;
  double margin = 0;  ///< Points up to this far apart count, with a negative depth.
};

/// The same of (b, a).
template <Dim N>
FacingPatches<N> exchanged(const FacingPatches<N>& facing) {
  return {facing.b, facing.a, facing.radius_b, facing.radius_a, facing.flush, facing.margin};
}

/// Whether a patch is a face perpendicular to the normal.
template <Dim N>
bool is_face_along(const Patch<N>& patch, const Vec<N, double>& normal) {
  return is_aligned(patch.normal, normal);
}

/// Whether everything over the face of a, which faces along the normal, rests on it.
template <Dim N>
bool rests_on_face(const ClippedPatch<N>& incident, const FacingPatches<N>& facing) {
  if (facing.flush == 0 || facing.radius_a + facing.radius_b > 0) return false;
  double highest = 0;
  for (std::size_t i = 0; i < incident.size(); ++i) {
    highest = std::max(highest, dot(facing.a.normal, incident[i].point - facing.a.corners[0]));
  }
  return highest <= facing.flush * std::min(half_perimeter(facing.a), half_perimeter(facing.b));
}

/// The incident face of b over the face of a, which faces along the normal, and not above the other surface by more
/// than the margin: clipped.
/// Points of b below are projected onto the face of a along the normal.
template <Dim N>
SurfacePairs<N> pairs_over(const FacingPatches<N>& facing, const Vec<N, double>& normal, double slack) {
  const Vec<N, double> on_face = facing.a.corners[0];
  const double reach = facing.radius_a + facing.radius_b;
  ClippedPatch<N> incident = clipped(facing.b, facing.a, normal, slack);
  if (!rests_on_face(incident, facing)) {
    incident.cut(facing.a.normal, on_face + facing.a.normal * (reach + facing.margin), facing.a.size, slack);
  }
  const double climb = dot(facing.a.normal, normal);  // about 1, and 1 for exact faces
  SurfacePairs<N> result;
  for (std::size_t i = 0; i < incident.size(); ++i) {
    const Vec<N, double>& point = incident[i].point;
    const double gap = dot(facing.a.normal, point - on_face) / climb;
    const double depth = std::max(0.0 - facing.margin, reach - gap);
    const Vec<N, double> point_b = point - normal * facing.radius_b;
    result.push_back({point_b + normal * depth, point_b, depth, incident[i].reference, incident[i].incident});
  }
  return result;
}

/// Two parallel edges, whose overlap has two ends; none if they are not parallel.
template <Dim N>
SurfacePairs<N> pairs_between_edges(const FacingPatches<N>& facing, const Vec<N, double>& normal, double slack) {
  SurfacePairs<N> result;
  if (facing.a.size != 2 || facing.b.size != 2) return result;
  const Vec<N, double> along_a = unit_or(facing.a.corners[1] - facing.a.corners[0], Vec<N, double>(0.0));
  const Vec<N, double> along_b = unit_or(facing.b.corners[1] - facing.b.corners[0], Vec<N, double>(0.0));
  if (!is_aligned(along_a, along_b) && !is_aligned(along_a, -along_b)) return result;
  if (std::fabs(dot(along_a, normal)) > tolerance::aligned) return result;
  const ClippedPatch<N> incident = clipped(facing.b, facing.a, normal, slack);
  for (std::size_t i = 0; i < incident.size(); ++i) {
    const Vec<N, double>& point = incident[i].point;
    const double gap = dot(normal, point - facing.a.corners[0]);
    const double depth = facing.radius_a + facing.radius_b - gap;
    if (depth < -(facing.margin + slack)) continue;
    const Vec<N, double> point_b = point - normal * facing.radius_b;
    result.push_back({point_b + normal * depth, point_b, std::max(0.0 - facing.margin, depth), incident[i].reference,
                      incident[i].incident});
  }
  return result;
}

/// The lowest-dimensional feature of a patch that a point lies on.
template <Dim N>
Feature feature_at(const Patch<N>& patch, const Vec<N, double>& point, double slack) {
  for (std::size_t i = 0; i < patch.size; ++i) {
    if (sum_abs(patch.corners[i] - point) <= slack) return {FeatureKind::vertex, patch.vertices[i]};
  }
  if (patch.size == 1) return {FeatureKind::vertex, patch.vertices[0]};
  if (N == 2 || patch.size == 2) return {FeatureKind::edge, patch.face};
  for (std::size_t i = 0; i < patch.size; ++i) {
    const std::size_t next = i + 1 < patch.size ? i + 1 : 0;
    const Segment<N, double> edge{patch.corners[i], patch.corners[next]};
    if (squared(closest_on(edge, point)) <= slack * slack) return {FeatureKind::edge, patch.edges[i]};
  }
  return {FeatureKind::face, patch.face};
}

/// Only the contact point.
template <Dim N>
SurfacePairs<N> single_pair(const FacingPatches<N>& facing, const Penetration<N>& found, double slack) {
  const Vec<N, double> core_a = found.point_a - found.normal * facing.radius_a;
  const Vec<N, double> core_b = found.point_b + found.normal * facing.radius_b;
  SurfacePairs<N> result;
  result.push_back({found.point_a, found.point_b, found.depth, feature_at(facing.a, core_a, slack),
                    feature_at(facing.b, core_b, slack)});
  return result;
}

/// The same over the face of b.
template <Dim N>
SurfacePairs<N> pairs_over_b(const FacingPatches<N>& facing, const Vec<N, double>& normal, double slack) {
  SurfacePairs<N> result = pairs_over(exchanged(facing), -normal, slack);
  for (SurfacePair<N>& pair : result) pair = exchanged(pair);
  return result;
}

/// The reference face is the one that faces along the normal: that of a if both do, but a plane in any case, which has
/// no corners to project. None if no face does.
template <Dim N>
SurfacePairs<N> face_pairs(const FacingPatches<N>& facing, const Vec<N, double>& normal, double slack) {
  const bool b_is_unbounded = facing.b.size == 0;
  if (is_face_along(facing.a, normal) && !b_is_unbounded) return pairs_over(facing, normal, slack);
  if (is_face_along(facing.b, -normal)) return pairs_over_b(facing, normal, slack);
  return {};
}

/// By their features, in an order independent of the order of the shapes: so that of equally good points the same are
/// selected after a common rotation of the shapes, which may change their order.
template <Dim N>
void sort_by_features(SurfacePairs<N>& pairs) {
  const auto names = [](const SurfacePair<N>& pair) {
    const std::pair a(pair.feature_a.kind, pair.feature_a.index);
    const std::pair b(pair.feature_b.kind, pair.feature_b.index);
    return std::tuple(std::min(a, b), std::max(a, b), a);
  };
  std::sort(pairs.begin(), pairs.end(),
            [&](const SurfacePair<N>& a, const SurfacePair<N>& b) { return names(a) < names(b); });
}

/// Whether the deepest of some pairs is as deep as the contact. If a face is not exactly perpendicular to the normal,
/// the contact may lie beside it, and the part of a steep edge over the face may be far less deep.
template <Dim N>
bool are_as_deep(const SurfacePairs<N>& pairs, const FacingPatches<N>& facing, double depth, double slack) {
  double deepest = 0.0 - facing.margin;
  for (const SurfacePair<N>& pair : pairs) deepest = std::max(deepest, pair.depth);
  const double size =
      (size_of_patch(facing.a) + size_of_patch(facing.b)) + (facing.radius_a + facing.radius_b) + std::fabs(depth);
  return deepest >= depth - (slack + 0.5 * tolerance::aligned * size);
}

/// The points of faces or of parallel edges; for everything else only the deepest point.
template <Dim N>
SurfacePairs<N> surface_pairs(const FacingPatches<N>& facing, const Penetration<N>& found, double slack) {
  SurfacePairs<N> result = face_pairs(facing, found.normal, slack);
  if (result.empty()) result = pairs_between_edges(facing, found.normal, slack);
  if (!result.empty() && !are_as_deep(result, facing, found.depth, slack)) result = {};
  if (result.empty()) result = single_pair(facing, found, slack);
  if (result.size() > 4) sort_by_features(result);  // four of them will be selected
  return result;
}

// ---- Selecting a few of many points

/// Selects the deepest point; then the one farthest from it; then, on either side of the line between these two, the
/// one that forms the largest triangle with it. Of points that are equally good, up to `slack` times the size of the
/// patch, the first: so that smaller motions do not change the selection. `Pairs` holds pairs as SurfacePairs<3> does,
/// or a part of each.
template <class Pairs>
class SpanningChoice {
 public:
  SpanningChoice(const Pairs& from, const Vec<3, double>& normal) : from_(from), normal_(normal) {}

  /// Four of more than four, by their positions.
  std::array<std::size_t, 4> run() {
    const double size = std::sqrt(best([&](std::size_t i) { return squared_from(0, i); }, 0).value);
    const auto start = best([&](std::size_t i) { return from_[i].depth; }, size).place;
    const auto end = best([&](std::size_t i) { return squared_from(start, i); }, size * size).place;
    const auto left = best([&](std::size_t i) { return area(start, end, i); }, size * size).place;
    const auto right = best([&](std::size_t i) { return -area(start, end, i); }, size * size).place;
    return {start, end, left, right};
  }

 private:
  struct Best {
    std::size_t place;
    double value;
  };

  template <class Value>
  Best best(const Value& value, double size) const {
    Best result{0, value(0)};
    for (std::size_t i = 1; i < from_.size(); ++i) {
      const double candidate = value(i);
      if (candidate > result.value + tolerance::aligned * size) result = {i, candidate};
    }
    return result;
  }

  Vec<3, double> between(std::size_t i, std::size_t j) const { return from_[j].point_a - from_[i].point_a; }

  double squared_from(std::size_t i, std::size_t j) const { return dot(between(i, j), between(i, j)); }

  double area(std::size_t i, std::size_t j, std::size_t k) const {
    return dot(cross(between(i, j), between(i, k)), normal_);
  }

  const Pairs& from_;
  Vec<3, double> normal_;
};

}  // namespace graze::detail
