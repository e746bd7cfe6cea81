// SPDX-License-Identifier: MIT
// Bounding spheres of points: bounding_sphere, the smallest one, and bounding_sphere_fast, slightly larger but cheaper.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <graze/math/orientation.hpp>
#include <graze/math/platform/throw.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounding/box.hpp>
#include <graze/query/bounding/extreme_points.hpp>
#include <graze/shape/sphere.hpp>

namespace graze {
namespace detail {

/// Points in their local frame, converted on access: nothing is copied.
template <Dim N, class T>
struct LocalPoints {
  std::span<const Vec<N, T>> points;
  LocalFrame<N> frame;

  std::size_t size() const { return points.size(); }
  Vec<N, double> operator[](std::size_t i) const { return frame.local(points[i]); }
};

/// A sphere with its squared radius; negative for no sphere.
template <Dim N>
struct BoundingBall {
  Vec<N, double> center = Vec<N, double>(0.0);
  double radius_squared = -1;
};

/// A few points: those on the boundary of the sphere, and one more.
template <Dim N>
struct FewPoints {
  std::array<Vec<N, double>, static_cast<std::size_t>(N) + 2> points{};
  std::size_t count = 0;

  std::size_t size() const { return count; }
  const Vec<N, double>& operator[](std::size_t i) const { return points[i]; }
  void push_back(const Vec<N, double>& point) { points[count++] = point; }
};

/// A point and its squared distance from somewhere.
struct Farthest {
  std::size_t index = 0;
  double distance_squared = 0;
};

template <Dim N, class Points>
Farthest farthest_point(const Vec<N, double>& center, const Points& points) {
  Farthest farthest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double squared = length_squared<N, double>(points[i] - center);
    if (squared > farthest.distance_squared) farthest = {i, squared};
  }
  return farthest;
}

/// The component of `v` perpendicular to the unit vectors `axes[0 .. count)`; calculated twice, because after one pass
/// the rounding error of a long `v` can be as large as the remainder.
template <Dim N>
Vec<N, double> rest_of(Vec<N, double> v, const std::array<Vec<N, double>, static_cast<std::size_t>(N)>& axes,
                       std::size_t count) {
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < count; ++i) v -= axes[i] * dot(axes[i], v);
  }
  return v;
}

/// The nearest center equidistant from the given points, at most N + 1, or the last such of fewer points if one depends
/// on those before. With edges e_j from the first point the center is at c = sum x_j e_j, where e_j . c = e_j . e_j /
/// 2: each edge, longest remainder first, adds a step perpendicular to the previous ones.
template <Dim N>
Vec<N, double> equidistant_center(const FewPoints<N>& corners) {
  std::array<Vec<N, double>, static_cast<std::size_t>(N)> edges{};
  std::array<Vec<N, double>, static_cast<std::size_t>(N)> axes{};
  const std::size_t count = corners.size() - 1;
  for (std::size_t i = 0; i < count; ++i) edges[i] = corners[i + 1] - corners[0];
  Vec<N, double> c(0.0);
  for (std::size_t done = 0; done < count; ++done) {
    for (std::size_t i = done + 1; i < count; ++i) {
      const bool longer =
          length_squared(rest_of<N>(edges[i], axes, done)) > length_squared(rest_of<N>(edges[done], axes, done));
      if (longer) std::swap(edges[i], edges[done]);
    }
    const Vec<N, double> rest = rest_of<N>(edges[done], axes, done);
    const double size = std::sqrt(length_squared(rest));
    if (!(size > 0)) break;
    axes[done] = rest / size;
    const double lacking = 0.5 * length_squared(edges[done]) - dot(edges[done], c);
    c += axes[done] * (lacking / dot(axes[done], edges[done]));
  }
  return corners[0] + c;
}

/// The smallest sphere around the points of `support` and one more that it must touch; reduces `support` to the points
/// that determine it. All subsets are tried, and every candidate is measured by the point farthest from it: if points
/// are nearly dependent, and a center is therefore wrong, it loses against the center of fewer points, which is then as
/// good. (Points closer than d make a center wrong by epsilon / d, and can be omitted at a cost of d^2. If they are
/// dependent up to rounding, it may be NaN.)
template <Dim N>
BoundingBall<N> sphere_with(FewPoints<N>& support, const Vec<N, double>& touched) {
  FewPoints<N> all = support;
  all.push_back(touched);
  BoundingBall<N> best{touched, std::numeric_limits<double>::infinity()};
  const std::size_t held = support.size();
  for (std::size_t subset = 0; subset < (std::size_t{1} << held); ++subset) {
    FewPoints<N> corners;
    corners.push_back(touched);
    for (std::size_t i = 0; i < held; ++i) {
      if ((subset >> i & 1U) != 0 && corners.size() <= static_cast<std::size_t>(N)) corners.push_back(all[i]);
    }
    const Vec<N, double> center = equidistant_center(corners);
    if (!is_finite(center)) continue;  // no distance from NaN compares
    const double radius_squared = farthest_point(center, all).distance_squared;
    if (radius_squared < best.radius_squared) {
      best = {center, radius_squared};
      support = corners;
    }
  }
  return best;
}

