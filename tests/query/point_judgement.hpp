// SPDX-License-Identifier: MIT
// The permitted errors of point queries, as documented in contains.hpp, closest_point.hpp, closest_boundary_point.hpp
// and signed_distance.hpp, and the actual ones.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact/kinds.hpp"
#include "exact/point.hpp"
#include "query/placement.hpp"
#include "query/point_answers.hpp"

namespace graze::test {

/// The bounds, in ulp of T: epsilon of T times the largest coordinate of shape, point and answer.
template <class T>
struct PointBounds {
  static constexpr double ulp = static_cast<double>(std::numeric_limits<T>::epsilon());

  /// "A few epsilon": the permitted error of verdicts and depths calculated in double.
  static constexpr double band = 64 * tolerance::epsilon / ulp;

  /// How far outside a point may be that `contains` reports as inside: solids have a band in double, thin shapes and
  /// thin solids the tolerance of T. Such a point's signed distance is zero or as far inside, and the nearest point of
  /// the surface is anywhere within the same distance.
  static constexpr double forgiven = std::max(tolerance::surface<T> / ulp, band);

  static constexpr double distance = band + 4;
  static constexpr double closest = std::max(12.0, band);
  static constexpr double boundary = band + 12;
};

/// A triangle or polytope with this ratio of length to thickness has no corner sharper than about 20 degrees.
inline constexpr double most_blunt = 3;

/// The ratio of length to thickness of the hull of corners; 1 for a compact one, and for one so thin that `contains`
/// takes it for as thick as its tolerance.
template <Dim N, class T>
double slenderness_of(const std::vector<Vec<N, T>>& corners) {
  std::vector<Vec<N, double>> ways;
  double longest = 0;
  double largest = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    largest = std::max(largest, static_cast<double>(max_abs(corners[i])));
    for (std::size_t j = 0; j < i; ++j) {
      ways.push_back(wide<N, T>(corners[i]) - wide<N, T>(corners[j]));
      longest = std::max(longest, std::sqrt(dot(ways.back(), ways.back())));
    }
  }
  double least = longest;
  const auto measure = [&](const Vec<N, double>& normal) {
    const double length = std::sqrt(dot(normal, normal));
    if (!(length > 0)) return;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Vec<N, T>& corner : corners) {
      const double height = dot(wide<N, T>(corner) - wide<N, T>(corners[0]), normal) / length;
      low = std::min(low, height);
      high = std::max(high, height);
    }
    least = std::min(least, high - low);
  };
  for (std::size_t i = 0; i < ways.size(); ++i) {
    if constexpr (N == 2) {
      measure({-ways[i].y, ways[i].x});
    } else {
      for (std::size_t j = 0; j < i; ++j) measure(cross(ways[i], ways[j]));
    }
  }
  const bool is_blunt = longest <= most_blunt * least || least <= tolerance::surface<T> * largest;
  return is_blunt ? 1 : longest / least;
}

/// The same for shapes; 1 for those without an exception in the contract.
template <class S>
double slenderness(const S&) {
  return 1;
}

template <class T>
double slenderness(const Triangle<2, T>& triangle) {
  return slenderness_of<2, T>({triangle.a, triangle.b, triangle.c});
}

template <Dim N, class T>
double slenderness(const Polytope<N, T>& polytope) {
  return slenderness_of<N, T>({polytope.vertices().begin(), polytope.vertices().end()});
}

/// The largest finite coordinate of shape, point and answer, in units of epsilon.
template <class S, Dim N, class T>
double unit_of(const S& shape, const Vec<N, T>& point, const Vec<N, T>& answer) {
  double largest = std::max(size_of<N, T>({shape, point}), static_cast<double>(max_abs(answer)));
  if constexpr (is_ray<S>) largest = std::max(largest, static_cast<double>(max_abs(shape.origin)));
  return PointBounds<T>::ulp * largest;
}

/// The results, errors in ulp.
struct PointErrors {
  double truth = 0;             ///< The signed distance, in units of length.
  bool is_held_rightly = true;  ///< `contains` misses no point of a solid, and accepts none too far outside.
  double forgiven = 0;          ///< The largest error of answers about a point that is outside and yet contained.
  double distance = 0;          ///< Of the others.
  double closest = 0;
  double boundary = 0;
  double slenderness = 1;  ///< Two errors may be this many times larger: those of `closest` and of `boundary`.

  template <class T>
  bool are_within_bounds() const {
    using Bounds = PointBounds<T>;
    return is_held_rightly && forgiven <= Bounds::forgiven + Bounds::distance && distance <= Bounds::distance &&
           closest <= Bounds::closest * slenderness && boundary <= Bounds::boundary * slenderness;
  }
};

/// The errors of the answers about one point of a shape that is not a compound.
template <class S, Dim N, class T>
PointErrors point_errors(const S& shape, const Vec<N, T>& point, const PointAnswers<N, T>& given) {
  constexpr bool is_plane = std::is_same_v<S, Plane<N, T>>;
  PointErrors errors;
  errors.truth = exact_signed_distance<N, T>(shape, point);
  const double outside = is_plane ? std::fabs(errors.truth) : errors.truth;
  const double unit = unit_of(shape, point, given.boundary);
  if (!given.contained) errors.is_held_rightly = outside > 0;
  if (unit == 0) return errors;
  if (given.contained) errors.is_held_rightly = outside <= PointBounds<T>::forgiven * unit;
  errors.slenderness = slenderness(shape);
  const double off = std::fabs(static_cast<double>(given.distance) - errors.truth) / unit;
  const double way = exact_distance(point, given.boundary);
  const double boundary = std::fabs(way - std::fabs(errors.truth)) / unit;
  if (given.contained && errors.truth > 0) {
    errors.forgiven = off;
  } else {
    errors.distance = off;
  }
  errors.boundary = boundary;
  if (errors.truth > 0 && given.closest != point) {
    errors.closest = exact_miss<N, T>(shape, point, given.closest) / unit;
  }
  return errors;
}

}  // namespace graze::test
