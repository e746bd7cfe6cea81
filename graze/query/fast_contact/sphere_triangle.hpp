// SPDX-License-Identifier: MIT
// Contacts of spheres and 3D triangles: what penetration_of_simple finds for any two shapes, for spheres whose center
// is clearly off the triangle, and for triangles that are not needles. Include manifold.hpp.
#pragma once

#include <cmath>
#include <cstdint>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/fast_contact/fast_result.hpp>
#include <graze/query/fast_contact/spheres_and_capsules.hpp>
#include <graze/query/patch/clipped.hpp>
#include <graze/shape/sphere.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

/// The point of a triangle nearest to the origin, and the feature that it lies on: known unless rounding may have moved
/// it to a neighbouring one.
struct NearOnTriangle {
  Vec<3, double> place;
  Feature feature;
  bool is_known;
};

/// The point at a fraction of a side.
inline NearOnTriangle near_on_side(const Vec<3, double>& start, const Vec<3, double>& way, double along,
                                   std::uint32_t side) {
  constexpr double margin = 1e-9;
  return {start + way * along, {FeatureKind::edge, side}, along > margin && along < 1 - margin};
}

/// By the region that contains the origin (Ericson, Real-Time Collision Detection, 2005, 5.1.5), for a triangle that is
/// not a needle.
inline NearOnTriangle nearest_to_zero(const Triangle<3, double>& triangle) {
  constexpr double margin = 1e-9;
  const auto& [a, b, c] = triangle;
  const Vec<3, double> ab = b - a;
  const Vec<3, double> ac = c - a;
  const double a_along_ab = -dot(ab, a);
  const double a_along_ac = -dot(ac, a);
  if (a_along_ab <= 0 && a_along_ac <= 0) return {a, {FeatureKind::vertex, 0}, true};
  const double b_along_ab = -dot(ab, b);
  const double b_along_ac = -dot(ac, b);
  if (b_along_ab >= 0 && b_along_ac <= b_along_ab) return {b, {FeatureKind::vertex, 1}, true};
  const double c_along_ab = -dot(ab, c);
  const double c_along_ac = -dot(ac, c);
  if (c_along_ac >= 0 && c_along_ab <= c_along_ac) return {c, {FeatureKind::vertex, 2}, true};
  const double of_c = a_along_ab * b_along_ac - b_along_ab * a_along_ac;
  if (of_c <= 0 && a_along_ab >= 0 && b_along_ab <= 0) {
    return near_on_side(a, ab, a_along_ab / (a_along_ab - b_along_ab), 0);
  }
  const double of_b = c_along_ab * a_along_ac - a_along_ab * c_along_ac;
  if (of_b <= 0 && a_along_ac >= 0 && c_along_ac <= 0) {
    return near_on_side(a, ac, a_along_ac / (a_along_ac - c_along_ac), 2);
  }
  const double of_a = b_along_ab * c_along_ac - c_along_ab * b_along_ac;
  const double from_b = b_along_ac - b_along_ab;
  const double from_c = c_along_ab - c_along_ac;
  if (of_a <= 0 && from_b >= 0 && from_c >= 0) return near_on_side(b, c - b, from_b / (from_b + from_c), 1);
  const Vec<3, double> normal = cross(ab, ac);
  const double all = of_a + of_b + of_c;
  return {normal * (dot(normal, a) / dot(normal, normal)),
          {FeatureKind::face, 0},
          of_a > margin * all && of_b > margin * all && of_c > margin * all};
}

/// The triangle relative to the center. Its normal is known to a few hundred epsilon, since two sides are 7 degrees
/// from parallel.
template <class T>
FastContact<3> find_fast_contact(const Sphere<3, T>& sphere, const Triangle<3, T>& triangle, bool turns) {
  const Vec<3, double> origin = wide<3, T>(sphere.center);
  const Triangle<3, double> seen{wide<3, T>(triangle.a) - origin, wide<3, T>(triangle.b) - origin,
                                 wide<3, T>(triangle.c) - origin};
  const NearOnTriangle near = nearest_to_zero(seen);
  const double size = sum_abs(seen.a) + sum_abs(seen.b) + sum_abs(seen.c);
  const auto radius = static_cast<double>(sphere.radius);
  one_pair::RoundContact<Vec<3, double>> contact = one_pair::contact_of_cores<Vec<3, double>>(
      {origin, Vec<3, double>(0.0), origin, near.place, near.place, size}, radius, 0);
  constexpr double least_sine_squared = 1.0 / 64;
  const Vec<3, double> ab = seen.b - seen.a;
  const Vec<3, double> ac = seen.c - seen.a;
  const Vec<3, double> face = cross(ab, ac);
  const double squared = dot(face, face);
  const bool is_plain =
      near.is_known && squared > least_sine_squared * (dot(ab, ab) * dot(ac, ac)) && squared > 0x1p-900;
  contact.is_apart = contact.is_apart && is_plain;
  contact.meets = contact.meets && is_plain && one_pair::are_lines_apart(radius - contact.depth, size);
  // Next to the face, but hardly off its normal, the sphere still lies on the face.
  constexpr double least_sine = 16 * tolerance::aligned;
  const Vec<3, double> turn = cross(face, contact.normal);
  contact.is_single = near.feature.kind == FeatureKind::face || dot(turn, turn) > least_sine * least_sine * squared;
  contact.of_second = one_pair::name_of(near.feature.kind, near.feature.index);
  return fast_contact_of(contact, turns);
}

}  // namespace graze::detail
