// SPDX-License-Identifier: MIT
// A filter for two segments, widened or not: decides all pairs that neither nearly touch nor are nearly parallel, and
// leaves those to the precise closed forms of bounded.hpp. No answer means "too close to tell".
#pragma once

#include <algorithm>
#include <optional>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/segment.hpp>

namespace graze::detail {

/// The verdict on two segments, widened by `reach` in all. With p(s) = start_a + s u, q(t) = start_b + t v and
/// w = start_b - start_a, the lines are nearest where s det = u.w v.v - v.w u.v, det = u.u v.v - (u.v)^2; clamped one
/// after the other (Ericson, Real-Time Collision Detection, 2005, 5.1.9). The lines are at least 7 degrees from
/// parallel, so that det is no smaller than 1/64 of its terms, and the distance is known to a few hundred epsilon of
/// the size.
template <Dim N, class T>
std::optional<Relation> filter_of_segments(const Segment<N, T>& a, const Segment<N, T>& b, double reach) {
  constexpr double least_sine_squared = 1.0 / 64;
  const Vec<N, double> u = wide<N, T>(a.end) - wide<N, T>(a.start);
  const Vec<N, double> v = wide<N, T>(b.end) - wide<N, T>(b.start);
  const Vec<N, double> w = wide<N, T>(b.start) - wide<N, T>(a.start);
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  const double uv = dot(u, v);
  const double uw = dot(u, w);
  const double vw = dot(v, w);
  const double det = uu * vv - uv * uv;
  if (!(det > least_sine_squared * (uu * vv))) return std::nullopt;  // so uu, vv and det are not zero
  const double slack = tolerance::segment_filter * (sum_abs(u) + sum_abs(v) + sum_abs(w) + reach);
  if (!is_usual_error<T>(slack)) return std::nullopt;
  const double on_line_a = (uw * vv - vw * uv) / det;
  const double on_line_b = (uw * uv - vw * uu) / det;
  if constexpr (N == 2) {
    const auto is_inside = [slack](double place, double whole_squared) {
      const double to_end = std::max(0.0, std::min(place, 1 - place));
      return to_end * to_end * whole_squared > slack * slack;
    };
    if (is_inside(on_line_a, uu) && is_inside(on_line_b, vv)) return Relation::overlapping;
  }
  double s = std::clamp(on_line_a, 0.0, 1.0);
  const double t = (uv * s - vw) / vv;
  const double on_b = std::clamp(t, 0.0, 1.0);
  if (on_b != t) s = std::clamp((uv * on_b + uw) / uu, 0.0, 1.0);
  const Vec<N, double> between = u * s - (v * on_b + w);
  return clear_verdict(dot(between, between), reach, slack);
}

}  // namespace graze::detail
