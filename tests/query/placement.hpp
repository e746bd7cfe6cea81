// SPDX-License-Identifier: MIT
// Places two shapes where verdicts are difficult: together, or at a distance where they just touch.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/visit.hpp>

#include "catalogue.hpp"
#include "parts_of.hpp"

namespace graze::test {

// ---- moved(shape, offset): the same shape elsewhere, up to rounding; it keeps its type.

template <Dim N, class T>
AnyShape<N, T> moved(AnyShape<N, T> shape, const Vec<N, T>& offset) {
  if (const auto* polytope = std::get_if<Polytope<N, T>>(&shape)) {
    std::vector<Vec<N, T>> points;
    for (const Vec<N, T>& vertex : polytope->vertices()) points.push_back(vertex + offset);
    return convex_hull<N, T>(points);
  }
  if (const auto* compound = std::get_if<Compound<N, T>>(&shape)) {
    std::vector<AnyShape<N, T>> parts;
    for (const Part<N, T>& part : compound->parts) parts.push_back(moved<N, T>(part.shape, offset));
    return compound_of<N, T>(std::move(parts));
  }
  if (const auto* mesh = std::get_if<Mesh<N, T>>(&shape)) {
    return with_vertices_changed(*mesh, [&offset](const Vec<N, T>& vertex) { return vertex + offset; });
  }
  const auto move = [&offset](auto& held) {
    detail::for_each_field(held, [&]<class Field>(const Field&, auto& value) {
      if constexpr (Field::kind == detail::FieldKind::point) value += offset;
    });
    if constexpr (requires { held.normal; }) held.offset += dot(held.normal, offset);
  };
  detail::visit(move, shape);
  return shape;
}

// ---- A point of a shape, often on its surface, an edge or a corner, up to rounding.

/// A number in a range: in half of the cases one of its ends or the middle.
inline double share(rc::Random& random, double low, double high) {
  const double choice = whole(random, 0, 5);
  if (choice == 0) return low;
  if (choice == 1) return high;
  return choice == 2 ? low * 0.5 + high * 0.5 : between(random, low, high);
}

template <Dim N>
Vec<N, double> any_way(rc::Random& random) {
  while (true) {
    Vec<N, double> way;
    for (Dim i = 0; i < N; ++i) way[i] = share(random, -1, 1);
    if (max_abs(way) > 0) return way / std::sqrt(dot(way, way));
  }
}

template <Dim N, class T>
struct PointOf {
  using Point = Vec<N, double>;
  rc::Random& random;

