// SPDX-License-Identifier: MIT
// Rays that pass shapes of every type by a few ulp, near zero and far from it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rapidcheck.h>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>

#include "catalogue.hpp"
#include "query/placement.hpp"

namespace graze::test {

template <Dim N>
Vec<N, double> across(const Vec<N, double>& way, rc::Random& random) {
  const Vec<N, double> other = any_way<N>(random);
  return other - way * (dot(other, way) / dot(way, way));
}

/// A point of a shape, a direction in which little of the shape is near it, and a direction past it.
template <Dim N>
struct Passage {
  Vec<N, double> point;
  Vec<N, double> outward;
  Vec<N, double> way;
};

/// The farthest point along a direction, and a perpendicular direction; if there is none, and in half of the cases, the
/// vector between two points, often of one edge.
template <Dim N, class T>
Passage<N> passage_at(const AnyShape<N, T>& shape, rc::Random& random) {
  const Vec<N, double> outward = any_way<N>(random);
  std::optional<Vec<N, double>> farthest;
  if (whole(random, 0, 1) == 0) {
    detail::visit(
        [&](const auto& held) {
          if constexpr (requires { support(held, outward); }) farthest = support(held, outward);
        },
        shape);
  }
  if (farthest) return {*farthest, outward, across<N>(outward, random)};
  const Vec<N, double> point = point_of(shape, random);
  const Vec<N, double> way = point_of(shape, random) - point;
  if (!(max_abs(way) > 0)) return {point, outward, across<N>(outward, random)};
  return {point, across<N>(way, random), way};
}

/// In a property: calls check(shape, ray) for rays past one shape, by 0 to 64 ulp of T or of double.
template <Dim N, class T, class Check>
void for_rays_past_a_shape(const Check& check) {
  rc::Random random(*rc::gen::arbitrary<std::uint64_t>());
  const T far = std::array<T, 5>{0, 0, 100, 65536, 1e6F}[static_cast<std::size_t>(whole(random, 0, 4))];
  Vec<N, T> offset;
  for (Dim i = 0; i < N; ++i) offset[i] = far * static_cast<T>(whole(random, -1, 1));
  const AnyShape<N, T> drawn = *any_shape<N, T>();
  const AnyShape<N, T> shape = far == 0 ? drawn : moved<N, T>(drawn, offset);
  for (int i = 0; i < 8; ++i) {
    const Passage<N> at = passage_at<N, T>(shape, random);
    const double ulp = max_abs(at.point) * std::ldexp(1.0, whole(random, 0, 1) == 0 ? -53 : -24);
    const double size = std::sqrt(dot(at.outward, at.outward));
    if (!(max_abs(at.way) > 0) || !(size > 0)) continue;
    const Vec<N, double> beside = at.point + at.outward * (whole(random, 0, 64) * ulp / size);
    const Vec<N, double> way = at.way * between(random, 0.1, 4);
    const Ray<N, T> ray{Vec<N, T>(beside - way * between(random, 0, 2)), Vec<N, T>(way)};
    if (!is_valid(ray) || !(max_abs(ray.direction) > T(1e-6F))) continue;
    check(shape, ray);
  }
}

/// The segment of a ray up to t = 1.
template <Dim N, class T>
Segment<N, T> beginning_of(const Ray<N, T>& ray) {
  return {ray.origin, ray.origin + ray.direction};
}

}  // namespace graze::test
