// SPDX-License-Identifier: MIT
// The closed forms of ray_cast.hpp for spheres and capsules, and the results of all closed forms. Include ray_cast.hpp.
//
// Closed forms are calculated relative to the ray's origin, in double, so that rounding does not grow with the distance
// from the coordinate origin. They decide all rays but those that nearly touch; for those they return where these would
// touch, and `relation` decides.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::detail {

/// All points origin + t * direction with 0 <= t <= t_max. The coordinates of the direction can be squared in range,
/// and t_max may be infinite. `far` is the length of the path for `relation`, whose rounding grows with it: zero for
/// rays, whose end is irrelevant to `relation`.
template <Dim N>
struct Path {
  Vec<N, double> origin;
  Vec<N, double> direction;
  double t_max;
  double far = 0;
};

/// Any greater t, rounded to T, is greater than t_max. This is t_max itself, or slightly more. Not for a negative
/// t_max.
template <class T>
double latest_t(T t_max) {
  if constexpr (std::is_same_v<T, double>) {
    return t_max;
  } else {
    return static_cast<double>(t_max) * (1 + 0x1p-23) + 0x1p-149;  // half the way to the next float, or more
  }
}

/// Whether a direction can be squared. In float any can.
template <Dim N>
bool is_usable(const Vec<N, double>& direction) {
  const double size = max_abs(direction);
  return size > 0x1p-100 && size < 0x1p100;
}

/// A direction that can be squared, and how many times as long it is: a power of two, so that nothing is rounded.
template <Dim N, class T>
struct Usable {
  explicit Usable(const Ray<N, T>& given) : ray(given) {
    if constexpr (std::is_same_v<T, double>) {
      if (is_usable(given.direction)) return;
      int exponent = 0;
      (void)std::frexp(max_abs(given.direction), &exponent);
      for (Dim i = 0; i < N; ++i) ray.direction[i] = std::ldexp(given.direction[i], -exponent);
      scale = std::ldexp(1.0, -exponent / 2);
      rest = std::ldexp(1.0, -exponent - (-exponent / 2));
    }
  }

  /// The same point in units of the usable direction, and back: in two steps, since the scale may exceed the range of
  /// double.
  double to_usable(double t) const { return t / scale / rest; }
  double from_usable(double t) const { return t * scale * rest; }

  Ray<N, T> ray;
  double scale = 1;
  double rest = 1;
};

/// Whether a path touches a shape.
enum class RayVerdict {
  misses,  ///< By more than what `relation` would call touching.
  hits,    ///< In exact arithmetic, too.
  unclear,
};

/// The result of a closed form for a path from zero.
template <Dim N>
struct RayFinding {
  RayVerdict verdict = RayVerdict::misses;
  RawHit<N> hit{};           ///< If the path hits, or if it is unclear but touches after all.
  bool is_hit_known = true;  ///< False if the closed form does not know where the path would touch.
  bool is_certain = true;    ///< False of a hit by GJK, which `relation` has to confirm.
};

template <Dim N>
RayFinding<N> missed() {
  return {};
}

/// Unclear; the touch is found by advance_to.
template <Dim N>
RayFinding<N> unsettled() {
  return {RayVerdict::unclear, {}, false};
}

// ---- Spheres

/// Where the line t * direction enters a sphere that it meets, up to rounding. Projected along the ray, the center is
/// off it by the vector l = center - direction * middle; calculated this way, l is precise for a small distant sphere,
/// where the textbook's b^2 - 4 a c is nothing but rounding (Haines, Guenther, Akenine-Moeller, "Precision improvements
/// for ray/sphere intersection", 2019).
template <Dim N>
struct SpherePassage {
  SpherePassage(const Vec<N, double>& direction, const Vec<N, double>& center, double squared_radius)
      : whole(dot(direction, direction)),
        middle(dot(center, direction) / whole),  // a valid direction is not zero
        off(center - direction * middle),
        depth(squared_radius - dot(off, off)),
        half(std::sqrt(std::max(0.0, depth) / whole)) {}

