// SPDX-License-Identifier: MIT
// A certificate's view of a shape: corners relative to a stored point, with a radius, or a plane; exactly as stored, in
// numbers with error bounds.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact/enclosed.hpp"
#include "exact/numbers.hpp"

namespace graze::test {

enum class BodyForm {
  hull,      ///< The convex hull of corners, inflated by a radius.
  ray,       ///< The convex hull of its origin and all positive multiples of a direction.
  plane,     ///< Where normal . x = offset.
  solid,     ///< Where normal . x <= offset.
  not_seen,  ///< Not supported by certificates.
};

/// Corners are `anchor + corners[i]`: verdicts depend on differences of two bodies, which lose nothing far from the
/// origin.
template <std::size_t N>
struct Body {
  static constexpr std::size_t most_corners = 8;

  BodyForm form = BodyForm::hull;
  EnclosedVec<N> anchor{};
  std::array<EnclosedVec<N>, most_corners> corners{};
  std::size_t count = 0;
  double radius = 0;
  EnclosedVec<N> way{};  ///< A ray's direction; the normal of a plane.
  double offset = 0;     ///< Of a plane.
  /// An upper bound of the coordinates that occur in the calculation of a corner, including the radius.
  double size = 0;
};

/// Converts shapes to bodies; one overload for each type.
template <Dim Dimension, class T>
struct BodyMaker {
  static constexpr std::size_t N = static_cast<std::size_t>(Dimension);
  using V = Vec<Dimension, T>;
  using Made = Body<N>;

  static EnclosedVec<N> stored(const V& v) {
    EnclosedVec<N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = enclosed(static_cast<double>(v[static_cast<Dim>(i)]));
    return result;
  }

  static Made around(const V& anchor, T radius = T(0)) {
    Made body;
    body.anchor = stored(anchor);
    body.radius = static_cast<double>(radius);
    body.size = body.radius;
    return body;
  }

  /// `reach` bounds the numbers from which the corner was calculated.
  static void add(Made& body, const EnclosedVec<N>& corner, double reach = 0) {
    body.corners[body.count++] = corner;
    for (const Enclosed& x : corner) body.size = std::max(body.size, magnitude(x) + body.radius);
    body.size = std::max(body.size, reach);
  }

  static Made hull(std::initializer_list<V> points, T radius = T(0)) {
    Made body = around(*points.begin(), radius);
    for (const V& point : points) add(body, stored(point) - body.anchor);
    return body;
  }

  Made operator()(const V& point) const { return hull({point}); }
  Made operator()(const Segment<Dimension, T>& segment) const { return hull({segment.start, segment.end}); }
  Made operator()(const Sphere<Dimension, T>& sphere) const { return hull({sphere.center}, sphere.radius); }
  Made operator()(const Triangle<Dimension, T>& t) const { return hull({t.a, t.b, t.c}); }
  Made operator()(const Capsule<Dimension, T>& capsule) const { return hull({capsule.a, capsule.b}, capsule.radius); }

  Made operator()(const Ray<Dimension, T>& ray) const {
    Made body = hull({ray.origin});
    body.form = BodyForm::ray;
    body.way = stored(ray.direction);
    return body;
  }

  Made operator()(const Aabb<Dimension, T>& box) const {
    Made body = around(box.min);
    const EnclosedVec<N> extent = stored(box.max) - body.anchor;
    for (unsigned corner = 0; corner < 1U << N; ++corner) {
      EnclosedVec<N> place{};
      for (std::size_t i = 0; i < N; ++i) {
        if ((corner >> i & 1U) != 0) place[i] = extent[i];
      }
      add(body, place);
    }
    return body;
  }

  Made operator()(const Obb<Dimension, T>& box) const {
    Made body = around(box.center);
    std::array<EnclosedVec<N>, N> edges;
    double reach = 0;
    for (std::size_t i = 0; i < N; ++i) {
      const auto axis = static_cast<Dim>(i);
      edges[i] = stored(box.axes[axis]) * enclosed(static_cast<double>(box.half_extents[axis]));
      double longest = 0;
      for (const Enclosed& x : edges[i]) longest = std::max(longest, magnitude(x));
      reach += longest;
    }
    for (unsigned corner = 0; corner < 1U << N; ++corner) {
      EnclosedVec<N> place{};
      for (std::size_t i = 0; i < N; ++i) place = (corner >> i & 1U) != 0 ? place + edges[i] : place - edges[i];
      add(body, place, reach);
    }
    return body;
  }

  Made operator()(const Polytope<Dimension, T>& polytope) const {
    Made body = around(polytope.vertices().front());
    if (polytope.vertices().size() > Made::most_corners) {
      body.form = BodyForm::not_seen;
      return body;
    }
    for (const V& vertex : polytope.vertices()) add(body, stored(vertex) - body.anchor);
    return body;
  }

  Made operator()(const Plane<Dimension, T>& plane) const { return level(plane, BodyForm::plane); }
  Made operator()(const HalfSpace<Dimension, T>& solid) const { return level(solid, BodyForm::solid); }

  template <class Level>
  static Made level(const Level& stored_level, BodyForm form) {
    Made body;
    body.form = form;
    body.way = stored(stored_level.normal);
    body.offset = static_cast<double>(stored_level.offset);
    return body;
  }

  /// Other types are not supported; compounds are split into parts before.
  template <class S>
  Made operator()(const S&) const {
    Made body;
    body.form = BodyForm::not_seen;
    return body;
  }
};

}  // namespace graze::test
