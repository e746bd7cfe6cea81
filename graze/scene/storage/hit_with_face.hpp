// SPDX-License-Identifier: MIT
// hit_with_face(shape, ray, t_max): ray_cast of any shape, with the face if the shape is a mesh.
#pragma once

#include <optional>
#include <variant>

#include <graze/math/vec.hpp>
#include <graze/query/mesh_hit.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/ray.hpp>

namespace graze::detail {

template <Dim N, class T>
std::optional<MeshHit<N, T>> hit_with_face(const AnyShape<N, T>& shape, const Ray<N, T>& ray, T t_max) {
  if (const auto* const mesh = std::get_if<Mesh<N, T>>(&shape)) return ray_cast(*mesh, ray, t_max);
  if (const auto hit = ray_cast(shape, ray, t_max)) return MeshHit<N, T>{*hit};
  return std::nullopt;
}

}  // namespace graze::detail
