// SPDX-License-Identifier: MIT
// Finds errors of a ray's hit: whether there is one, and how far its point is from the true entry, according to the
// contract of ray_cast.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact/point.hpp"
#include "exact/ray_entry.hpp"
#include "exact/verdict.hpp"
#include "parts_of.hpp"
#include "query/verdict_band.hpp"

namespace graze::test {

/// The signed distance of a point; for compounds that of the nearest part, for planes never negative.
template <Dim N, class T>
double exact_height(const AnyShape<N, T>& shape, const Vec<N, T>& point) {
  if (const auto compound = parts_of<N, T>(shape)) {
    double least = std::numeric_limits<double>::infinity();
    for (const Part<N, T>& part : compound->parts) least = std::min(least, exact_height<N, T>(part.shape, point));
    return least;
  }
  const double height = exact_signed_distance<N, T>(shape, point);
  return std::holds_alternative<Plane<N, T>>(shape) ? std::fabs(height) : height;
}

/// The error of an entry at `t` when the true one is at `entry`: the distance between them or, for a grazing ray, where
/// this is long, the height of the point above the surface or the depth of the ray before it. The points are rounded to
/// T.
template <Dim N, class T>
double entry_error(const AnyShape<N, T>& shape, const Ray<N, T>& ray, double t, double entry) {
  const Vec<N, double> direction = wide<N, T>(ray.direction);
  const double along = std::fabs(t - entry) * length(direction);
  if (!std::isfinite(along)) return std::numeric_limits<double>::infinity();
  if (along == 0) return 0;
  const auto place = [&](double at) { return Vec<N, T>(wide<N, T>(ray.origin) + direction * at); };
  const Vec<N, T> point = place(t);
  if (!is_finite(point)) return along;
  const double height = std::fabs(exact_height<N, T>(shape, point));
  if (t < entry) return std::min(along, height);  // before the entry the ray is nowhere inside
  // The height along the ray is convex, so the depth in between is at most twice the depth in the middle.
  const double depth_between = -2 * exact_height<N, T>(shape, place(0.5 * t + 0.5 * entry));
  return std::min(along, std::max(height, depth_between));
}

/// The error of one answer.
struct RayErrors {
  Judgement judgement = Judgement::right;
  double entry = 0;  ///< In epsilon of T times the largest coordinate of ray, point and shape.
};

/// `truth` with gap and sizes where it differs from the hit, `largest` an upper bound of the coordinates of ray and
/// shape.
template <Dim N, class T>
RayErrors ray_errors(const AnyShape<N, T>& shape, const Ray<N, T>& ray, const ExactVerdict& truth, double largest,
                     const std::optional<RayHit<N, T>>& hit) {
  RayErrors errors;
  const bool is_met = truth.relation != Relation::apart;
  if (is_met != hit.has_value()) {
    const bool underflows = std::fabs(truth.gap) < least_size;
    if (truth.is_nearly_parallel || underflows) {
      errors.judgement = Judgement::outside_range;
      return errors;
    }
    const double size = documented_size(truth.own_size, truth.largest, shape.index(), ray_type);
    const bool is_near = hit && truth.gap <= std::max(verdict_band * size, hit->error);
    errors.judgement = is_near ? Judgement::within_band : Judgement::wrong;
    if (!is_near) return errors;
  }
  if (!hit || !std::isfinite(hit->t) || !is_finite(hit->point)) return errors;
  const auto t = static_cast<double>(hit->t);
  const std::optional<double> entry = is_met ? exact_entry<N, T>(shape, ray) : std::nullopt;
  if (is_met && (!entry || !std::isfinite(*entry))) return errors;
  // A near touch has no entry, but the point is as close to the shape as the error says.
  const double error =
      entry ? entry_error<N, T>(shape, ray, t, *entry) : std::fabs(exact_height<N, T>(shape, hit->point));
  const auto epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
  const Vec<N, double> way = wide<N, T>(ray.direction) * t;
  const double size = std::max({largest, max_abs(way), static_cast<double>(max_abs(hit->point))});
  const double off_ray = length(wide<N, T>(ray.origin) + way - wide<N, T>(hit->point));
  // The point and t are each rounded to T, and so is the point where the height is calculated.
  constexpr double roundings = 4;
  const double bound = hit->error + roundings * epsilon * size + static_cast<double>(std::numeric_limits<T>::min());
  if (!(error <= bound) || !(off_ray <= bound)) errors.judgement = Judgement::wrong;
  errors.entry = error / (epsilon * size);
  return errors;
}

}  // namespace graze::test
