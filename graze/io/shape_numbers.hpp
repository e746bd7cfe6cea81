// SPDX-License-Identifier: MIT
// Shapes of one number type as shapes of another.
#pragma once

#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>

namespace graze::io {

/// Shapes with every number of theirs changed by `change(number)`, which gives the number of the new type. The boxes of
/// a compound's parts are calculated anew. Throws std::invalid_argument when a polytope's point ceases to be finite.
template <class To, class Change>
class ShapeNumbers {
 public:
  explicit ShapeNumbers(Change change) : change_(std::move(change)) {}

  template <Dim N, class From>
  AnyShape<N, To> operator()(const AnyShape<N, From>& shape) const {
    return detail::visit([this](const auto& held) { return AnyShape<N, To>(this->of(held)); }, shape);
  }

  template <Dim N, class From>
  Vec<N, To> of(const Vec<N, From>& point) const {
    Vec<N, To> changed;
    for (Dim i = 0; i < N; ++i) changed[i] = change_(point[i]);
    return changed;
  }

 private:
  template <Dim N, class From>
  Segment<N, To> of(const Segment<N, From>& segment) const {
    return {of(segment.start), of(segment.end)};
  }
  template <Dim N, class From>
  Ray<N, To> of(const Ray<N, From>& ray) const {
    return {of(ray.origin), of(ray.direction)};
  }
  template <Dim N, class From>
  Sphere<N, To> of(const Sphere<N, From>& sphere) const {
    return {of(sphere.center), change_(sphere.radius)};
  }
  template <Dim N, class From>
  Aabb<N, To> of(const Aabb<N, From>& box) const {
    return {of(box.min), of(box.max)};
  }
  template <Dim N, class From>
  Obb<N, To> of(const Obb<N, From>& box) const {
    Mat<N, To> axes;
    for (Dim i = 0; i < N; ++i) axes[i] = of<N, From>(box.axes[i]);
    return {of(box.center), of(box.half_extents), axes};
  }
  template <Dim N, class From>
  Plane<N, To> of(const Plane<N, From>& plane) const {
    return {of(plane.normal), change_(plane.offset)};
  }
  template <Dim N, class From>
  HalfSpace<N, To> of(const HalfSpace<N, From>& solid) const {
    return {of(solid.normal), change_(solid.offset)};
  }
  template <Dim N, class From>
  Triangle<N, To> of(const Triangle<N, From>& triangle) const {
    return {of(triangle.a), of(triangle.b), of(triangle.c)};
  }
  template <Dim N, class From>
  Capsule<N, To> of(const Capsule<N, From>& capsule) const {
    return {of(capsule.a), of(capsule.b), change_(capsule.radius)};
  }
  template <Dim N, class From>
  Polytope<N, To> of(const Polytope<N, From>& polytope) const {
    std::vector<Vec<N, To>> points;
    for (const Vec<N, From>& vertex : polytope.vertices()) points.push_back(of(vertex));
    return convex_hull_in_order<N, To>(points);
  }
  template <Dim N, class From>
  Compound<N, To> of(const Compound<N, From>& compound) const {
    std::vector<AnyShape<N, To>> parts;
    for (const Part<N, From>& part : compound.parts) parts.push_back((*this)(part.shape));
    return compound_of<N, To>(std::move(parts));
  }

  Change change_;
};

/// A shape with its numbers rounded to another type: exactly the same shape where that type is the larger one.
template <class To, Dim N, class From>
AnyShape<N, To> with_numbers(const AnyShape<N, From>& shape) {
  if constexpr (std::is_same_v<To, From>) {
    return shape;
  } else {
    const auto round = [](From number) { return static_cast<To>(number); };
    return ShapeNumbers<To, decltype(round)>(round)(shape);
  }
}

}  // namespace graze::io
