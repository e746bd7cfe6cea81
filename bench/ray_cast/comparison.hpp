// SPDX-License-Identifier: MIT
// Measures how far another library's answers are from graze's.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>

#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/shape/segment.hpp>

#include "../bench/ray_cast/cases.hpp"

namespace graze::ray_bench {

/// Counts the answers that differ by more than a library's tolerance. The difference is the distance by which the
/// shape's surface would have to move for both to be right: if only one hits, how far the ray passes the shape or how
/// deep it is inside; if both hit, the offset of the points across the surface.
class Comparison {
 public:
  /// A share of a library's answers may be off by more.
  explicit Comparison(double tolerance, double share_wrong = 0) : tolerance_(tolerance), share_wrong_(share_wrong) {}

  template <class S, class T, class Theirs>
  void add(const Case<S>& asked, const std::optional<RayHit<dimension_of<S>, T>>& ours,
           const std::optional<Theirs>& theirs) {
    if (ours.has_value() != theirs.has_value()) {
      add_verdict(asked, ours.has_value());
    } else if (ours) {
      const double across = static_cast<double>(dot(asked.ray.direction, ours->normal));
      add_difference(std::fabs(static_cast<double>(theirs->t) - static_cast<double>(ours->t)) * std::fabs(across));
    }
  }

  /// For a library that only tells whether the ray hits.
  template <class S>
  void add(const Case<S>& asked, bool ours, bool theirs) {
    if (ours != theirs) add_verdict(asked, ours);
  }

  /// Prints the result. Returns whether it is within the limits.
  bool report(const std::string& name, std::size_t count) const {
    std::printf("%s: %zu of %zu rays hit for one alone; off by up to %.1e, may be %.1e: %zu are more\n", name.c_str(),
                verdicts_, count, worst_, tolerance_, beyond_);
    return static_cast<double>(beyond_) <= share_wrong_ * static_cast<double>(count);
  }

 private:
  template <class S>
  void add_verdict(const Case<S>& asked, bool is_hit) {
    ++verdicts_;
    constexpr Dim N = dimension_of<S>;
    using T = scalar_of<S>;
    const auto& [origin, direction] = asked.ray;
    const Segment<N, T> path{origin, origin + direction * static_cast<T>(t_max)};
    if (!is_hit) {
      add_difference(static_cast<double>(closest_points(asked.shape, path).distance));
      return;
    }
    const auto touch = contact(asked.shape, path);
    add_difference(touch ? static_cast<double>(touch->depth) : 0);
  }

  void add_difference(double difference) {
    if (!(difference <= tolerance_)) ++beyond_;
    worst_ = std::isnan(difference) ? std::numeric_limits<double>::infinity() : std::max(worst_, difference);
  }

  double tolerance_;
  double share_wrong_;
  std::size_t verdicts_ = 0;
  std::size_t beyond_ = 0;
  double worst_ = 0;
};

}  // namespace graze::ray_bench
