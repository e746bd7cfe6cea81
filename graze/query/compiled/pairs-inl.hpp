// SPDX-License-Identifier: MIT
// GRAZE_PAIR_INSTANCES(N, T): instantiates the queries on two shapes. One source per N and T, since most of these
// queries share code.
#pragma once

#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/separation.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/time_of_impact.hpp>

#define GRAZE_PAIR_INSTANCES(N, T)       \
  GRAZE_RELATION_INSTANCES(, N, T)       \
  GRAZE_CLOSEST_POINTS_INSTANCES(, N, T) \
  GRAZE_DISTANCE_INSTANCES(, N, T)       \
  GRAZE_CONTACT_INSTANCES(, N, T)        \
  GRAZE_MANIFOLD_INSTANCES(, N, T)       \
  GRAZE_SEPARATION_INSTANCES(, N, T)     \
  GRAZE_SHAPE_CAST_INSTANCES(, N, T)     \
  GRAZE_TIME_OF_IMPACT_INSTANCES(, N, T)
