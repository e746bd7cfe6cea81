// SPDX-License-Identifier: MIT
// Results that several queries put into the output, in the order in which js/ reads them.
#pragma once

#include <graze/math/vec.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/mesh_hit.hpp>
#include <graze/query/status.hpp>

#include "bridge.hpp"

namespace graze::wasm {

inline void put_end(Status status, double error) {
  answer().push_back(status == Status::converged ? 0 : 1);
  answer().push_back(error);
}

/// t, point, normal, status, error: for a RayHit or an Impact.
template <Dim N, class Hit>
void put_hit(const Hit& hit) {
  answer().push_back(hit.t);
  put<N>(hit.point);
  put<N>(hit.normal);
  put_end(hit.status, hit.error);
}

/// The same, then the face, or -1 for none, and the barycentric coordinates.
template <Dim N>
void put_mesh_hit(const MeshHit<N, double>& hit) {
  put_hit<N>(hit);
  answer().push_back(hit.face == no_face ? -1 : static_cast<double>(hit.face));
  put<3>(hit.barycentric);
}

/// The kind and index of a's feature and of b's, the part of a and of b.
inline void put_contact_id(const ContactId& id) {
  for (const Feature& feature : {id.a, id.b}) {
    answer().push_back(static_cast<double>(feature.kind));
    answer().push_back(feature.index);
  }
  answer().push_back(id.part_a);
  answer().push_back(id.part_b);
}

/// normal, status, error, the number of points, then for each of them: point, point_a, point_b, depth and the id.
template <Dim N>
void put_manifold(const Manifold<N, double>& manifold) {
  put<N>(manifold.normal);
  put_end(manifold.status, manifold.error);
  answer().push_back(static_cast<double>(manifold.size));
  for (const ManifoldPoint<N, double>& point : manifold.contacts()) {
    put<N>(point.point);
    put<N>(point.point_a);
    put<N>(point.point_b);
    answer().push_back(point.depth);
    put_contact_id(point.id);
  }
}

}  // namespace graze::wasm
