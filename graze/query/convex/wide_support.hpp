// SPDX-License-Identifier: MIT
// The common form of convex shapes for queries: a core that has corners, inflated by a radius, always in double.
#pragma once

#include <algorithm>

#include <graze/math/exact/twofold.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/posed.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::detail {

/// The support point in double. A shape that calculates in float gets a direction of moderate length.
template <Convex S>
Vec<dimension_of<S>, double> wide_support(const S& shape, const Vec<dimension_of<S>, double>& direction) {
  constexpr Dim N = dimension_of<S>;
  if constexpr (SupportsIn<S, N, double>) {
    return support(shape, direction);
  } else {
    using T = scalar_of<S>;
    return wide<N, T>(support(shape, Vec<N, T>(direction / max_abs(direction))));  // queries never pass zero
  }
}

/// The error of a shape's support points, relative to the largest coordinate.
template <Convex S>
inline constexpr double support_error =
    SupportsIn<S, dimension_of<S>, double> ? tolerance::convex : tolerance::convex_in<scalar_of<S>>;

/// A number from which support points are calculated, and that may be larger than they are: a corner of a distant box
/// may be near zero.
template <Convex S>
double largest_within(const S&) {
  return 0;
}
template <Dim N, class T>
double largest_within(const Obb<N, T>& box) {
  return static_cast<double>(max_abs(box.center));
}

// A round shape is its core inflated by a radius: GJK is exact on cores in finitely many steps, but never on round
// surfaces.

template <Convex S>
const S& core(const S& shape) {
  return shape;
}

template <Convex S>
double core_radius(const S&) {
  return 0;
}

template <Dim N, class T>
Vec<N, T> core(const Sphere<N, T>& sphere) {
  return sphere.center;
}

template <Dim N, class T>
double core_radius(const Sphere<N, T>& sphere) {
  return static_cast<double>(sphere.radius);
}

template <Dim N, class T>
Segment<N, T> core(const Capsule<N, T>& capsule) {
  return axis(capsule);
}

template <Dim N, class T>
double core_radius(const Capsule<N, T>& capsule) {
  return static_cast<double>(capsule.radius);
}

template <Dim N, class T>
Posed<Vec<N, T>> core(const Posed<Sphere<N, T>>& posed) {
  return {posed.shape.center, posed.pose};
}

template <Dim N, class T>
double core_radius(const Posed<Sphere<N, T>>& posed) {
  return core_radius(posed.shape);
}

template <Dim N, class T>
Posed<Segment<N, T>> core(const Posed<Capsule<N, T>>& posed) {
  return {axis(posed.shape), posed.pose};
}

template <Dim N, class T>
double core_radius(const Posed<Capsule<N, T>>& posed) {
  return core_radius(posed.shape);
}

/// A Minkowski difference whose shapes' types are hidden, for searches that are long and rare: they are compiled once
/// for each dimension instead of once for each pair of types.
template <Dim N>
class AnyDifference {
 public:
  virtual Vec<N, double> support(const Vec<N, double>& direction) = 0;
  virtual double resolution() const = 0;

  /// A support point before rounding, as far as the set remembers what it was made from.
  virtual TwofoldVec<N> exact(const Vec<N, double>& difference) const {
    return twofold_difference(difference, Vec<N, double>(0.0));
  }

 protected:
  ~AnyDifference() = default;
};

/// The Minkowski difference a - b of two convex shapes, accessed through its support function.
template <Convex A, Convex B>
class Difference final : public AnyDifference<dimension_of<A>> {
 public:
  static constexpr Dim dimension = dimension_of<A>;
  using Point = Vec<dimension, double>;

  Difference(const A& a, const B& b) : a_(a), b_(b), largest_(std::max(largest_within(a), largest_within(b))) {}

  /// Records the largest coordinate: the rounding of the difference is relative to it.
  Point support(const Point& direction) override {
    const Point on_a = wide_support(a_, direction);
    const Point on_b = wide_support(b_, -direction);
    largest_ = std::max({largest_, max_abs(on_a), max_abs(on_b)});
    return on_a - on_b;
  }

  /// The resolution: smaller distances cannot be distinguished from zero.
  double resolution() const override { return std::max(support_error<A>, support_error<B>) * largest_; }

 private:
  const A& a_;
  const B& b_;
  double largest_;
};

}  // namespace graze::detail
