// SPDX-License-Identifier: MIT
// All point queries at once, for any shape.
#pragma once

#include <graze/math/vec.hpp>
#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test {

template <Dim N, class T>
struct PointAnswers {
  bool contained;
  Vec<N, T> closest;
  Vec<N, T> boundary;
  T distance;
};

template <Dim N, class T>
PointAnswers<N, T> answers(const AnyShape<N, T>& shape, const Vec<N, T>& point) {
  return {contains(shape, point), closest_point(shape, point), closest_boundary_point(shape, point),
          signed_distance(shape, point)};
}

}  // namespace graze::test
