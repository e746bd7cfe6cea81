// SPDX-License-Identifier: MIT
// Contacts of spheres, capsules and boxes with planes and half-spaces: what penetration_in_half_space finds for every
// convex shape, for pairs that clearly meet or are clearly disjoint, by plain sums. Include manifold.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/fast_contact/fast_result.hpp>
#include <graze/query/patch/clipped.hpp>
#include <graze/query/patch/manifold_points.hpp>
#include <graze/query/patch/patch.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/half_space.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::detail {

/// The boundary of a plane or a half-space, and data for its contacts.
template <Dim N>
class HalfSpaceContact {
 public:
  template <class T>
  HalfSpaceContact(const Plane<N, T>& plane, bool is_solid)
      : normal_(wide<N, T>(plane.normal)),
        offset_(static_cast<double>(plane.offset)),
        squared_(dot(normal_, normal_)),
        length_(std::sqrt(squared_)),
        is_solid_(is_solid) {}

  const Vec<N, double>& normal() const { return normal_; }
  double length() const { return length_; }

  /// The height of a point, in units of the normal.
  double height_of(const Vec<N, double>& place) const { return dot(normal_, place) - offset_; }

  /// The contact of a shape whose core has its lowest and its highest point at these two points; `magnitude` is the sum
  /// of all magnitudes involved. From the boundary to the shape, unless it `turns`; a plane pushes the shape to the
  /// nearer side.
  FastContact<N> look(const Vec<N, double>& lowest, const Vec<N, double>& highest, double radius,
                      const Vec<N, double>& magnitude, bool turns) const {
    const double below = height_of(lowest);
    const double above = -height_of(highest);
    const double inverse = 1 / length_;
    const double size = (dot(abs(normal_), magnitude) + std::fabs(offset_)) * inverse + radius;
    const double doubt = 4 * tolerance::convex * size;
    const bool is_upward = is_solid_ || below >= above;
    const double depth = radius - (is_upward ? below : above) * inverse;
    FastContact<N> result;
    result.meets = depth > doubt;
    const bool is_side_known = is_solid_ || std::fabs(below - above) * inverse > doubt;
    const bool is_moderate = squared_ > 0x1p-400 && squared_ < 0x1p400 && !std::isnan(below + above);
    result.is_known = is_moderate && (depth < -doubt || (result.meets && is_side_known));
    const Vec<N, double> normal = normal_ * (is_upward ? inverse : -inverse);
    const Vec<N, double> on_shape = (is_upward ? lowest : highest) - normal * radius;
    result.set(normal, depth, on_shape + normal * depth, on_shape, turns);
    result.found.error = tolerance::convex * size;
    result.set_features({N == 2 ? FeatureKind::edge : FeatureKind::face, 0}, {FeatureKind::vertex, 0}, turns);
    return result;
  }

 private:
  Vec<N, double> normal_;
  double offset_;
  double squared_;
  double length_;
  bool is_solid_;
};

template <Dim N, class T>
HalfSpaceContact<N> half_space_contact(const Plane<N, T>& plane) {
  return {plane, false};
}
template <Dim N, class T>
HalfSpaceContact<N> half_space_contact(const HalfSpace<N, T>& solid) {
  return {boundary(solid), true};
}

template <class Level, Dim N, class T>
FastContact<N> look_at_half_space(const Level& level, const Sphere<N, T>& sphere, bool turns) {
  const Vec<N, double> center = wide<N, T>(sphere.center);
  FastContact<N> result =
      half_space_contact(level).look(center, center, static_cast<double>(sphere.radius), abs(center), turns);
  result.is_single = true;
  return result;
}

template <class Level, Dim N, class T>
FastContact<N> look_at_half_space(const Level& level, const Capsule<N, T>& capsule, bool turns) {
  const HalfSpaceContact<N> touch = half_space_contact(level);
  const Vec<N, double> a = wide<N, T>(capsule.a);
  const Vec<N, double> b = wide<N, T>(capsule.b);
  const bool is_b_lower = touch.height_of(b) < touch.height_of(a);
  return touch.look(is_b_lower ? b : a, is_b_lower ? a : b, static_cast<double>(capsule.radius), max(abs(a), abs(b)),
                    turns);
}

template <class Level, Dim N>
FastContact<N> look_at_half_space(const Level& level, const Vec<N, double>& center, const Mat<N, double>& half_edges,
                                  bool turns) {
  const HalfSpaceContact<N> touch = half_space_contact(level);
  Vec<N, double> lowest = center;
  Vec<N, double> highest = center;
  Vec<N, double> magnitude = abs(center);
  for (Dim i = 0; i < N; ++i) {
    const Vec<N, double> up = half_edges[i] * std::copysign(1.0, dot(touch.normal(), half_edges[i]) + 0.0);
    lowest -= up;
    highest += up;
    magnitude += abs(up);
  }
  return touch.look(lowest, highest, 0, magnitude, turns);
}

template <class Level, Dim N, class T>
FastContact<N> look_at_half_space(const Level& level, const Obb<N, T>& box, bool turns) {
  return look_at_half_space(level, wide<N, T>(box.center), half_edges(box), turns);
}

template <class Level, Dim N, class T>
FastContact<N> look_at_half_space(const Level& level, const Aabb<N, T>& box, bool turns) {
  const HalfSpaceContact<N> touch = half_space_contact(level);
  const Vec<N, double> low = wide<N, T>(box.min);
  const Vec<N, double> high = wide<N, T>(box.max);
  Vec<N, double> lowest;
  Vec<N, double> highest;
  for (Dim i = 0; i < N; ++i) {
    const bool climbs = touch.normal()[i] >= 0;
    lowest[i] = climbs ? low[i] : high[i];
    highest[i] = climbs ? high[i] : low[i];
  }
  return touch.look(lowest, highest, 0, max(abs(low), abs(high)), turns);
}

