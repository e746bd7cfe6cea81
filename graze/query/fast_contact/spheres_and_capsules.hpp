// SPDX-License-Identifier: MIT
// How spheres and capsules touch each other: what penetration_of_simple finds for any two shapes, of those that clearly
// meet or clearly do not, whose axes are not nearly parallel and nowhere near each other. Include manifold.hpp.
#pragma once

#include <algorithm>
#include <cmath>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/fast_contact/fast_result.hpp>
#include <graze/query/patch/clipped.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::detail {

/// A place seen from an origin near by.
template <Dim N>
struct PlaceFrom {
  Vec<N, double> origin;
  Vec<N, double> place = Vec<N, double>(0.0);
};

/// The nearest points of the cores of two round shapes.
template <Dim N>
struct NearCores {
  PlaceFrom<N> on_a;
  PlaceFrom<N> on_b;
  Vec<N, double> between;  ///< From a to b.
  double size;             ///< The sum of the coordinates that this was calculated from.
};

/// The answer from the nearest points, if it is plain: cores that nearly meet have a normal of another kind.
template <Dim N>
[[gnu::always_inline]] inline FastContact<N> touch_of_cores(const NearCores<N>& near, double radius_a, double radius_b,
                                                            bool turns) {
  FastContact<N> result;
  const double squared = dot(near.between, near.between);
  const double distance = std::sqrt(squared);
  const double depth = (radius_a + radius_b) - distance;
  const double size = near.size + (radius_a + radius_b);
  const double doubt = tolerance::coarse * size;
  result.meets = depth > doubt;
  const bool is_normal_known = distance > tolerance::known_direction * near.size && squared > 0x1p-900;
  result.is_known = depth < -doubt || (result.meets && is_normal_known);
  const Vec<N, double> normal = near.between * (1 / distance);
  result.set(normal, depth, near.on_a.origin + (near.on_a.place + normal * radius_a),
             near.on_b.origin + (near.on_b.place - normal * radius_b), turns);
  result.found.error = 2 * tolerance::rounding * size;
  return result;
}

/// The places where two lines are nearest are off by 64 times as much as other places, if they are 7 degrees from
/// parallel, and so has their distance to be for its direction to be known.
inline bool are_lines_apart(double distance, double size) { return distance > 64 * tolerance::known_direction * size; }

template <Dim N, class T>
FastContact<N> find_fast_contact(const Sphere<N, T>& a, const Sphere<N, T>& b, bool turns) {
  const Vec<N, double> center_a = wide<N, T>(a.center);
  const Vec<N, double> center_b = wide<N, T>(b.center);
  const Vec<N, double> between = center_b - center_a;
  FastContact<N> result = touch_of_cores<N>({{center_a}, {center_b}, between, sum_abs(between)},
                                            static_cast<double>(a.radius), static_cast<double>(b.radius), turns);
  result.is_single = true;
  return result;
}

/// Of a point of a capsule's axis, so far from its start to its end: known unless rounding may have moved it on an end
/// or off it.
struct AxisFeature {
  Feature feature;
  bool is_known;
};

inline AxisFeature feature_on_axis(double place) {
  constexpr double margin = 1e-9;
  if (place <= 0) return {{FeatureKind::vertex, 0}, true};
  if (place >= 1) return {{FeatureKind::vertex, 1}, true};
  return {{FeatureKind::edge, 0}, place > margin && place < 1 - margin};
}

/// The axis as the center sees it. In the plane it has sides, and near its ends a sphere lies on one all the same.
template <Dim N, class T>
FastContact<N> find_fast_contact(const Sphere<N, T>& sphere, const Capsule<N, T>& capsule, bool turns) {
  const Vec<N, double> origin = wide<N, T>(sphere.center);
  const Vec<N, double> start = wide<N, T>(capsule.a) - origin;
  const Vec<N, double> end = wide<N, T>(capsule.b) - origin;
  const Vec<N, double> way = end - start;
  const double whole = dot(way, way);
  const double place = std::clamp(-dot(start, way) / whole, 0.0, 1.0);
  const Vec<N, double> on_axis = place < 1 ? start + way * place : end;
  FastContact<N> result =
      touch_of_cores<N>({{origin}, {origin, on_axis}, on_axis, sum_abs(start) + sum_abs(end)},
                        static_cast<double>(sphere.radius), static_cast<double>(capsule.radius), turns);
  result.is_known = result.is_known && whole > 0x1p-900;
  const AxisFeature on_capsule = feature_on_axis(place);
  result.is_single = on_capsule.is_known;
  if constexpr (N == 2) {
    constexpr double least_cosine = 16 * tolerance::aligned;
    const double along = dot(way, result.found.normal);
    result.is_single = result.is_single && (on_capsule.feature.kind == FeatureKind::edge ||
                                            along * along > least_cosine * least_cosine * whole);
  }
  result.set_features({FeatureKind::vertex, 0}, on_capsule.feature, turns);
  return result;
}

/// Where two axes in space are nearest, which are not nearly parallel: as in segment_filter.hpp.
template <class T>
FastContact<3> look_in_order(const Capsule<3, T>& a, const Capsule<3, T>& b, bool turns) {
  constexpr double least_sine_squared = 1.0 / 64;
  const Vec<3, double> origin = wide<3, T>(a.a);
  const Vec<3, double> u = wide<3, T>(a.b) - origin;
  const Vec<3, double> start = wide<3, T>(b.a) - origin;
  const Vec<3, double> end = wide<3, T>(b.b) - origin;
  const Vec<3, double> v = end - start;
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  const double uv = dot(u, v);
  const double uw = dot(u, start);
  const double vw = dot(v, start);
  const double det = uu * vv - uv * uv;
  double on_a = std::clamp((uw * vv - vw * uv) / det, 0.0, 1.0);
  const double wanted = (uv * on_a - vw) / vv;
  const double on_b = std::clamp(wanted, 0.0, 1.0);
  if (on_b != wanted) on_a = std::clamp((uv * on_b + uw) / uu, 0.0, 1.0);
  const Vec<3, double> at_a = u * on_a;
  const Vec<3, double> at_b = on_b < 1 ? start + v * on_b : end;
  const double size = sum_abs(u) + sum_abs(start) + sum_abs(end);
  FastContact<3> result = touch_of_cores<3>({{origin, at_a}, {origin, at_b}, at_b - at_a, size},
                                            static_cast<double>(a.radius), static_cast<double>(b.radius), turns);
  const double reach = static_cast<double>(a.radius) + static_cast<double>(b.radius);
  result.is_known = result.is_known && det > least_sine_squared * (uu * vv) && det > 0x1p-900 &&
                    (!result.meets || are_lines_apart(reach - result.found.depth, size));
  const AxisFeature of_a = feature_on_axis(on_a);
  const AxisFeature of_b = feature_on_axis(on_b);
  result.is_single = of_a.is_known && of_b.is_known;
  result.set_features(of_a.feature, of_b.feature, turns);
  return result;
}

template <class T>
FastContact<3> find_fast_contact(const Capsule<3, T>& a, const Capsule<3, T>& b, bool turns) {
  const bool is_first = is_in_order(a, b);
  return look_in_order(is_first ? a : b, is_first ? b : a, turns == is_first);
}

}  // namespace graze::detail
