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
#include <graze/query/parts/visit.hpp>
#include <graze/query/winding_number.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/mesh.hpp>

namespace graze {

namespace detail {

/// Answers for points, most of them near each other. Those in a box that no face of a closed mesh reaches into have the
/// same number.
template <Dim N, class T>
class WindingNumbers {
 public:
  WindingNumbers(const Mesh<N, T>& mesh, std::span<const Vec<N, T>> points, double* answers)
      : mesh_(mesh),
        points_(points),
        answers_(answers),
        has_regions_(N == 2 || placed(mesh).data()->open_edges().empty()) {}

  void find(std::span<const std::uint32_t> indices) const {
    constexpr std::size_t few = 16;
    if (has_regions_ && indices.size() > 1 && are_together(indices)) {
      const double number = winding_number(mesh_, points_[indices[0]]);
      for (const std::uint32_t i : indices) answers_[i] = number;
    } else if (!has_regions_ || indices.size() <= few) {
      for (const std::uint32_t i : indices) answers_[i] = winding_number(mesh_, points_[i]);
    } else {
      find(indices.first(indices.size() / 2));
      find(indices.subspan(indices.size() / 2));
    }
  }

 private:
  bool are_together(std::span<const std::uint32_t> indices) const {
    Aabb<N, T> box = Aabb<N, T>::nothing();
    for (const std::uint32_t i : indices) {
      if (!is_finite(points_[i])) return false;
      box.grow(points_[i]);
    }
    bool is_free = true;
    visit_parts(mesh_, MayTouch<N, T>{box}, [&is_free](const FacePart<N, T>&, std::size_t) {
      is_free = false;
      return false;
    });
    return is_free;
  }

  const Mesh<N, T>& mesh_;
  std::span<const Vec<N, T>> points_;
  double* answers_;
  bool has_regions_;
};

}  // namespace detail

/// winding_number(mesh, point) for many points, in their order.
template <Dim N, class T>
std::vector<double> winding_numbers(const Mesh<N, T>& mesh, std::type_identity_t<std::span<const Vec<N, T>>> points,
                                    const BatchOptions& options = {}) {
  return detail::answers_by_neighbours<double>(
      points, options, [&mesh](const auto& piece, std::span<const std::uint32_t> indices, auto* answers) {
        constexpr std::size_t at_a_time = 64;
        const detail::WindingNumbers<N, T> numbers(mesh, piece, answers);
        for (; indices.size() > at_a_time; indices = indices.subspan(at_a_time)) numbers.find(indices.first(at_a_time));
        numbers.find(indices);
      });
}

}  // namespace graze
