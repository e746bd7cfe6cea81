// SPDX-License-Identifier: MIT
// Shapes moved without being turned: unlike under a pose, an axis-aligned box stays one.
#pragma once

#include <utility>
#include <variant>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::wasm {

template <Dim N>
AnyShape<N, double> translated(const AnyShape<N, double>& shape, const Vec<N, double>& offset);

/// Each vector of a shape moved by `offset`, rounded; of planes the offset along their normal.
template <Dim N>
class Translation {
 public:
  using V = Vec<N, double>;
  using Any = AnyShape<N, double>;

  explicit Translation(const V& offset) : by_(offset) {}

  Any operator()(const V& point) const { return V(point + by_); }
  Any operator()(const Segment<N, double>& s) const { return Segment<N, double>{s.start + by_, s.end + by_}; }
  Any operator()(const Ray<N, double>& r) const { return Ray<N, double>{r.origin + by_, r.direction}; }
  Any operator()(const Sphere<N, double>& s) const { return Sphere<N, double>{s.center + by_, s.radius}; }
  Any operator()(const Aabb<N, double>& b) const { return Aabb<N, double>{b.min + by_, b.max + by_}; }
  Any operator()(const Obb<N, double>& b) const { return Obb<N, double>{b.center + by_, b.half_extents, b.axes}; }
  Any operator()(const Plane<N, double>& p) const { return Plane<N, double>{p.normal, p.offset + dot(p.normal, by_)}; }
  Any operator()(const HalfSpace<N, double>& h) const {
    return HalfSpace<N, double>{h.normal, h.offset + dot(h.normal, by_)};
  }
  Any operator()(const Triangle<N, double>& t) const { return Triangle<N, double>{t.a + by_, t.b + by_, t.c + by_}; }
  Any operator()(const Capsule<N, double>& c) const { return Capsule<N, double>{c.a + by_, c.b + by_, c.radius}; }
  Any operator()(const Polytope<N, double>& polytope) const {
    std::vector<V> points(polytope.vertices().begin(), polytope.vertices().end());
    for (V& point : points) point += by_;
    return convex_hull_in_order<N, double>(points);
  }
  Any operator()(const Compound<N, double>& compound) const {
    std::vector<Any> parts;
    parts.reserve(compound.parts.size());
    for (const Part<N, double>& part : compound.parts) parts.push_back(translated<N>(part.shape, by_));
    return compound_of<N, double>(std::move(parts));
  }

 private:
  V by_;
};

template <Dim N>
AnyShape<N, double> translated(const AnyShape<N, double>& shape, const Vec<N, double>& offset) {
  return std::visit(Translation<N>(offset), shape);
}

/// The shape with the center of its box, `box`, at a point; of spheres and oriented boxes the center itself, exactly.
/// The box must be finite.
template <Dim N>
AnyShape<N, double> placed(const AnyShape<N, double>& shape, const Aabb<N, double>& box, const Vec<N, double>& point) {
  if (std::holds_alternative<Vec<N, double>>(shape)) return point;
  if (const auto* const sphere = std::get_if<Sphere<N, double>>(&shape)) {
    return Sphere<N, double>{point, sphere->radius};
  }
  if (const auto* const obb = std::get_if<Obb<N, double>>(&shape)) {
    return Obb<N, double>{point, obb->half_extents, obb->axes};
  }
  return translated<N>(shape, point - box.center());
}

}  // namespace graze::wasm
