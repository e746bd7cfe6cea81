// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include <graze/broad/batch/answers.hpp>
#include <graze/broad/batch/neighbours.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/shape/mesh.hpp>

namespace graze {

/// closest_point(mesh, point) for many points, in their order: the nearest point of the mesh, the point itself if a
/// solid contains it, NaN for a mesh without faces.
template <Dim N, class T>
std::vector<Vec<N, T>> closest_points(const Mesh<N, T>& mesh, std::type_identity_t<std::span<const Vec<N, T>>> points,
                                      const BatchOptions& options = {}) {
  return detail::answers_by_neighbours<Vec<N, T>>(
      points, options, [&mesh](const auto& piece, const auto& indices, Vec<N, T>* answers) {
        std::size_t guess = detail::DecidingPart::no_part;  // the face that is nearest to the last point
        for (const std::uint32_t i : indices) answers[i] = detail::closest_point_of_mesh(mesh, piece[i], guess);
      });
}

}  // namespace graze
