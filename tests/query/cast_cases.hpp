// SPDX-License-Identifier: MIT
// Random casts, which often graze a corner or end at one, and the exact gap at any time of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/converted.hpp>
#include <graze/shape/fields/visit.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "parts_of.hpp"
#include "query/numbers_of.hpp"
#include "query/placement.hpp"

namespace graze::test {

/// The same shape in double, exactly.
template <Dim N, class T>
struct Widener {
  using Any = AnyShape<N, double>;

  template <template <Dim, class> class S>
  Any operator()(const S<N, T>& shape) const {
    return detail::widened(shape);
  }
  Any operator()(const Vec<N, T>& point) const { return wide<N, T>(point); }
  Any operator()(const Polytope<N, T>& polytope) const {
    std::vector<Vec<N, double>> points;
    for (const Vec<N, T>& vertex : polytope.vertices()) points.push_back(wide<N, T>(vertex));
    return convex_hull<N, double>(points);
  }
  Any operator()(const Mesh<N, T>& mesh) const {
    std::vector<Vec<N, double>> vertices;
    for (const Vec<N, T>& vertex : mesh.vertices()) vertices.push_back(wide<N, T>(vertex));
    return mesh_of<N, double>(vertices, mesh.faces(), mesh.kind());
  }
  Any operator()(const Compound<N, T>& compound) const {
    std::vector<Any> parts;
    for (const Part<N, T>& part : compound.parts) parts.push_back(detail::visit(*this, part.shape));
    return compound_of<N, double>(std::move(parts));
  }
};

/// For a fixture to inherit.
template <class SpaceType>
class CastCases {
 public:
  static constexpr Dim dimension = SpaceType::dimension;
  using Number = typename SpaceType::scalar;
  using Any = AnyShape<dimension, Number>;
  using Point = Vec<dimension, Number>;

  struct Case {
    Any a;
    Point motion;
    Any b;
  };

  /// In three of four cases a point of a, often of an edge or a corner, is aimed at one of b, and reaches it in the
  /// middle of the motion or at its end.
  static Case draw_case() {
    auto [a, b] = *any_pair<Any, Any>();
    Point motion = *any<Point>();
    const std::uint64_t seed = *choice(std::size_t{1} << 31U);
    rc::Random random(seed);
    const Vec<dimension, double> between = point_of(b, random) - point_of(a, random);
    if (seed % 4 != 0 && is_finite(between)) motion = Point(between * (seed % 4 == 1 ? 1.0 : 2.0));
    RC_LOG() << "(" << to_source<dimension, Number>(a) << ", " << to_source<dimension, Number>(Any(motion)) << ", "
             << to_source<dimension, Number>(b) << ")\n";
    return {std::move(a), motion, std::move(b)};
  }

  /// The largest coordinate of a shape, or of any of its parts.
  static double extent(const Any& shape) {
    double largest = size_of<dimension, Number>({shape, shape});
    if (const auto compound = parts_of<dimension, Number>(shape)) {
      for (const auto& part : compound->parts) largest = std::max(largest, extent(part.shape));
    }
    return largest;
  }

  /// The largest coordinate during the motion.
  static double size(const Case& drawn) {
    return std::max(extent(drawn.a), extent(drawn.b)) + static_cast<double>(sum_abs(drawn.motion));
  }

  /// The exact gap at t, negative if there is depth, up to the rounding of the position. Zero for unbounded shapes that
  /// rounding cannot distinguish from parallel ones, whatever they do far away.
  static double gap_at(const Case& drawn, double t) {
    const ExactVerdict verdict = verdict_at(drawn, t);
    return verdict.is_nearly_parallel ? 0 : verdict.gap;
  }

  static ExactVerdict verdict_at(const Case& drawn, double t) {
    const auto wide_a = detail::visit(Widener<dimension, Number>(), drawn.a);
    const auto wide_b = detail::visit(Widener<dimension, Number>(), drawn.b);
    const auto there = moved<dimension, double>(wide_a, wide<dimension, Number>(drawn.motion) * t);
    return exact_verdict<dimension, double>(there, wide_b, Measure::depth);
  }

  /// The effect of rounding the first shape's position on the gap.
  static double place_error(const Case& drawn) { return 32 * tolerance::epsilon * size(drawn); }
};

}  // namespace graze::test
