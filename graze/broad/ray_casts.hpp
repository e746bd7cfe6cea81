// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include <graze/broad/batch/answers.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/shape/mesh.hpp>

namespace graze {

/// ray_cast(mesh, ray) for many rays, in their order, each valid.
template <Dim N, class T>
std::vector<std::optional<MeshHit<N, T>>> ray_casts(const Mesh<N, T>& mesh,
                                                    std::type_identity_t<std::span<const Ray<N, T>>> rays,
                                                    const BatchOptions& options = {}) {
  return detail::answers<std::optional<MeshHit<N, T>>>(rays.size(), options,
                                                       [&](std::size_t i) { return ray_cast(mesh, rays[i]); });
}

}  // namespace graze
