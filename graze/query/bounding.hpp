// SPDX-License-Identifier: MIT
/// @file
/// Bounding volumes of points: bounding_box, bounding_sphere, bounding_sphere_fast, bounding_obb. Each takes a
/// contiguous range of points, in any order and with duplicates, and contains every one of them exactly, rounding
/// included.
///
///     const std::vector<Vec<3>> points = ...;
///     const Sphere<3> sphere = bounding_sphere(points);
///
/// Throws std::invalid_argument, naming the point, if there are no points or a coordinate is not finite.
#pragma once

#include <graze/query/bounding/box.hpp>     // IWYU pragma: export
#include <graze/query/bounding/obb.hpp>     // IWYU pragma: export
#include <graze/query/bounding/sphere.hpp>  // IWYU pragma: export
