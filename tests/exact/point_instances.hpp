// SPDX-License-Identifier: MIT
// The definitions behind point.hpp, for the files that instantiate them.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>

#include "exact/difference.hpp"
#include "exact/kinds.hpp"
#include "exact/numbers.hpp"
#include "exact/point.hpp"
#include "exact/solid.hpp"
#include "exact/unbounded.hpp"
#include "exact/verdict_instances.hpp"

namespace graze::test {

template <Dim N>
using WideVec = std::array<Wide, static_cast<std::size_t>(N)>;

template <Dim N>
WideVec<N> wide_vector(const RationalVec<N>& v) {
  WideVec<N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = wide_of(v[i]);
  return result;
}

/// The nearest point of a convex solid that does not contain p: that of its core, moved by the radius towards p.
template <Dim N>
WideVec<N> nearest_in(const Solid<N>& solid, const RationalVec<N>& p) {
  const DifferenceSet<N> differences(hull_of<N>({p}), solid);
  const NearestDifference<N> nearest = differences.nearest();
  WideVec<N> off;
  for (std::size_t i = 0; i < N; ++i) off[i] = wide_of(Rational(nearest.sum[i], nearest.weight * differences.unit()));
  const WideVec<N> on_core = wide_vector<N>(p) - off;
  if (solid.radius == 0) return on_core;
  return on_core + off * Wide(wide_of(solid.radius) / sqrt(dot(off, off)));
}

/// The projection to a plane.
template <Dim N>
WideVec<N> closest_on(const ExactLevel<N>& level, const RationalVec<N>& p) {
  const Rational height = dot(level.normal, p) - level.offset;
  return wide_vector<N>(p - level.normal * Rational(height / dot(level.normal, level.normal)));
}

template <class S, Dim N, class T>
double signed_distance_of(const S& shape, const Vec<N, T>& point) {
  if constexpr (std::is_same_v<S, Plane<N, T>>) {
    const ExactLevel<N> plane = level(shape);
    const Wide height = wide_of(dot(plane.normal, exact(point)) - plane.offset);
    return static_cast<double>(height / sqrt(wide_of(dot(plane.normal, plane.normal))));
  } else if constexpr (has_parts<S>) {
    throw std::invalid_argument("query the parts of a compound one by one");
  } else {
    return simple_verdict(point, shape, Measure::depth).gap;
  }
}

template <class S, Dim N, class T>
WideVec<N> closest_point_of(const S& shape, const Vec<N, T>& point) {
  if constexpr (is_plane_or_half_space<S>) {
    return closest_on<N>(level(shape), exact(point));
  } else if constexpr (is_ray<S>) {
    return nearest_in<N>(solid_beside(shape, solid(point)), exact(point));
  } else if constexpr (has_parts<S>) {
    throw std::invalid_argument("query the parts of a compound one by one");
  } else {
    return nearest_in<N>(solid(shape), exact(point));
  }
}

template <Dim N, class T>
double exact_signed_distance(const AnyShape<N, T>& shape, const Vec<N, T>& point) {
  return detail::visit([&](const auto& held) { return signed_distance_of(held, point); }, shape);
}

template <Dim N>
double length_of(const WideVec<N>& v) {
  return static_cast<double>(sqrt(dot(v, v)));
}

template <Dim N, class T>
double exact_distance(const Vec<N, T>& a, const Vec<N, T>& b) {
  return length_of<N>(wide_vector<N>(exact(a) - exact(b)));
}

template <Dim N, class T>
double exact_miss(const AnyShape<N, T>& shape, const Vec<N, T>& point, const Vec<N, T>& given) {
  const WideVec<N> truth = detail::visit([&](const auto& held) { return closest_point_of(held, point); }, shape);
  return length_of<N>(truth - wide_vector<N>(exact(given)));
}

}  // namespace graze::test