/// The center of the smallest sphere around points in a local frame: the sphere around a few of them grows until it
/// contains all, each time to touch the farthest point outside. Gärtner, "Fast and robust smallest enclosing spheres"
/// (1999), section 3: a small number of passes (5 to 15 on a million points). Returns the best of all centers seen.
///
/// A center that is off by d costs d, but correcting it enlarges the sphere of a few points by d^2 only: near the end
/// it grows by less than rounding shows. So the search ends when nothing is outside, up to rounding, or when the sphere
/// has not grown for some passes.
template <Dim N, class Points>
Vec<N, double> smallest_sphere_center(const Points& points) {
  constexpr int most_passes_without_growth = 16;
  FewPoints<N> support;
  BoundingBall<N> sphere;
  Vec<N, double> best = sphere.center;
  double reach = std::numeric_limits<double>::infinity();
  double largest = -1;
  for (int without_growth = 0; without_growth < most_passes_without_growth; ++without_growth) {
    const Farthest farthest = farthest_point(sphere.center, points);
    if (farthest.distance_squared < reach) {
      reach = farthest.distance_squared;
      best = sphere.center;
    }
    if (!(farthest.distance_squared > sphere.radius_squared * (1 + tolerance::sphere_gap))) break;
    sphere = sphere_with(support, points[farthest.index]);
    if (!(sphere.radius_squared > largest)) continue;
    largest = sphere.radius_squared;
    without_growth = 0;
  }
  return best;
}

/// The center of a sphere that grows over the points in one pass: for a point outside, to the smallest sphere around
/// itself and the point. Ritter, "An efficient bounding sphere" (1990).
template <Dim N, class Points>
Vec<N, double> grown_sphere_center(BoundingBall<N> sphere, const Points& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec<N, double> to_point = points[i] - sphere.center;
    const double squared = length_squared(to_point);
    if (!(squared > sphere.radius_squared)) continue;
    const double distance = std::sqrt(squared);  // not zero: it exceeds a radius
    const double radius = 0.5 * (distance + std::sqrt(sphere.radius_squared));
    sphere.center += to_point * (1 - radius / distance);
    sphere.radius_squared = radius * radius;
  }
  return sphere.center;
}

/// A nonzero number whose products with similar ones may leave the range of double.
inline bool is_vanishing(double x, double scale) { return x != 0 && std::fabs(x * scale) < 0x1p-450; }

/// The exact sign of |v|^2 - r^2 where v = p - c is known with its rounding errors.
template <std::size_t N>
int exact_side(const std::array<Rounded, N>& v, double r) {
  std::array<double, 6 * N + 2> terms{};
  std::size_t count = 0;
  const auto add_product = [&](double a, double b) {
    const Rounded product = two_product(a, b);
    terms[count++] = product.value;
    terms[count++] = product.error;
  };
  add_product(-r, r);
  for (const Rounded& d : v) {
    add_product(d.value, d.value);
    add_product(2 * d.value, d.error);
    add_product(d.error, d.error);
  }
  return sign_of_sum(terms);
}

/// Whether a point is outside a sphere, exactly, with one exception: if the decision depends on coordinates below
/// 2^-450 of the sphere's size, the point counts as outside. `scale` makes the radius about 1. The sign of |v|^2 - r^2,
/// where v = p - c, is decided in double, otherwise in twice its precision, otherwise exactly.
template <Dim N, class T>
bool is_outside(const Vec<N, T>& point, const Sphere<N, T>& sphere, double scale) {
  const double r = static_cast<double>(sphere.radius) * scale;
  std::array<Rounded, static_cast<std::size_t>(N)> v{};
  double difference = -r * r;
  bool vanishing = false;
  for (Dim i = 0; i < N; ++i) {
    const Rounded d = two_sum(static_cast<double>(point[i]), -static_cast<double>(sphere.center[i]));
    v[static_cast<std::size_t>(i)] = {d.value * scale, d.error * scale};
    difference += (d.value * scale) * (d.value * scale);
    vanishing = vanishing || is_vanishing(d.value, scale) || is_vanishing(d.error, scale);
  }
  if (std::fabs(difference) > tolerance::rounding * r * r) return difference > 0;

  Rounded twofold = two_product(-r, r);
  for (const Rounded& d : v) {
    const Rounded square = two_product(d.value, d.value);
    const Rounded sum = two_sum(twofold.value, square.value);
    twofold = {sum.value, twofold.error + (sum.error + (square.error + 2 * d.value * d.error))};
  }
  const double sharper = twofold.value + twofold.error;
  if (std::fabs(sharper) > tolerance::twofold_rounding * r * r) return sharper > 0;
  return vanishing || exact_side(v, r) > 0;
}

