// SPDX-License-Identifier: MIT
// GRAZE_SINGLE_INSTANCES(N, T): instantiates the queries on one shape.
#pragma once

#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/signed_distance.hpp>

#define GRAZE_SINGLE_INSTANCES(N, T)             \
  GRAZE_CONTAINS_INSTANCES(, N, T)               \
  GRAZE_SIGNED_DISTANCE_INSTANCES(, N, T)        \
  GRAZE_CLOSEST_POINT_INSTANCES(, N, T)          \
  GRAZE_CLOSEST_BOUNDARY_POINT_INSTANCES(, N, T) \
  GRAZE_MASS_PROPERTIES_INSTANCES(, N, T)        \
  GRAZE_RAY_CAST_INSTANCES(, N, T)
