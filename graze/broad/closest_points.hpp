// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include <graze/broad/batch/answers.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/shape/mesh.hpp>

namespace graze {

/// closest_point(mesh, point) for many points, in their order: the nearest point of the mesh, the point itself if a
/// solid contains it, NaN for a mesh without faces.
template <Dim N, class T>
std::vector<Vec<N, T>> closest_points(const Mesh<N, T>& mesh, std::type_identity_t<std::span<const Vec<N, T>>> points,
                                      const BatchOptions& options = {}) {
  return detail::answers<Vec<N, T>>(points.size(), options,
                                    [&](std::size_t i) { return closest_point(mesh, points[i]); });
}

}  // namespace graze
