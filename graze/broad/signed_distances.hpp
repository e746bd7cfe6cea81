// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include <graze/broad/batch/answers.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/shape/mesh.hpp>

namespace graze {

/// signed_distance(mesh, point) for many points, in their order: that of the nearest face, negative inside a solid;
/// infinity for a mesh without faces.
template <Dim N, class T>
std::vector<T> signed_distances(const Mesh<N, T>& mesh, std::type_identity_t<std::span<const Vec<N, T>>> points,
                                const BatchOptions& options = {}) {
  return detail::answers<T>(points.size(), options, [&](std::size_t i) { return signed_distance(mesh, points[i]); });
}

}  // namespace graze
