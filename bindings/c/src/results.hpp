// SPDX-License-Identifier: MIT
// Answers of queries as structs of C.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <graze/broad/pair.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/query/mesh_hit.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/aabb.hpp>

#include "../graze.h"
#include "vectors.hpp"

namespace graze::c {

static_assert(int{GRAZE_APART} == int(Relation::apart) && int{GRAZE_TOUCHING} == int(Relation::touching) &&
              int{GRAZE_OVERLAPPING} == int(Relation::overlapping));
static_assert(int{GRAZE_CONVERGED} == int(Status::converged) && int{GRAZE_BEST_BOUND} == int(Status::best_bound));
static_assert(int{GRAZE_VERTEX} == int(FeatureKind::vertex) && int{GRAZE_EDGE} == int(FeatureKind::edge) &&
              int{GRAZE_FACE} == int(FeatureKind::face));

inline graze_pair c_result(const Pair& pair) { return {pair.a, pair.b}; }

/// For buffers.
inline constexpr auto in_c = [](const auto& found) { return c_result(found); };

template <Dim N, class T>
graze_box c_result(const Aabb<N, T>& box) {
  return {vec_out<N, T>(box.min), vec_out<N, T>(box.max)};
}

template <Dim N, class T>
graze_proximity c_result(const Proximity<N, T>& found) {
  graze_proximity result{};
  result.distance = static_cast<double>(found.distance);
  result.point_a = vec_out<N, T>(found.point_a);
  result.point_b = vec_out<N, T>(found.point_b);
  result.normal = vec_out<N, T>(found.normal);
  result.error = found.error;
  result.relation = static_cast<graze_relation>(found.relation);
  result.status = static_cast<graze_convergence>(found.status);
  return result;
}

template <Dim N, class T>
graze_contact c_result(const Contact<N, T>& found) {
  graze_contact result{};
  result.point = vec_out<N, T>(found.point);
  result.normal = vec_out<N, T>(found.normal);
  result.depth = static_cast<double>(found.depth);
  result.point_a = vec_out<N, T>(found.point_a);
  result.point_b = vec_out<N, T>(found.point_b);
  result.error = found.error;
  result.status = static_cast<graze_convergence>(found.status);
  return result;
}

template <Dim N, class T>
graze_manifold_point c_result(const ManifoldPoint<N, T>& found) {
  graze_manifold_point result{};
  result.point = vec_out<N, T>(found.point);
  result.point_a = vec_out<N, T>(found.point_a);
  result.point_b = vec_out<N, T>(found.point_b);
  result.depth = static_cast<double>(found.depth);
  result.feature_a = static_cast<graze_feature_kind>(found.id.a.kind);
  result.feature_b = static_cast<graze_feature_kind>(found.id.b.kind);
  result.index_a = found.id.a.index;
  result.index_b = found.id.b.index;
  result.part_a = found.id.part_a;
  result.part_b = found.id.part_b;
  return result;
}

template <Dim N, class T>
graze_manifold c_result(const Manifold<N, T>& found) {
  graze_manifold result{};
  for (std::size_t i = 0; i < found.size; ++i) result.points[i] = c_result(found.points[i]);
  result.normal = vec_out<N, T>(found.normal);
  result.error = found.error;
  result.count = static_cast<std::uint32_t>(found.size);
  result.status = static_cast<graze_convergence>(found.status);
  return result;
}

template <Dim N, class T>
graze_ray_hit c_result(const RayHit<N, T>& found) {
  graze_ray_hit result{};
  result.t = static_cast<double>(found.t);
  result.point = vec_out<N, T>(found.point);
  result.normal = vec_out<N, T>(found.normal);
  result.error = found.error;
  result.face = GRAZE_NO_FACE;
  result.status = static_cast<graze_convergence>(found.status);
  result.is_hit = true;
  return result;
}

template <Dim N, class T>
graze_ray_hit c_result(const MeshHit<N, T>& found) {
  graze_ray_hit result = c_result(static_cast<const RayHit<N, T>&>(found));
  result.barycentric = vec_out<3, T>(found.barycentric);
  if (found.face != no_face) result.face = found.face;
  return result;
}

template <Dim N, class T>
graze_impact c_result(const Impact<N, T>& found) {
  graze_impact result{};
  result.t = static_cast<double>(found.t);
  result.point = vec_out<N, T>(found.point);
  result.normal = vec_out<N, T>(found.normal);
  result.error = found.error;
  result.status = static_cast<graze_convergence>(found.status);
  return result;
}

template <Dim N>
graze_mass c_result(const MassProperties<N>& found) {
  graze_mass result{};
  result.volume = found.volume;
  result.centroid = vec_out<N, double>(found.centroid);
  if constexpr (N == 2) {
    result.inertia.columns[2].z = found.inertia;
  } else {
    result.inertia = mat_out<3, double>(found.inertia);
  }
  return result;
}

/// Writes an answer or, if there is none, zeros.
template <class Result, class Found>
graze_status write_answer(Result& out, const std::optional<Found>& found) {
  out = found ? c_result(*found) : Result{};
  return found ? GRAZE_OK : GRAZE_NONE;
}

}  // namespace graze::c