/// The sphere around a center with the least radius in T that contains the points exactly; infinite if T has none.
template <Dim N, class T>
Sphere<N, T> covering_sphere(std::span<const Vec<N, T>> points, const LocalFrame<N>& frame,
                             const Vec<N, double>& local_center) {
  Sphere<N, T> sphere{Vec<N, T>(frame.world(local_center)), T(0)};
  const LocalPoints<N, T> around_center{points, {wide<N, T>(sphere.center), frame.scale}};
  const double squared = farthest_point(Vec<N, double>(0.0), around_center).distance_squared;
  const double nearly = squared * (1 - tolerance::rounding);
  sphere.radius = round_down<T>(std::sqrt(nearly) / frame.scale);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (length_squared<N, double>(around_center[i]) < nearly) continue;
    while (std::isfinite(sphere.radius) && is_outside(points[i], sphere, frame.scale)) {
      sphere.radius = std::nextafter(sphere.radius, std::numeric_limits<T>::infinity());
    }
  }
  return sphere;
}

/// The sphere around points with the center that `find_center` finds in their local frame.
template <Dim N, class T, class FindCenter>
Sphere<N, T> sphere_around(std::span<const Vec<N, T>> points, const char* function, FindCenter find_center) {
  const Aabb<N, T> box = checked_box(points, function);
  const double side = largest_side(box);
  if (side == 0) return {points.front(), T(0)};
  if (std::isfinite(side)) {
    const LocalFrame<N> frame = local_frame(box);
    const Sphere<N, T> sphere = covering_sphere(points, frame, find_center(LocalPoints<N, T>{points, frame}));
    if (std::isfinite(sphere.radius)) return sphere;
  }
  GRAZE_THROW(std::invalid_argument(std::string(function) + ": the points are too far apart for a finite radius"));
}

}  // namespace detail

/// The smallest sphere that contains the points, in 2D the smallest circle. Every point is contained exactly, rounding
/// included; the radius is the least in T for the center as stored, and within
///
///     epsilon(double) * 4 * r + epsilon(T) * (r + largest |coordinate of the center|)
///
/// of the true minimum r; most of this is the rounding of the center. The order of the points may change center and
/// radius within this error. One point, or all points equal: radius zero. Duplicates and points on a common line, plane
/// or sphere are allowed. Throws std::invalid_argument if there are no points, a coordinate is not finite, or the
/// points are too far apart for a finite radius in T.
///
/// Takes 5 to 15 passes over a million points and allocates nothing. Gärtner, "Fast and robust smallest enclosing
/// spheres" (1999). `bounding_sphere_fast` is cheaper.
template <Dim N, class T>
Sphere<N, T> bounding_sphere(std::span<const Vec<N, T>> points) {
  return detail::sphere_around(points, "bounding_sphere",
                               [](const auto& local) { return detail::smallest_sphere_center<N>(local); });
}

/// A sphere that contains the points exactly but is not the smallest: its radius is at most twice the minimum, and was
/// within 1.05 times the minimum in measurements. One point, equal points and errors are as for `bounding_sphere`.
/// Always five passes over the points: the smallest sphere of a few extreme points (Larsson, "Fast and tight fitting
/// bounding spheres", 2008), grown to contain all (Ritter, "An efficient bounding sphere", 1990), then the least radius
/// for its center.
template <Dim N, class T>
Sphere<N, T> bounding_sphere_fast(std::span<const Vec<N, T>> points) {
  return detail::sphere_around(points, "bounding_sphere_fast", [](const detail::LocalPoints<N, T>& local) {
    std::array<Vec<N, double>, 2 * detail::fan_size<N>> few;
    const auto indices = detail::extreme_points(local.points);
    for (std::size_t i = 0; i < few.size(); ++i) few[i] = local[indices[i]];
    const Vec<N, double> center = detail::smallest_sphere_center<N>(few);
    return detail::grown_sphere_center<N>({center, detail::farthest_point(center, few).distance_squared}, local);
  });
}

/// The overload for a vector or a braced list.
template <Dim N, class T>
Sphere<N, T> bounding_sphere(const std::vector<Vec<N, T>>& points) {
  return bounding_sphere(std::span<const Vec<N, T>>(points));
}

/// The overload for a vector or a braced list.
template <Dim N, class T>
Sphere<N, T> bounding_sphere_fast(const std::vector<Vec<N, T>>& points) {
  return bounding_sphere_fast(std::span<const Vec<N, T>>(points));
}

/// The overload for anything that converts to a span of points.
template <PointRow Row>
auto bounding_sphere(const Row& points) {
  return bounding_sphere(span_of(points));
}

/// The overload for anything that converts to a span of points.
template <PointRow Row>
auto bounding_sphere_fast(const Row& points) {
  return bounding_sphere_fast(span_of(points));
}

/// The overload with the dimension given explicitly.
template <Dim N, PointRowIn<N> Row>
auto bounding_sphere(const Row& points) {
  return bounding_sphere(span_of(points));
}

/// The overload with the dimension given explicitly.
template <Dim N, PointRowIn<N> Row>
auto bounding_sphere_fast(const Row& points) {
  return bounding_sphere_fast(span_of(points));
}

}  // namespace graze
