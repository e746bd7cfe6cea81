// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string_view>
#include <type_traits>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>

namespace graze {

/// The straight line between two points, both included. Equal ends are valid: the segment is a point.
template <Dim N, class T = float>
struct Segment {
  Vec<N, T> start = Vec<N, T>(T(0));
  Vec<N, T> end = unit_axis<N, T>(0);
};

template <Dim N, class T>
std::string_view defect(const Segment<N, T>& segment) {
  if (!is_finite(segment.start)) return "has a start that is not finite";
  if (!is_finite(segment.end)) return "has an end that is not finite";
  return "";
}

template <Dim N, class T>
Vec<N, double> support(const Segment<N, T>& segment, const std::type_identity_t<Vec<N, double>>& direction) {
  const Vec<N, double> start = wide<N, T>(segment.start);
  const Vec<N, double> end = wide<N, T>(segment.end);
  return dot(end, direction) > dot(start, direction) ? end : start;
}

template <Dim N, class T>
Segment<N, T> transformed(const Segment<N, T>& segment, const Pose<N, T>& pose) {
  return {transformed(segment.start, pose), transformed(segment.end, pose)};
}

/// The squared length: the cheaper sibling of `length`, enough for comparisons.
template <Dim N, class T>
double length_squared(const Segment<N, T>& segment) {
  const Vec<N, double> edge = wide<N, T>(segment.end) - wide<N, T>(segment.start);
  return dot(edge, edge);
}

template <Dim N, class T>
double length(const Segment<N, T>& segment) {
  return std::sqrt(length_squared(segment));
}

}  // namespace graze