  double enter() const { return middle - half; }
  double exit() const { return middle + half; }
  /// From the center to where the line enters.
  Vec<N, double> spoke(const Vec<N, double>& direction) const { return -(off + direction * half); }

  double whole;
  double middle;
  Vec<N, double> off;
  double depth;  ///< The square of half the chord's length, negative for lines that miss.
  double half;
};

/// The normal of a round shape along a spoke with the given rounding `error`. Always against the ray; none if the shape
/// is not larger than the rounding.
template <Dim N>
Vec<N, double> normal_along(const Vec<N, double>& spoke, const Vec<N, double>& direction, double error) {
  const double along = dot(spoke, direction);
  const Vec<N, double> against = along > 0 ? spoke - direction * (along / dot(direction, direction)) : spoke;
  const double length = std::sqrt(dot(against, against));
  return length > error ? against / length : Vec<N, double>(0.0);
}

/// The touch on a sphere. The origin is inside if the line entered before it.
template <Dim N>
RawHit<N> hit_of_sphere(const Sphere<N, double>& sphere, const SpherePassage<N>& passage,
                        const Vec<N, double>& direction, double t_max) {
  RawHit<N> hit;
  hit.error = tolerance::rounding * (sum_abs(sphere.center) + sphere.radius);
  if (!(passage.enter() >= 0)) return hit;
  hit.t = std::min(passage.enter(), t_max);
  hit.normal = normal_along(passage.spoke(direction), direction, hit.error);
  hit.point = sphere.center + hit.normal * sphere.radius;
  return hit;
}

/// Whether the line of a path misses a sphere by more than `ray_verdict_of` leaves undecided. For most paths this is
/// enough, and a verdict alone needs no memory.
template <Dim N>
[[gnu::always_inline]] inline bool is_missed(const Sphere<N, double>& sphere, const Path<N>& path) {
  const double squared_radius = sphere.radius * sphere.radius;
  const double squares = dot(sphere.center, sphere.center) + squared_radius + path.far * path.far;
  return SpherePassage<N>(path.direction, sphere.center, squared_radius).depth < -tolerance::ray_filter * squares;
}

/// With size^2 = |center|^2 + radius^2: where the squares differ by more than tolerance::ray_filter of size^2, half the
/// chord is at least 2^-21 of the size and known to 2^-28 of it. A point that is still 2^-20 of the size away from the
/// sphere along the ray is off it by 2^-41 of the size at least, for the square of its distance exceeds radius^2 by the
/// square of that.
template <Dim N>
[[gnu::always_inline]] inline RayFinding<N> ray_verdict_of(const Sphere<N, double>& sphere, const Path<N>& path) {
  const auto& [origin, direction, t_max, far] = path;
  const double squared_radius = sphere.radius * sphere.radius;
  const double squares = dot(sphere.center, sphere.center) + squared_radius + far * far;
  const SpherePassage<N> passage(direction, sphere.center, squared_radius);
  const double band = tolerance::ray_filter * squares;
  if (passage.depth < -band) return missed<N>();
  const double end_slack = tolerance::ray_end * std::sqrt(squares / passage.whole);
  const bool is_chord = passage.depth > band;
  if (is_chord && (passage.exit() < -end_slack || passage.enter() > t_max + end_slack)) return missed<N>();
  const bool is_hit = is_chord && passage.exit() > end_slack && passage.enter() < t_max - end_slack;
  return {is_hit ? RayVerdict::hits : RayVerdict::unclear, hit_of_sphere(sphere, passage, direction, t_max)};
}

// ---- Capsules

