// SPDX-License-Identifier: MIT
// The members of shapes under the names that scene files give them: one list, by which shapes are written and read.
#pragma once

#include <functional>
#include <string_view>
#include <tuple>

#include <graze/shape/any_shape.hpp>

namespace graze::io {

/// `std::invoke(of, shape)` is the member: a number, a vector, or a matrix of axes as columns.
template <class Of>
struct ShapeMember {
  constexpr ShapeMember(std::string_view field, Of member) : name(field), of(member) {}

  std::string_view name;
  Of of;
};

/// A tuple of the members of a type of shape, in the order in which scene files name them. A polytope and a compound
/// have none: they are lists, of "points" and of "parts".
template <class Shape>
inline constexpr std::tuple<> shape_members;

template <Dim N, class T>
inline constexpr auto shape_members<Vec<N, T>> = std::tuple(ShapeMember{"position", std::identity()});

template <Dim N, class T>
inline constexpr auto shape_members<Segment<N, T>> = std::tuple(ShapeMember{"start", &Segment<N, T>::start},
                                                                ShapeMember{"end", &Segment<N, T>::end});

template <Dim N, class T>
inline constexpr auto shape_members<Ray<N, T>> = std::tuple(ShapeMember{"origin", &Ray<N, T>::origin},
                                                            ShapeMember{"direction", &Ray<N, T>::direction});

template <Dim N, class T>
inline constexpr auto shape_members<Sphere<N, T>> = std::tuple(ShapeMember{"center", &Sphere<N, T>::center},
                                                               ShapeMember{"radius", &Sphere<N, T>::radius});

template <Dim N, class T>
inline constexpr auto shape_members<Aabb<N, T>> = std::tuple(ShapeMember{"min", &Aabb<N, T>::min},
                                                             ShapeMember{"max", &Aabb<N, T>::max});

template <Dim N, class T>
inline constexpr auto shape_members<Obb<N, T>> = std::tuple(ShapeMember{"center", &Obb<N, T>::center},
                                                            ShapeMember{"half_extents", &Obb<N, T>::half_extents},
                                                            ShapeMember{"axes", &Obb<N, T>::axes});

template <Dim N, class T>
inline constexpr auto shape_members<Plane<N, T>> = std::tuple(ShapeMember{"normal", &Plane<N, T>::normal},
                                                              ShapeMember{"offset", &Plane<N, T>::offset});

template <Dim N, class T>
inline constexpr auto shape_members<HalfSpace<N, T>> = std::tuple(ShapeMember{"normal", &HalfSpace<N, T>::normal},
                                                                  ShapeMember{"offset", &HalfSpace<N, T>::offset});

template <Dim N, class T>
inline constexpr auto shape_members<Triangle<N, T>> = std::tuple(ShapeMember{"a", &Triangle<N, T>::a},
                                                                 ShapeMember{"b", &Triangle<N, T>::b},
                                                                 ShapeMember{"c", &Triangle<N, T>::c});

template <Dim N, class T>
inline constexpr auto shape_members<Capsule<N, T>> = std::tuple(ShapeMember{"a", &Capsule<N, T>::a},
                                                                ShapeMember{"b", &Capsule<N, T>::b},
                                                                ShapeMember{"radius", &Capsule<N, T>::radius});

}  // namespace graze::io
