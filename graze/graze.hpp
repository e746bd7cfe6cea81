// SPDX-License-Identifier: MIT
/// @file
/// Includes shapes, queries on pairs, queries on many objects, and scenes. What takes long to compile and few programs
/// need is left out and has a header of its own: files (`<graze/io/scene_file.hpp>`), bounding volumes of points
/// (`<graze/query/bounding.hpp>`), the edges of a hull (`<graze/shape/convex_mesh.hpp>`), decomposition of polygons
/// (`<graze/query/convex_parts.hpp>`, `<graze/query/filled_parts.hpp>`) and random scenes
/// (`<graze/broad/scene_generators.hpp>`).
#pragma once

#include <graze/broad/brute_force.hpp>
#include <graze/broad/brute_force_pairs.hpp>
#include <graze/broad/bvh.hpp>
#include <graze/broad/contacts.hpp>
#include <graze/broad/custom_index.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/grid.hpp>
#include <graze/broad/orthtree.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/broad/sorted_pairs.hpp>
#include <graze/broad/touching_pairs.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contains.hpp>
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
#include <graze/query/separation.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/query/time_of_impact.hpp>
#include <graze/query/transformed.hpp>
#include <graze/scene/filter_matrix.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/visit_candidates.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/frustum.hpp>
#include <graze/shape/pick.hpp>
#include <graze/shape/posed.hpp>
