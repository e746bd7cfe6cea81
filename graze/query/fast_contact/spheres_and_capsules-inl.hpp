// SPDX-License-Identifier: MIT
// Contacts of spheres and capsules, for one pair or many (one_pair.hpp): the same results as the general
// penetration_of_simple, for pairs that clearly meet or are clearly disjoint, and whose axes are neither nearly
// parallel nor very close to each other.

/// The contact of two shapes in one point.
template <class P>
struct RoundContact {
  Mask is_apart;   ///< Certainly; then only the error is valid besides.
  Mask meets;      ///< Certainly, as described below. If neither, nothing is valid.
  Mask is_single;  ///< Whether the manifold is only this point, on the features below.
  P normal;        ///< From the first to the second.
  Real depth;
  P on_first;
  P on_second;
  Real error;
  FeatureName of_first;
  FeatureName of_second;
};

/// For pairs none of which certainly meets.
template <class P>
[[gnu::always_inline]] inline RoundContact<P> no_contact(Mask is_apart, Real error) {
  const P place = zero<P>();
  return {is_apart, all(false), all(false), place, all(0.0), place, place, error, all(first_vertex), all(first_vertex)};
}

/// The nearest points of the cores of two round shapes, each relative to a nearby origin.
template <class P>
struct NearCores {
  P first_origin;
  P on_first;
  P second_origin;
  P on_second;
  P between;  ///< From the first to the second.
  Real size;  ///< The sum of the coordinates that this was calculated from.
};

/// The result from the nearest points, if it is easy to decide: cores that nearly meet have a different kind of normal.
template <class P>
[[gnu::always_inline]] inline RoundContact<P> contact_of_cores(const NearCores<P>& near, Real first_radius,
                                                               Real second_radius) {
  RoundContact<P> result;
  const Real squared = dot(near.between, near.between);
  const Real distance = sqrt(squared);
  const Real reach = first_radius + second_radius;
  const Real size = near.size + reach;
  const Real doubt = tolerance::coarse * size;
  result.depth = reach - distance;
  result.is_apart = result.depth < -doubt;
  result.meets = result.depth > doubt && distance > tolerance::known_direction * near.size && squared > 0x1p-900;
  result.is_single = all(true);
  result.normal = near.between * (1.0 / distance);
  result.on_first = near.first_origin + (near.on_first + result.normal * first_radius);
  result.on_second = near.second_origin + (near.on_second - result.normal * second_radius);
  result.error = 2 * tolerance::rounding * size;
  result.of_first = result.of_second = all(first_vertex);
  return result;
}

/// The nearest points of two lines that are 7 degrees from parallel are off by 64 times as much as other points; their
/// distance must be larger than that for its direction to be known.
[[gnu::always_inline]] inline Mask are_lines_apart(Real distance, Real size) {
  return distance > 64 * tolerance::known_direction * size;
}

/// The feature of a point of a capsule's axis at a fraction from its start to its end: known unless rounding may have
/// moved it across an end.
struct AxisFeature {
  FeatureName feature;
  Mask is_between;
  Mask is_known;
};

[[gnu::always_inline]] inline AxisFeature feature_on_axis(Real place) {
  constexpr double margin = 1e-9;
  const Mask is_start = place <= 0.0;
  const Mask is_end = place >= 1.0;
  return {select(is_start, all(first_vertex), select(is_end, all(second_vertex), all(first_edge))),
          !(is_start || is_end), is_start || is_end || (place > margin && place < 1 - margin)};
}

[[gnu::always_inline]] inline Real clamped_to_one(Real v) { return min_of(max_of(v, all(0.0)), all(1.0)); }

template <class P>
struct SphereNumbers {
  P center;
  Real radius;
};

template <class P>
struct CapsuleNumbers {
  P start;
  P end;
  Real radius;
};

template <class P>
[[gnu::always_inline]] inline RoundContact<P> contact_of(const SphereNumbers<P>& first,
                                                         const SphereNumbers<P>& second) {
  const P between = second.center - first.center;
  return contact_of_cores<P>({first.center, zero<P>(), second.center, zero<P>(), between, sum_abs(between)},
                             first.radius, second.radius);
}

/// The axis relative to the center. In 2D it has sides, and near its ends a sphere still lies on one.
template <class P>
[[gnu::always_inline]] inline RoundContact<P> contact_of(const SphereNumbers<P>& sphere,
                                                         const CapsuleNumbers<P>& capsule) {
  const P start = capsule.start - sphere.center;
  const P end = capsule.end - sphere.center;
  const P way = end - start;
  const Real whole = dot(way, way);
  const Real place = clamped_to_one(-dot(start, way) / whole);
  const P on_axis = select(place < 1.0, start + way * place, end);
  RoundContact<P> result =
      contact_of_cores<P>({sphere.center, zero<P>(), sphere.center, on_axis, on_axis, sum_abs(start) + sum_abs(end)},
                          sphere.radius, capsule.radius);
  const Mask is_long = whole > 0x1p-900;
  result.is_apart = both_of(result.is_apart, is_long);
  result.meets = both_of(result.meets, is_long);
  const AxisFeature of_capsule = feature_on_axis(place);
  result.is_single = of_capsule.is_known;
  if constexpr (std::is_same_v<P, Point2d>) {
    constexpr double least_cosine = 16 * tolerance::aligned;
    const Real along = dot(way, result.normal);
    result.is_single =
        result.is_single && (of_capsule.is_between || along * along > least_cosine * least_cosine * whole);
  }
  result.of_second = of_capsule.feature;
  return result;
}

/// The nearest points of two axes in 3D, which are not nearly parallel: as in segment_filter.hpp. In their order.
[[gnu::always_inline]] inline RoundContact<Point> contact_of(const CapsuleNumbers<Point>& first,
                                                             const CapsuleNumbers<Point>& second) {
  constexpr double least_sine_squared = 1.0 / 64;
  const Point origin = first.start;
  const Point u = first.end - origin;
  const Point start = second.start - origin;
  const Point end = second.end - origin;
  const Point v = end - start;
  const Real uu = dot(u, u);
  const Real vv = dot(v, v);
  const Real uv = dot(u, v);
  const Real uw = dot(u, start);
  const Real vw = dot(v, start);
  const Real det = uu * vv - uv * uv;
  Real on_first = clamped_to_one((uw * vv - vw * uv) / det);
  const Real wanted = (uv * on_first - vw) / vv;
  const Real on_second = clamped_to_one(wanted);
  const Mask is_held = !(on_second == wanted);
  if (any_likely(is_held)) take(is_held, clamped_to_one((uv * on_second + uw) / uu), on_first);
  const Point at_first = u * on_first;
  const Point at_second = select(on_second < 1.0, start + v * on_second, end);
  const Real size = sum_abs(u) + sum_abs(start) + sum_abs(end);
  RoundContact<Point> result = contact_of_cores<Point>(
      {origin, at_first, origin, at_second, at_second - at_first, size}, first.radius, second.radius);
  const Real distance = first.radius + second.radius - result.depth;
  const Mask are_crossed = det > least_sine_squared * (uu * vv) && det > 0x1p-900;
  result.is_apart = result.is_apart && are_crossed;
  result.meets = result.meets && are_crossed && are_lines_apart(distance, size);
  const AxisFeature of_first = feature_on_axis(on_first);
  const AxisFeature of_second = feature_on_axis(on_second);
  result.is_single = of_first.is_known && of_second.is_known;
  result.of_first = of_first.feature;
  result.of_second = of_second.feature;
  return result;
}