// ---- Boxes with a whole face on the boundary

/// The corners of one face of a box.
template <Dim N>
using FacePairs = std::array<SurfacePair<N>, N == 2 ? 2 : 4>;

/// The face of a box that faces along a direction, if it does so clearly more than the others.
template <Dim N>
std::optional<BoxFaceNumbers> face_along(const Mat<N, double>& axes, const Vec<N, double>& direction) {
  constexpr double clearly = 16 * tolerance::orthonormal;  // as between oriented boxes
  double best = -1;
  double second = -1;
  BoxFaceNumbers face;
  for (Dim i = 0; i < N; ++i) {
    const double height = dot(axes[i], direction);
    const double steepness = std::fabs(height);
    second = std::max(second, std::min(steepness, best));
    if (steepness > best) face = {i, height > 0};
    best = std::max(best, steepness);
  }
  if (!(best - second > clearly)) return std::nullopt;
  return face;
}

/// The number of a corner of a face and its position, in half edges from the middle of the box.
template <Dim N>
std::uint32_t vertex_of_face(const BoxFaceNumbers& face, std::uint32_t corner) {
  if constexpr (N == 3) {
    return face.vertex(corner);
  } else {
    return (face.is_far ? 1U : 0U) << static_cast<unsigned>(face.axis) | corner << static_cast<unsigned>(1 - face.axis);
  }
}

/// The manifold of a box and a boundary, `found` from the box to the boundary: the corners of the face along the
/// normal, if all of them are clearly below the boundary, so that nothing is clipped.
template <Dim N>
std::optional<FacePairs<N>> corners_on_boundary(const Vec<N, double>& center, const Mat<N, double>& axes,
                                                const Vec<N, double>& half_extents, const Penetration<N>& found) {
  const std::optional<BoxFaceNumbers> face = face_along<N>(axes, found.normal);
  bool is_clear = face.has_value();
  for (Dim i = 0; i < N; ++i) is_clear = is_clear && half_extents[i] > 0;
  if (!is_clear) return std::nullopt;
  FacePairs<N> pairs;
  for (std::uint32_t corner = 0; corner < pairs.size(); ++corner) {
    const std::uint32_t vertex = vertex_of_face<N>(*face, corner);
    Vec<N, double> place = center;
    for (Dim i = 0; i < N; ++i) {
      place += axes[i] * ((vertex >> static_cast<unsigned>(i) & 1U) != 0 ? half_extents[i] : -half_extents[i]);
    }
    const double depth = found.depth + dot(found.normal, place - found.point_a);
    is_clear = is_clear && depth > 4 * found.error;
    pairs[corner] = {place,
                     place - found.normal * depth,
                     depth,
                     {FeatureKind::vertex, vertex},
                     {N == 2 ? FeatureKind::edge : FeatureKind::face, 0}};
  }
  if (!is_clear) return std::nullopt;
  return pairs;
}

template <Dim N, class T>
std::optional<FacePairs<N>> corners_on_boundary(const Obb<N, T>& box, const Penetration<N>& found) {
  return corners_on_boundary<N>(wide<N, T>(box.center), wide_matrix<N, T>(box.axes), wide<N, T>(box.half_extents),
                                found);
}
template <Dim N, class T>
std::optional<FacePairs<N>> corners_on_boundary(const Aabb<N, T>& box, const Penetration<N>& found) {
  const Vec<N, double> low = wide<N, T>(box.min);
  const Vec<N, double> high = wide<N, T>(box.max);
  return corners_on_boundary<N>(0.5 * (low + high), Mat<N, double>(1.0), 0.5 * (high - low), found);
}

// ---- In the order of AnyShape

template <Dim N, class T>
FastContact<N> find_fast_contact(const Sphere<N, T>& sphere, const Plane<N, T>& plane, bool turns) {
  return look_at_half_space(plane, sphere, !turns);
}
template <Dim N, class T>
FastContact<N> find_fast_contact(const Sphere<N, T>& sphere, const HalfSpace<N, T>& solid, bool turns) {
  return look_at_half_space(solid, sphere, !turns);
}
template <Dim N, class T>
FastContact<N> find_fast_contact(const Aabb<N, T>& box, const Plane<N, T>& plane, bool turns) {
  return look_at_half_space(plane, box, !turns);
}
template <Dim N, class T>
FastContact<N> find_fast_contact(const Aabb<N, T>& box, const HalfSpace<N, T>& solid, bool turns) {
  return look_at_half_space(solid, box, !turns);
}
template <Dim N, class T>
FastContact<N> find_fast_contact(const Obb<N, T>& box, const Plane<N, T>& plane, bool turns) {
  return look_at_half_space(plane, box, !turns);
}
template <Dim N, class T>
FastContact<N> find_fast_contact(const Obb<N, T>& box, const HalfSpace<N, T>& solid, bool turns) {
  return look_at_half_space(solid, box, !turns);
}
template <Dim N, class T>
FastContact<N> find_fast_contact(const Plane<N, T>& plane, const Capsule<N, T>& capsule, bool turns) {
  return look_at_half_space(plane, capsule, turns);
}
template <Dim N, class T>
FastContact<N> find_fast_contact(const HalfSpace<N, T>& solid, const Capsule<N, T>& capsule, bool turns) {
  return look_at_half_space(solid, capsule, turns);
}

}  // namespace graze::detail
