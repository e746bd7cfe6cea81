// SPDX-License-Identifier: MIT
// The number types of one pair, for calculations that are written once for one pair and for many: the `-inl.hpp` files
// of this folder are included in namespace one_pair by the headers of the same names, and once for each instruction
// set, with a lane for each pair, by graze/broad/contacts/many_pairs-inl.hpp, which defines the same functions for
// vectors. (They cannot be templates: the compiler must know the instruction set when it parses a function.) With many
// pairs, `&&` and `||` evaluate both sides, and `take` assigns only in some lanes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <graze/math/vec.hpp>
#include <graze/query/patch/clipped.hpp>
#include <graze/query/patch/patch.hpp>

namespace graze::detail::one_pair {

using Real = double;
using Mask = bool;
using Axis = Dim;  ///< A number of each pair, from 0 to 2.
using Point = Vec<3, double>;
using Point2d = Vec<2, double>;
using FeatureName = std::uint32_t;  ///< As one number: copying as a whole what was written in parts stalls.

using std::copysign;
using std::fabs;
using std::sqrt;

/// The same for all pairs.
constexpr Real all(double value) { return value; }
constexpr Mask all(bool value) { return value; }
constexpr FeatureName all(FeatureName value) { return value; }
constexpr Axis axis_number(Dim i) { return i; }
constexpr Mask is_axis(Axis axis, Dim i) { return axis == i; }
template <class P>
constexpr P zero() {
  return P(0.0);
}

/// Whether any pair has it.
constexpr bool any(Mask mask) { return mask; }
/// The same if it is true for nearly every group of pairs; for many pairs it always returns true.
constexpr bool any_likely(Mask mask) { return mask; }

template <class V>
[[gnu::always_inline]] constexpr V select(Mask mask, const V& yes, const V& no) {
  return mask ? yes : no;
}
[[gnu::always_inline]] constexpr Real or_zero(Mask mask, Real number) { return mask ? number : 0.0; }
/// Assigns for these pairs only; there is at least one.
template <class V>
[[gnu::always_inline]] constexpr void take(Mask /*some*/, const V& value, V& to) {
  to = value;
}

/// Branch-free, for conditions that are hard to predict.
[[gnu::always_inline]] constexpr Mask both_of(Mask a, Mask b) {
  return (static_cast<unsigned>(a) & static_cast<unsigned>(b)) != 0;
}
[[gnu::always_inline]] constexpr Mask either_of(Mask a, Mask b) {
  return (static_cast<unsigned>(a) | static_cast<unsigned>(b)) != 0;
}
constexpr Mask are_same(Mask a, Mask b) { return a == b; }

[[gnu::always_inline]] inline Real min_of(Real a, Real b) { return std::min(a, b); }
[[gnu::always_inline]] inline Real max_of(Real a, Real b) { return std::max(a, b); }

[[gnu::always_inline]] inline Real side_of(Real v) { return std::copysign(1.0, v); }

/// The coordinate or the axis `turns` after each pair's own.
[[gnu::always_inline]] inline Real turned(const Point& v, Axis axis, Dim turns = 0) { return v[(axis + turns) % 3]; }
template <class V>
[[gnu::always_inline]] inline const V& turned(const V (&of_axes)[3], Axis axis, Dim turns = 0) {
  return of_axes[(axis + turns) % 3];
}

/// The cross product of the two axes after each pair's own.
[[gnu::always_inline]] inline Point across_others(const Point (&axes)[3], Axis axis) {
  return cross(turned(axes, axis, 1), turned(axes, axis, 2));
}

/// The inverse: a point with these coordinates along each pair's own axis, the next one and the last one.
[[gnu::always_inline]] inline Point placed(Axis axis, Real on_axis, Real on_next, Real on_last) {
  Point result;
  result[axis] = on_axis;
  result[(axis + 1) % 3] = on_next;
  result[(axis + 2) % 3] = on_last;
  return result;
}
[[gnu::always_inline]] inline Point unit_point(Axis axis) { return unit_axis<3>(axis); }

// ---- Features

constexpr FeatureName name_of(FeatureKind kind, std::uint32_t index) {
  return static_cast<std::uint32_t>(kind) << 24U | index;
}
constexpr Feature feature_of(FeatureName name) { return {static_cast<FeatureKind>(name >> 24U), name & 0xffffffU}; }

inline constexpr FeatureName first_vertex = name_of(FeatureKind::vertex, 0);
inline constexpr FeatureName second_vertex = name_of(FeatureKind::vertex, 1);
inline constexpr FeatureName first_edge = name_of(FeatureKind::edge, 0);

/// The feature of a box that a point lies on, by the axes along which it is at the end.
inline FeatureName feature_of_box(const Point& place, const Mask (&is_beyond)[3]) {
  const auto far = [&](Dim i) { return place[i] > 0 ? 1U : 0U; };
  const int count = (is_beyond[0] ? 1 : 0) + (is_beyond[1] ? 1 : 0) + (is_beyond[2] ? 1 : 0);
  if (count == 3) return name_of(FeatureKind::vertex, far(0) | far(1) << 1U | far(2) << 2U);
  const Dim other = is_beyond[0] ? (is_beyond[1] ? 2 : 1) : 0;  // for an edge: the axis that it lies along
  if (count == 2) {
    const Dim along = is_beyond[0] && is_beyond[2] ? 1 : other;
    return name_of(FeatureKind::edge,
                   static_cast<std::uint32_t>(4 * along) + far((along + 1) % 3) + 2 * far((along + 2) % 3));
  }
  const Dim across = is_beyond[0] ? 0 : (is_beyond[1] ? 1 : 2);
  return name_of(FeatureKind::face, BoxFaceNumbers{across, far(across) != 0}.face());
}

inline FeatureName feature_of_face(Axis axis, Mask is_far) {
  return name_of(FeatureKind::face, BoxFaceNumbers{axis, is_far}.face());
}
/// The edge of a face at its far or near end along the next axis, or along the last one.
inline FeatureName feature_of_side(Axis axis, Mask is_far, Mask is_along_last, Mask is_at_far_end) {
  const BoxFaceNumbers face{axis, is_far};
  if (is_along_last) return name_of(FeatureKind::edge, face.edge(is_at_far_end ? 2 : 0));
  return name_of(FeatureKind::edge, face.edge(is_at_far_end ? 1 : 3));
}

/// The features of a 2D box: the corner on these sides of the middle, and the side across an axis, at its half edge or,
/// with -1, on the opposite side.
[[gnu::always_inline]] inline FeatureName corner_feature_2d(const Point2d& sides) {
  return name_of(FeatureKind::vertex, (sides.x > 0 ? 1U : 0U) | (sides.y > 0 ? 2U : 0U));
}
[[gnu::always_inline]] inline FeatureName side_feature_2d(Mask across_second, Real at) {
  return name_of(FeatureKind::edge, (across_second ? 2U : 0U) | (at > 0 ? 1U : 0U));
}

}  // namespace graze::detail::one_pair
