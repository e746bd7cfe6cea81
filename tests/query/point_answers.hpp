// SPDX-License-Identifier: MIT
// All point queries at once, for any shape: compiled by point_answers.cpp.in, because a dozen types of shapes take long
// to compile.
#pragma once

#include <graze/math/vec.hpp>
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
PointAnswers<N, T> answers(const AnyShape<N, T>& shape, const Vec<N, T>& point);

}  // namespace graze::test
