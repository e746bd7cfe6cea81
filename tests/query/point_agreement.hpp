// SPDX-License-Identifier: MIT
// Point queries of one shape against the exact oracle, and their largest errors.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <type_traits>
#include <variant>

#include <gtest/gtest.h>

#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/signed_distance.hpp>

#include "catalogue.hpp"
#include "query/point_answers.hpp"
#include "query/point_judgement.hpp"
#include "query/points.hpp"

namespace graze::test {

/// In units of epsilon of T times the largest coordinate of shape, point and answer; errors of needles, relative to
/// their slenderness, are separate.
struct WorstErrors {
  double forgiven = 0;
  double distance = 0;
  double closest = 0;
  double boundary = 0;
};

template <class S, Dim N, class T>
void expect_exact_answers(const S& shape, const Vec<N, T>& point, WorstErrors& worst) {
  const PointAnswers<N, T> given{contains(shape, point), closest_point(shape, point),
                                 closest_boundary_point(shape, point), signed_distance(shape, point)};
  RC_ASSERT(contains(shape, given.closest));
  RC_ASSERT(contains(shape, given.boundary));
  const PointErrors errors = point_errors(shape, point, given);
  RC_ASSERT(errors.is_held_rightly);
  RC_ASSERT(errors.forgiven <= PointBounds<T>::forgiven + PointBounds<T>::distance);
  RC_ASSERT(errors.distance <= PointBounds<T>::distance);
  RC_ASSERT(errors.closest <= PointBounds<T>::closest * errors.slenderness);
  RC_ASSERT(errors.boundary <= PointBounds<T>::boundary * errors.slenderness);
  worst.forgiven = std::max(worst.forgiven, errors.forgiven);
  worst.distance = std::max(worst.distance, errors.distance);
  worst.closest = std::max(worst.closest, errors.closest / errors.slenderness);
  worst.boundary = std::max(worst.boundary, errors.boundary / errors.slenderness);
}

/// Every type except compounds and meshes, which are their parts.
template <Dim N, class T>
void expect_exact_answers_of_every_type() {
  std::size_t index = 0;
  for_each_shape_type<N, T>([&]<class S>(std::type_identity<S>) {
    if constexpr (!has_parts<S>) {
      WorstErrors worst;
      check_property([&worst, index] {
        const auto [shape, point] = *shape_and_point<N, T>(index);
        RC_LOG() << to_source<N, T>(shape) << ", " << to_source(point) << "\n";
        expect_exact_answers(std::get<S>(shape), point, worst);
      });
      std::cout << type_source<N, T>(Entry<S>::name) << ": off by at most " << worst.distance << " (distance; "
                << worst.forgiven << " of what is forgiven), " << worst.closest << " (closest point), "
                << worst.boundary << " (boundary point) epsilon\n";
    }
    ++index;
  });
}

}  // namespace graze::test
