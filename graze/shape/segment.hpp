// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/transformed.hpp>

namespace graze {

/// All points between two ends, both included. Equal ends are valid: the segment is then a point.
template <Dim N, class T = float>
struct Segment {
  Vec<N, T> start = Vec<N, T>(T(0));   ///< First end; t = 0 in ray casts.
  Vec<N, T> end = unit_axis<N, T>(0);  ///< Second end; t = 1 in ray casts.
};

namespace detail {
template <Dim N, class T>
inline constexpr auto description_of<Segment<N, T>> = Description("segment",
                                                                  field::point("start", &Segment<N, T>::start),
                                                                  field::point("end", &Segment<N, T>::end));
}  // namespace detail

/// The end that is farthest along `direction` (any nonzero length), in double; the start if both are equally far.
template <Dim N, class T>
Vec<N, double> support(const Segment<N, T>& segment, const std::type_identity_t<Vec<N, double>>& direction) {
  const Vec<N, double> start = wide<N, T>(segment.start);
  const Vec<N, double> end = wide<N, T>(segment.end);
  return dot(end, direction) > dot(start, direction) ? end : start;
}

/// The squared length, in double. Cheaper than `length`, and enough for comparisons.
template <Dim N, class T>
double length_squared(const Segment<N, T>& segment) {
  const Vec<N, double> edge = wide<N, T>(segment.end) - wide<N, T>(segment.start);
  return dot(edge, edge);
}

/// The length, in double; 0 if the ends are equal. To compare lengths, `length_squared` is cheaper.
template <Dim N, class T>
double length(const Segment<N, T>& segment) {
  return std::sqrt(length_squared(segment));
}

}  // namespace graze
