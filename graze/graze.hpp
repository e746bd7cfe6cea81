// SPDX-License-Identifier: MIT
// Everything below io: shapes, queries, many things at once, scenes. Files are read by <graze/io/scene_file.hpp>.
#pragma once

#include <graze/broad/brute_force.hpp>
#include <graze/broad/brute_force_pairs.hpp>
#include <graze/broad/bvh.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/orthtree.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/broad/touching_pairs.hpp>
#include <graze/broad/worlds.hpp>
#include <graze/query/bounding.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/convex_parts.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/query/epa.hpp>
#include <graze/query/gjk.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/query/outline.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/query/time_of_impact.hpp>
#include <graze/query/transformed.hpp>
#include <graze/scene/scene.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/frustum.hpp>
#include <graze/shape/pick.hpp>
