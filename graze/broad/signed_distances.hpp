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
#include <graze/query/signed_distance.hpp>
#include <graze/shape/mesh.hpp>

namespace graze {

/// signed_distance(mesh, point) for many points, in their order: that of the nearest face, negative inside a solid;
/// infinity for a mesh without faces.
template <Dim N, class T>
std::vector<T> signed_distances(const Mesh<N, T>& mesh, std::type_identity_t<std::span<const Vec<N, T>>> points,
                                const BatchOptions& options = {}) {
  return detail::answers_by_neighbours<T>(points, options, [&mesh](const auto& piece, const auto& indices, T* answers) {
    std::size_t guess = detail::DecidingPart::no_part;  // the face that is nearest to the last point
    for (const std::uint32_t i : indices) {
      answers[i] = detail::rounded_distance<T>(detail::signed_distance_of_mesh(mesh, piece[i], guess));
    }
  });
}

}  // namespace graze
