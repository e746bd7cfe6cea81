// SPDX-License-Identifier: MIT
// relation.hpp for any two convex shapes without a closed form: GJK, then EPA if they meet. Include relation.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <variant>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/epa.hpp>
#include <graze/query/gjk.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/shape_order.hpp>
#include <graze/shape/posed.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// Whether two cores that meet, as far as the distance can tell, have a depth, if only that of their radii; or are
/// farther apart than `reach` after all.
template <Convex A, Convex B>
Relation relation_of_meeting(const A& a, const B& b, const GjkResult<dimension_of<A>>& distance, double reach) {
  const EpaResult<dimension_of<A>> depth = usual_epa(a, b, distance.simplex, EpaOptions{0});
  if (depth.gap > reach + depth.resolution) return Relation::apart;
  const bool is_deep = depth.lower > depth.resolution || (depth.holds_origin && reach > depth.resolution);
  return is_deep ? Relation::overlapping : Relation::touching;
}

// ---- An order of shapes, so that swapped arguments take the same path.

/// By type: the index in AnyShape, users' types last.
template <class S, class... Shapes>
constexpr std::size_t place_among(const std::variant<Shapes...>*) {
  std::size_t place = 0;
  (void)((std::is_same_v<S, Shapes> ? true : (++place, false)) || ...);
  return place;
}

template <Shape S>
inline constexpr std::size_t type_place =
    place_among<S>(static_cast<const AnyShape<dimension_of<S>, scalar_of<S>>*>(nullptr));

template <class Points>
bool corners_come_first(const Points& a, const Points& b) {
  using Point = typename Points::value_type;
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), [](const Point& p, const Point& q) {
    for (Dim i = 0; i < Point::length(); ++i) {
      if (p[i] != q[i]) return p[i] < q[i];
    }
    return false;
  });
}

/// By their poses, if these differ.
template <Dim N, class T>
bool comes_first(const Posed<Polytope<N, T>>& a, const Posed<Polytope<N, T>>& b) {
  const std::array<Vec<N, T>, 1> at_a{a.pose.position};
  const std::array<Vec<N, T>, 1> at_b{b.pose.position};
  if (a.pose.position != b.pose.position) return corners_come_first(at_a, at_b);
  for (Dim k = 0; k < N; ++k) {
    const std::array<Vec<N, T>, 1> of_a{a.pose.rotation[k]};
    const std::array<Vec<N, T>, 1> of_b{b.pose.rotation[k]};
    if (of_a != of_b) return corners_come_first(of_a, of_b);
  }
  return compare(a.shape, b.shape) <= 0;
}

/// Users' types by their support points along the axes; if all of those are equal, the two are considered equal.
template <Convex A, Convex B>
bool comes_first(const A& a, const B& b) {
  constexpr Dim N = dimension_of<A>;
  for (Dim i = 0; i < N; ++i) {
    for (const double sign : {-1.0, 1.0}) {
      const Vec<N, double> direction = unit_axis<N>(i) * sign;
      const Vec<N, double> on_a = wide_support(a, direction);
      const Vec<N, double> on_b = wide_support(b, direction);
      for (Dim k = 0; k < N; ++k) {
        if (on_a[k] != on_b[k]) return on_a[k] < on_b[k];
      }
    }
  }
  return true;
}

/// Whether a precedes b, or is the same.
template <class A, class B>
bool is_in_order(const A& a, const B& b) {
  if constexpr (type_place<A> != type_place<B>) {
    return type_place<A> < type_place<B>;
  } else if constexpr (std::is_same_v<A, B> && requires { compare(a, b); }) {
    return compare(a, b) <= 0;
  } else {
    return comes_first(a, b);  // users' types
  }
}

/// True for different types of which B is the first in the order of AnyShape. Queries then ask for (b, a) and turn the
/// answer, so that a pair of types is compiled in one order only.
template <class A, class B>
inline constexpr bool are_exchanged = type_place<A> > type_place<B>;

/// True if a may precede b or follow it, which the types alone do not tell.
template <class A, class B>
inline constexpr bool are_in_either_order = type_place<A> == type_place<B>;

/// ask(a, b), or turn(ask(b, a)) if b precedes a: the same bits for both orders of the arguments.
template <class A, class B, class Ask, class Turn>
[[gnu::always_inline]] inline auto answer_in_order(const A& a, const B& b, const Ask& ask, const Turn& turn) {
  if constexpr (type_place<A> < type_place<B>) {
    return ask(a, b);
  } else if constexpr (are_exchanged<A, B>) {
    return turn(ask(b, a));
  } else {
    return is_in_order(a, b) ? ask(a, b) : turn(ask(b, a));
  }
}

template <Convex A, Convex B>
Relation relation_of_convex_ordered(const A& a, const B& b);

/// Compares the cores' distance with the sum of their radii.
template <Convex A, Convex B>
Relation relation_of_convex(const A& a, const B& b) {
  if constexpr (!is_known_by_support<A> && !is_known_by_support<B>) {
    if (!are_usual(a, b)) {
      if (const auto verdict = verdict_in_range(a, b)) return *verdict;
    }
  }
  const auto& core_a = core(a);
  const auto& core_b = core(b);
  const double reach = core_radius(a) + core_radius(b);
  const GjkResult<dimension_of<A>> distance = usual_gjk(core_a, core_b, GjkOptions{reach});
  const double slack = distance.resolution + tolerance::rounding * reach;
  if (!is_usual_error<scalar_of<A>>(slack)) {
    if (const auto verdict = verdict_in_range(a, b)) return *verdict;
  }
  if (!(distance.upper >= 0) || distance.lower > reach + slack) return Relation::apart;
  if (distance.upper < reach - slack) return Relation::overlapping;
  if (distance.lower > slack) return Relation::touching;
  return relation_of_meeting(core_a, core_b, distance, reach);
}

/// The same for swapped arguments.
template <Convex A, Convex B>
Relation relation_of_convex_ordered(const A& a, const B& b) {
  const auto ask = [](const auto& first, const auto& second) { return relation_of_convex(first, second); };
  return answer_in_order(a, b, ask, std::identity());
}

}  // namespace graze::detail
