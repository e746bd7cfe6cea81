// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include <graze/broad/batch/answers.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/winding_number.hpp>
#include <graze/shape/mesh.hpp>

namespace graze {

/// winding_number(mesh, point) for many points, in their order.
template <Dim N, class T>
std::vector<double> winding_numbers(const Mesh<N, T>& mesh, std::type_identity_t<std::span<const Vec<N, T>>> points,
                                    const BatchOptions& options = {}) {
  return detail::answers<double>(points.size(), options,
                                 [&](std::size_t i) { return winding_number(mesh, points[i]); });
}

}  // namespace graze
