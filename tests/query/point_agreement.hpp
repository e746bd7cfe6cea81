// SPDX-License-Identifier: MIT
// Point queries of one shape against the exact oracle, and how far off they
// were at worst.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <type_traits>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/signed_distance.hpp>

#include "catalogue.hpp"
#include "exact/point.hpp"
#include "query/points.hpp"

namespace graze::test {

/// In units of epsilon of T times the largest coordinate of shape, point and
/// answer.
struct WorstErrors {
  double distance = 0;
  double closest = 0;
  double boundary = 0;
};

template <Dim N, class T>
double length_from(const WideVec<N>& from, const Vec<N, T>& to) {
  WideVec<N> off;
  for (std::size_t i = 0; i < N; ++i) off[i] = from[i] - Wide(static_cast<double>(to[static_cast<Dim>(i)]));
  return static_cast<double>(sqrt(dot(off, off)));
}

/// The sine of the sharpest corner, 1 for shapes without corners: how much
/// closer than thick their sides run.
template <class S>
double sharpest_corner(const S&) {
  return 1;
}

template <class T>
double sharpest_corner_of(const std::vector<Vec<2, T>>& corners) {
  double least = 1;
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec<2, double> first = wide<2, T>(corners[(i + 1) % count]) - wide<2, T>(corners[i]);
    const Vec<2, double> second = wide<2, T>(corners[(i + count - 1) % count]) - wide<2, T>(corners[i]);
    const double lengths = std::sqrt(dot(first, first) * dot(second, second));
    least = std::min(least, std::fabs(cross_2d<double>(first, second)) / lengths);
  }
  return least;
}

template <class T>
double sharpest_corner(const Triangle<2, T>& triangle) {
  return sharpest_corner_of<T>({triangle.a, triangle.b, triangle.c});
}

template <class T>
double sharpest_corner(const Polytope<2, T>& polygon) {
  return sharpest_corner_of<T>({polygon.vertices().begin(), polygon.vertices().end()});
}

/// The largest finite coordinate of shape, point and answer, in units of
/// epsilon.
template <class S, Dim N, class T>
double unit_of(const S& shape, const Vec<N, T>& point, const Vec<N, T>& answer) {
  double largest = std::max(size_of<N, T>({shape, point}), static_cast<double>(max_abs(answer)));
  if constexpr (is_ray<S>) largest = std::max(largest, static_cast<double>(max_abs(shape.origin)));
  return static_cast<double>(std::numeric_limits<T>::epsilon()) * largest;
}

template <class S, Dim N, class T>
void expect_exact_answers(const S& shape, const Vec<N, T>& point, WorstErrors& worst) {
  const bool contained = contains(shape, point);
  const Vec<N, T> closest = closest_point(shape, point);
  const Vec<N, T> boundary = closest_boundary_point(shape, point);
  const auto distance = static_cast<double>(signed_distance(shape, point));
  const double truth = exact_signed_distance(shape, point);
  const double unit = unit_of(shape, point, boundary);
  // What `contains` forgives: T's tolerance for thin shapes, bands in double
  // for the others.
  const double forgiven = tolerance::surface<T> / static_cast<double>(std::numeric_limits<T>::epsilon());
  const double band = 64 * tolerance::epsilon / static_cast<double>(std::numeric_limits<T>::epsilon());
  RC_ASSERT(contains(shape, closest));
  RC_ASSERT(contains(shape, boundary));
  if (detail::has_inside<S>) RC_ASSERT(contained || truth > 0);
  if (contained && !std::is_same_v<S, Plane<N, T>>) RC_ASSERT(truth <= std::max(forgiven, band) * unit);
  if (unit == 0) return;
  const double distance_error = std::fabs(distance - truth) / unit;
  const double boundary_error =
      std::fabs(length_from<N>(wide_vector<N>(exact(point)), boundary) - std::fabs(truth)) / unit;
  worst.distance = std::max(worst.distance, distance_error);
  const bool is_sharp = sharpest_corner(shape) < 0.3;
  RC_ASSERT(distance_error <= std::max(forgiven, band) + 4);
  RC_ASSERT(is_sharp || boundary_error <= band + 12);
  if (!is_sharp) worst.boundary = std::max(worst.boundary, boundary_error);
  if (truth <= 0 || closest == point) return;
  const double closest_error = length_from<N>(exact_closest_point(shape, point), closest) / unit;
  RC_ASSERT(is_sharp || closest_error <= 12);
  if (!is_sharp) worst.closest = std::max(worst.closest, closest_error);
}

/// Every type but compounds, which are their parts.
template <Dim N, class T>
void expect_exact_answers_of_every_type() {
  std::size_t index = 0;
  for_each_shape_type<N, T>([&]<class S>(std::type_identity<S>) {
    if constexpr (!std::is_same_v<S, Compound<N, T>>) {
      WorstErrors worst;
      check_property([&worst, index] {
        const auto [shape, point] = *shape_and_point<N, T>(index);
        RC_LOG() << to_source<N, T>(shape) << ", " << to_source(point) << "\n";
        expect_exact_answers(std::get<S>(shape), point, worst);
      });
      std::cout << type_source<N, T>(Entry<S>::name) << ": off by at most " << worst.distance << " (distance), "
                << worst.closest << " (closest point), " << worst.boundary << " (boundary point) epsilon\n";
    }
    ++index;
  });
}

}  // namespace graze::test