/// The squared distance of a path from zero to a segment, unless they are within 7 degrees of parallel; as in
/// filter_of_segments, but in units of the direction.
template <Dim N>
std::optional<Relation> filter_of_path(const Capsule<N, double>& capsule, const Path<N>& path) {
  const auto& [origin, direction, t_max, far] = path;
  constexpr double least_sine_squared = 1.0 / 64;
  const double scale = scale_to_moderate(max_abs(capsule.b - capsule.a));
  const Vec<N, double> edge = (capsule.b - capsule.a) * scale;
  const double uu = dot(direction, direction);
  const double vv = dot(edge, edge);
  const double uv = dot(direction, edge);
  const double uw = dot(direction, capsule.a);
  const double vw = dot(edge, capsule.a);
  const double det = uu * vv - uv * uv;
  if (!(det > least_sine_squared * (uu * vv))) return std::nullopt;  // so uu, vv and det are not zero
  double s = std::clamp((uw * vv - vw * uv) / det, 0.0, t_max);
  const double share = (uv * s - vw) / vv;
  const double on_axis = std::clamp(share, 0.0, 1 / scale);  // a power of two
  if (on_axis != share) s = std::clamp((uv * on_axis + uw) / uu, 0.0, t_max);
  const Vec<N, double> between = direction * s - (edge * on_axis + capsule.a);
  const double size = sum_abs(direction) * s + sum_abs(edge) / scale + sum_abs(capsule.a) + capsule.radius + far;
  return clear_verdict(dot(between, between), capsule.radius, tolerance::segment_filter * size);
}

/// Whether zero is inside a capsule whose axis is not a point.
template <Dim N>
bool holds_zero(const Capsule<N, double>& capsule) {
  const Vec<N, double> edge = capsule.b - capsule.a;
  const double share = std::clamp(-dot(capsule.a, edge) / dot(edge, edge), 0.0, 1.0);
  const Vec<N, double> off = capsule.a + edge * share;
  return dot(off, off) <= capsule.radius * capsule.radius;
}

/// The touch of a path that is known to hit and is not nearly parallel to the axis: on the cylinder, which is a sphere
/// when projected along the axis, if that is between the two ends, otherwise on the sphere around the nearer end.
template <Dim N>
RawHit<N> hit_of_capsule(const Capsule<N, double>& capsule, const Vec<N, double>& direction, double t_max) {
  RawHit<N> hit;
  hit.error = tolerance::rounding * (sum_abs(capsule.a) + sum_abs(capsule.b) + capsule.radius);
  if (holds_zero(capsule)) return hit;
  const Vec<N, double> edge = capsule.b - capsule.a;
  const double whole = dot(edge, edge);
  const auto across = [&](const Vec<N, double>& v) { return v - edge * (dot(v, edge) / whole); };
  const Vec<N, double> direction_across = across(direction);
  const SpherePassage<N> tube(direction_across, across(capsule.a), capsule.radius * capsule.radius);
  const double enter = std::clamp(tube.enter(), 0.0, t_max);
  const double place = dot(direction * enter - capsule.a, edge) / whole;
  if (!(place >= 0 && place <= 1)) {
    const Sphere<N, double> end{place < 0 ? capsule.a : capsule.b, capsule.radius};
    RawHit<N> on_end =
        hit_of_sphere(end, SpherePassage<N>(direction, end.center, end.radius * end.radius), direction, t_max);
    on_end.error = hit.error;
    return on_end;
  }
  hit.t = enter;
  hit.normal = normal_along(tube.spoke(direction_across), direction, hit.error);
  hit.point = capsule.a + edge * place + hit.normal * capsule.radius;
  return hit;
}

template <Dim N>
RayFinding<N> ray_verdict_of(const Capsule<N, double>& capsule, const Path<N>& path) {
  const std::optional<Relation> verdict = filter_of_path(capsule, path);
  if (!verdict) return unsettled<N>();
  if (*verdict == Relation::apart) return missed<N>();
  return {RayVerdict::hits, hit_of_capsule(capsule, path.direction, path.t_max)};
}

}  // namespace graze::detail
