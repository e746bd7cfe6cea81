// SPDX-License-Identifier: MIT
#pragma once

#include <graze/math/vec.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/transformed.hpp>
#include <graze/shape/plane.hpp>

namespace graze {

/// All x with dot(normal, x) <= offset: everything on one side of a plane, the plane included; in 2D a half-plane. The
/// normal points out of the solid and may have any nonzero length.
template <Dim N, class T = float>
struct HalfSpace {
  Vec<N, T> normal = unit_axis<N, T>(1);  ///< Points out of the solid; any nonzero length.
  T offset = T(0);                        ///< dot(normal, x) on the boundary.
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