  Point mix(std::vector<Point> corners) const {
    Point point = corners[0];
    for (const Point& corner : corners) point += (corner - point) * share(random, 0, 1);
    return point;
  }
  Point operator()(const Vec<N, T>& point) const { return wide<N, T>(point); }
  Point operator()(const Segment<N, T>& s) const { return mix({wide<N, T>(s.start), wide<N, T>(s.end)}); }
  Point operator()(const Ray<N, T>& ray) const {
    return wide<N, T>(ray.origin) + wide<N, T>(ray.direction) * share(random, 0, 2);
  }
  Point operator()(const Sphere<N, T>& sphere) const {
    return wide<N, T>(sphere.center) + any_way<N>(random) * (static_cast<double>(sphere.radius) * share(random, 0, 1));
  }
  Point operator()(const Aabb<N, T>& box) const {
    Point point;
    for (Dim i = 0; i < N; ++i) {
      point[i] = share(random, static_cast<double>(box.min[i]), static_cast<double>(box.max[i]));
    }
    return point;
  }
  Point operator()(const Obb<N, T>& box) const {
    Point point = wide<N, T>(box.center);
    const Mat<N, double> edges = half_edges(box);
    for (Dim i = 0; i < N; ++i) point += edges[i] * share(random, -1, 1);
    return point;
  }
  Point operator()(const Plane<N, T>& plane) const {
    const Point normal = wide<N, T>(plane.normal);
    const Point closest = normal * (static_cast<double>(plane.offset) / dot(normal, normal));
    const Point way = any_way<N>(random);
    return closest + way - normal * (dot(way, normal) / dot(normal, normal));
  }
  Point operator()(const HalfSpace<N, T>& solid) const {
    return (*this)(boundary(solid)) - wide<N, T>(solid.normal) * share(random, 0, 1);
  }
  Point operator()(const Triangle<N, T>& t) const { return mix({wide<N, T>(t.a), wide<N, T>(t.b), wide<N, T>(t.c)}); }
  Point operator()(const Capsule<N, T>& capsule) const {
    return (*this)(axis(capsule)) + any_way<N>(random) * (static_cast<double>(capsule.radius) * share(random, 0, 1));
  }
  /// For other shapes, the catalogue provides one.
  template <class S>
  Point operator()(const S& shape) const {
    Point place;
    for (Dim i = 0; i < N; ++i) place[i] = share(random, -1, 1);
    return Entry<S>::point_in(shape, place);
  }
  Point operator()(const Polytope<N, T>& polytope) const {
    std::vector<Point> corners;
    for (const Vec<N, T>& vertex : polytope.vertices()) corners.push_back(wide<N, T>(vertex));
    return mix(corners);
  }
  /// Of the first face, likewise.
  Point operator()(const Mesh<N, T>& mesh) const {
    return mesh.faces().empty() ? Point(0.0) : (*this)(mesh.triangle(0));
  }
  /// Of the first part; the origin if there is none.
  Point operator()(const Compound<N, T>& compound) const {
    return compound.parts.empty() ? Point(0.0) : detail::visit(*this, compound.parts.front().shape);
  }
};

template <Dim N, class T>
Vec<N, double> point_of(const AnyShape<N, T>& shape, rc::Random& random) {
  return detail::visit(PointOf<N, T>{random}, shape);
}

/// b moved so that a point of it lies on a point of a.
template <Dim N, class T>
AnyPair<N, T> placed_together(const AnyPair<N, T>& pair, rc::Random& random) {
  const Vec<N, double> on_a = point_of(pair.first, random);
  const Vec<N, double> on_b = point_of(pair.second, random);
  return {pair.first, moved<N, T>(pair.second, Vec<N, T>(on_a - on_b))};
}

/// The largest finite coordinate of the shapes' bounds.
template <Dim N, class T>
double size_of(const AnyPair<N, T>& pair) {
  double size = 0;
  for (const Aabb<N, T>& box : {bounds(pair.first), bounds(pair.second)}) {
    for (const Vec<N, T>& corner : {box.min, box.max}) {
      for (Dim i = 0; i < N; ++i) {
        if (std::isfinite(corner[i])) size = std::max(size, std::fabs(static_cast<double>(corner[i])));
      }
    }
  }
  return size;
}

/// The last position of b along a path at which `meet(a, b)` is true, and the first at which it is false, found by
/// bisection down to neighbouring numbers; then positions farther inward, where the band of rounding ends. Only the
/// pair itself if they do not meet, or never separate.
template <Dim N, class T, class Meet>
std::vector<AnyPair<N, T>> at_the_border(const AnyPair<N, T>& pair, const Vec<N, double>& way, const Meet& meet) {
  const auto at = [&](double t) { return AnyPair<N, T>{pair.first, moved<N, T>(pair.second, Vec<N, T>(way * t))}; };
  double inside = 0;
  double outside = 1;
  while (outside < 1e9 && meet(at(outside))) outside *= 4;
  if (!meet(pair) || meet(at(outside))) return {pair};
  while (true) {
    const double middle = 0.5 * (inside + outside);
    if (middle <= inside || middle >= outside) break;
    (meet(at(middle)) ? inside : outside) = middle;
  }
  const double ulp = std::numeric_limits<double>::epsilon() * size_of(at(inside));
  return {at(inside), at(outside), at(inside - 20 * ulp), at(inside - 200 * ulp)};
}

}  // namespace graze::test
