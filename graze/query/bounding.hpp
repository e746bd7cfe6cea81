// SPDX-License-Identifier: MIT
/// @file
/// Bounding volumes of points: bounding_box, bounding_sphere, bounding_sphere_fast, bounding_obb. Each takes a span or
/// a vector of points, in any order and with duplicates, and contains every one of them exactly, rounding included.
///
///     const std::vector<Vec<3>> points = ...;
///     const Sphere<3> sphere = bounding_sphere(points);                     deduced from a vector or a span of const
///     const Sphere<3> other = bounding_sphere<3, float>(std::array{...});   named for whatever converts to one
///
/// Throws std::invalid_argument, naming the point, if there are no points or a coordinate is not finite.
#pragma once

#include <graze/query/bounding/box.hpp>     // IWYU pragma: export
#include <graze/query/bounding/obb.hpp>     // IWYU pragma: export
#include <graze/query/bounding/sphere.hpp>  // IWYU pragma: export
