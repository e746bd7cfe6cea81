// SPDX-License-Identifier: MIT
// The gap of two moving and rotating shapes at any time: the oracle's, for their positions rounded to double; and the
// minimum found until then.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <graze/math/motion.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/converted.hpp>
#include <graze/shape/fields/visit.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "parts_of.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"
#include "query/times_of_impact.hpp"

namespace graze::test {

/// A shape moved by a motion until t, up to rounding.
template <Dim N, class T>
AnyShape<N, double> place_at(const AnyShape<N, T>& shape, const Motion<N, T>& motion, double t) {
  using InDouble = AnyShape<N, double>;
  const Pose<N, double> pose = pose_at(motion, t);
  return detail::visit(
      [&](const auto& held) -> InDouble {
        using S = std::decay_t<decltype(held)>;
        if constexpr (std::is_same_v<S, Polytope<N, T>>) {
          std::vector<Vec<N, double>> points;
          for (const Vec<N, T>& vertex : held.vertices()) points.push_back(wide<N, T>(vertex));
          return transformed(convex_hull<N, double>(points), pose);
        } else if constexpr (std::is_same_v<S, Vec<N, T>>) {
          return transformed(wide<N, T>(held), pose);
        } else if constexpr (std::is_same_v<S, Compound<N, T>> || std::is_same_v<S, Mesh<N, T>>) {
          std::vector<InDouble> parts;
          const auto whole = parts_of<N, T>(shape);
          for (const auto& part : whole->parts) parts.push_back(place_at<N, T>(part.shape, motion, t));
          return compound_of<N, double>(std::move(parts));
        } else {
          return transformed(detail::widened(held), pose);
        }
      },
      shape);
}

/// The largest coordinate of a shape, or of any of its parts.
template <Dim N, class T>
double extent_of(const AnyShape<N, T>& shape) {
  double largest = size_of<N, T>({shape, shape});
  if (const auto compound = parts_of<N, T>(shape)) {
    for (const auto& part : compound->parts) largest = std::max(largest, extent_of<N, T>(part.shape));
  }
  return largest;
}

/// An upper bound of all coordinates during the motion. Far from the origin, poses are rounded by epsilon of that, and
/// of every rotation.
template <Dim N, class T>
double size_of_way(const Moving<N, T>& moving) {
  const auto of_motion = [](const Motion<N, T>& motion) {
    return static_cast<double>(sum_abs(motion.linear)) + 4 * static_cast<double>(sum_abs(motion.center));
  };
  return 4 * std::max(extent_of<N, T>(moving.a), extent_of<N, T>(moving.b)) + of_motion(moving.motion_a) +
         of_motion(moving.motion_b);
}

/// The error of `gap_at`.
template <Dim N, class T>
double rounding_of_way(const Moving<N, T>& moving) {
  return 64 * tolerance::epsilon * size_of_way(moving);
}

/// The exact gap at t, up to the rounding of both poses. Zero for unbounded shapes that rounding cannot distinguish
/// from parallel ones, whatever they do far away.
template <Dim N, class T>
double gap_at(const Moving<N, T>& moving, double t) {
  const ExactVerdict verdict = exact_verdict<N, double>(place_at<N, T>(moving.a, moving.motion_a, t),
                                                        place_at<N, T>(moving.b, moving.motion_b, t), Measure::depth);
  return verdict.is_nearly_parallel ? 0 : verdict.gap;
}

/// The least gap found between two times: at a few samples, then around the nearest of these, by golden-section search.
template <Dim N, class T>
double least_gap(const Moving<N, T>& moving, double from, double to) {
  constexpr std::size_t places = 13;
  const auto time = [&](std::size_t i) { return from + (to - from) * static_cast<double>(i) / (places - 1); };
  std::array<double, places> gaps;
  for (std::size_t i = 0; i < places; ++i) gaps[i] = gap_at(moving, time(i));
  const auto nearest = static_cast<std::size_t>(std::min_element(gaps.begin(), gaps.end()) - gaps.begin());
  double least = gaps[nearest];
  constexpr double golden = 0.6180339887498949;
  double low = time(nearest == 0 ? 0 : nearest - 1);
  double high = time(std::min(nearest + 1, places - 1));
  for (int step = 0; step < 8; ++step) {
    const double left = high - golden * (high - low);
    const double right = low + golden * (high - low);
    const double gap_left = gap_at(moving, left);
    const double gap_right = gap_at(moving, right);
    least = std::min({least, gap_left, gap_right});
    (gap_left < gap_right ? high : low) = gap_left < gap_right ? right : left;
  }
  return least;
}

}  // namespace graze::test
