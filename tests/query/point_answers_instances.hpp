// SPDX-License-Identifier: MIT
// The definition behind point_answers.hpp, for the files that instantiate it.
#pragma once

#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/signed_distance.hpp>

#include "query/point_answers.hpp"

namespace graze::test {

template <Dim N, class T>
PointAnswers<N, T> answers(const AnyShape<N, T>& shape, const Vec<N, T>& point) {
  return {contains(shape, point), closest_point(shape, point), closest_boundary_point(shape, point),
          signed_distance(shape, point)};
}

}  // namespace graze::test
