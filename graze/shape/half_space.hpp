// SPDX-License-Identifier: MIT
#pragma once

#include <graze/math/vec.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/transformed.hpp>
#include <graze/shape/plane.hpp>

namespace graze {

/// All x with dot(normal, x) <= offset: the solid behind a plane, the plane included. In 2D the half-plane beside a
/// line. The normal points out of the solid and has any length but zero.
template <Dim N, class T = float>
struct HalfSpace {
  Vec<N, T> normal = unit_axis<N, T>(1);
  T offset = T(0);
};

namespace detail {
template <Dim N, class T>
inline constexpr auto description_of<HalfSpace<N, T>> = Description("half_space",
                                                                    field::direction("normal",
                                                                                     &HalfSpace<N, T>::normal),
                                                                    field::offset("offset", &HalfSpace<N, T>::offset));
}  // namespace detail

/// The plane that bounds a half-space.
template <Dim N, class T>
Plane<N, T> boundary(const HalfSpace<N, T>& solid) {
  return {solid.normal, solid.offset};
}

}  // namespace graze
