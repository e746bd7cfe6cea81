// SPDX-License-Identifier: MIT
// Meshes that share triangles, changed so that they still do.
#pragma once

#include <map>
#include <utility>

#include <graze/math/pose.hpp>
#include <graze/shape/mesh.hpp>

namespace graze::io {

/// Calls change(mesh in its own coordinates) once for all meshes that share its triangles, and remembers the result.
template <class Result, class Change>
class OncePerTriangles {
 public:
  explicit OncePerTriangles(Change change) : change_(std::move(change)) {}

  const Result& of(const Mesh<3, double>& mesh) {
    const auto& data = detail::placed(mesh).data();
    const void* const key = data.get();
    const auto known = results_.find(key);
    if (known != results_.end()) return known->second;
    return results_.emplace(key, change_(mesh_of<3, double>(data->vertices(), data->faces(), data->kind())))
        .first->second;
  }

 private:
  Change change_;
  std::map<const void*, Result> results_;
};

template <class Result, class Change>
OncePerTriangles<Result, Change> once_per_triangles(Change change) {
  return OncePerTriangles<Result, Change>(std::move(change));
}

/// A mesh where another one is: moved and rotated like that.
inline Mesh<3, double> placed_like(const Mesh<3, double>& mesh, const Mesh<3, double>& other) {
  const auto& placed = detail::placed(other);
  return placed.is_moved() ? transformed(mesh, placed.pose()) : mesh;
}

}  // namespace graze::io
