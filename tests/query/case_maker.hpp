// SPDX-License-Identifier: MIT
// An unlimited supply of pairs of shapes with difficult verdicts: eight kinds of cases for any two types, the same ones
// for the same seed.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <rapidcheck.h>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "query/flush_faces.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"

namespace graze::test {

enum class CaseKind {
  uniform,          ///< -10 to 10.
  grid,             ///< Small integers: exact touching, many coincidences.
  scales,           ///< 1e-6 to 1e6, both signs.
  far,              ///< Within 10 of 1e6.
  shared_points,    ///< Shapes whose corners, centers and ends coincide or are collinear.
  border,           ///< On either side of the position, to the last bit, where graze's verdict changes.
  nearly_parallel,  ///< The same, for edges that are parallel up to 1e-17 to 1e-6 radians (in float: 1e-9 to 1e-5).
  flush_faces,      ///< Faces opposite each other, almost parallel: see FlushFaces.
};
inline constexpr std::size_t case_kind_count = 8;
inline constexpr std::array<std::string_view, case_kind_count> case_kind_names = {
    "uniform", "grid", "scales", "far", "shared points", "border", "nearly parallel", "flush faces"};

/// RapidCheck's generators that call others share one stack among all threads.
inline std::mutex generators_in_use;

/// The value of a generator for a seed.
template <class S>
S value_from(const rc::Gen<S>& generator, const rc::Random& random) {
  const std::lock_guard<std::mutex> lock(generators_in_use);
  return generator(random, 100).value();
}

/// Generates the cases of one pair of types, by their indices in AnyShape.
template <Dim N, class T>
class CaseMaker {
 public:
  using Any = AnyShape<N, T>;
  using Pair = AnyPair<N, T>;

  CaseMaker(std::size_t a, std::size_t b, std::uint64_t seed) : a_(a), b_(b), random_(seed) {}

  /// One case or a few that belong together.
  std::vector<Pair> make(CaseKind kind) {
    rc::Random random = random_.split();
    switch (kind) {
      case CaseKind::uniform:
        return {draw_pair(Kind::uniform)};
      case CaseKind::grid:
        return {draw_pair(Kind::grid)};
      case CaseKind::scales:
        return {draw_pair(Kind::scales)};
      case CaseKind::far:
        return {draw_pair(Kind::far)};
      case CaseKind::shared_points:
        return {sharing_points()};
      case CaseKind::border:
        return border(placed_together<N, T>(draw_from(source_of<N, T>(any_kind(random))), random));
      case CaseKind::nearly_parallel:
        return border(placed_together<N, T>(nearly_parallel(random), random));
      case CaseKind::flush_faces:
        return {FlushFaces<N, T>(random).make(draw_from(source_of<N, T>(Kind::grid)))};
    }
    return {};
  }

 private:
  static Kind any_kind(rc::Random& random) {
    return kinds[static_cast<std::size_t>(whole(random, 0, static_cast<int>(kinds.size()) - 1))];
  }

  Pair draw_from(const Source<N, T>& source) {
    const auto draw = [&](std::size_t type) { return value_from(any_shape_from<N, T>(source, type), random_.split()); };
    Any first = draw(a_);
    return {std::move(first), draw(b_)};
  }

  /// In two of three cases, moved to have a point in common.
  Pair draw_pair(Kind kind) {
    const Pair pair = draw_from(source_of<N, T>(kind));
    rc::Random random = random_.split();
    return whole(random, 0, 2) == 0 ? pair : placed_together<N, T>(pair, random);
  }

  Pair sharing_points() {
    const Source<N, T> source = source_of<N, T>(Kind::uniform);
    const Vec<N, T> p = value_from(source.point, random_.split());
    const Vec<N, T> q = value_from(source.point, random_.split());
    return draw_from(sharing<N, T>(source, p, q));
  }

  /// Shapes with edges along the axes or diagonals, rotated together, and then one by very little. AABBs are not
  /// rotated.
  Pair nearly_parallel(rc::Random& random) {
    const auto [a, b] = draw_from(source_of<N, T>(Kind::grid));
    const double radians = std::pow(10, std::is_same_v<T, float> ? between(random, -9, -5) : between(random, -17, -6));
    const Mat<N, double> little = turn(random, radians * (180 / 3.14159265358979323846));
    const bool has_box = std::holds_alternative<Aabb<N, T>>(a) || std::holds_alternative<Aabb<N, T>>(b);
    const Mat<N, double> both = has_box ? Mat<N, double>(1.0) : turn(random, between(random, -180, 180));
    return {turned(a, both), skewed(turned(b, both * little), random)};
  }

  static Mat<N, double> turn(rc::Random& random, double degrees) {
    if constexpr (N == 2) {
      return rotation_matrix(degrees);
    } else {
      return rotation_matrix(any_way<3>(random), degrees);
    }
  }

  static Any turned(const Any& shape, const Mat<N, double>& rotation) {
    if (std::holds_alternative<Aabb<N, T>>(shape)) return shape;
    return transformed(shape, Pose<N, T>{rounded<N, T>(rotation), Vec<N, T>(T(0))});
  }

  /// In one case of three, a box whose axes are as far from orthonormal as is valid.
  static Any skewed(const Any& shape, rc::Random& random) {
    if (!std::holds_alternative<Obb<N, T>>(shape) || whole(random, 0, 2) != 0) return shape;
    Obb<N, T> box = std::get<Obb<N, T>>(shape);
    for (Dim i = 0; i < N; ++i) box.axes[i] += Vec<N, T>(any_way<N>(random) * 3e-5);
    return is_valid(box) ? Any(box) : shape;
  }

  std::vector<Pair> border(const Pair& pair) {
    rc::Random random = random_.split();
    return at_the_border<N, T>(pair, any_way<N>(random), [](const Pair& at) {
      return relation_of<N, T>(at.first, at.second) != Relation::apart;
    });
  }

  std::size_t a_;
  std::size_t b_;
  rc::Random random_;
};

}  // namespace graze::test
