// SPDX-License-Identifier: MIT
// Questions about many points, asked in an order in which most neighbours are neighbours in space.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/batch/answers.hpp>
#include <graze/broad/batch/tasks.hpp>
#include <graze/broad/orthtree/code.hpp>
#include <graze/broad/orthtree/place.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// The indices of points, sorted by the cells of a grid along a Morton curve; those in a cell ascend.
template <Dim N, class T>
std::vector<std::uint32_t> indices_along_curve(std::span<const Vec<N, T>> points) {
  Aabb<N, T> box = Aabb<N, T>::nothing();
  for (const Vec<N, T>& point : points) {
    if (is_finite(point)) box.grow(point);
  }
  CellPosition<N> root;
  if (!is_nothing(box)) root = {center_of(box), 0.5 * max_abs(wide<N, T>(box.max) - wide<N, T>(box.min))};
  const CodeScale<N, T> scale(root);
  constexpr int bits_of_code = N * code_levels<N>;
  const int bits = std::min(bits_of_code, static_cast<int>(std::bit_width(points.size())));  // a cell or two per point
  const auto cell_of = [&](const Vec<N, T>& point) { return code_of(point, scale) >> (bits_of_code - bits); };

  std::vector<std::uint32_t> ends(std::size_t{1} << bits);  // of the cells; becomes their beginnings
  for (const Vec<N, T>& point : points) ++ends[cell_of(point)];
  std::uint32_t end = 0;
  for (std::uint32_t& count : ends) count = end += count;
  std::vector<std::uint32_t> result(points.size());
  for (std::size_t i = points.size(); i-- > 0;) result[--ends[cell_of(points[i])]] = static_cast<std::uint32_t>(i);
  return result;
}

/// ask(points, indices along a curve, answers) for pieces of the points; it assigns answers[i] for every index i.
template <class Answer, Dim N, class T, class Ask>
std::vector<Answer> answers_by_neighbours(std::span<const Vec<N, T>> points, const BatchOptions& options,
                                          const Ask& ask) {
  const Executor& executor = executor_of(options);
  const std::size_t pieces = executor.concurrency() > 1 ? 4 * executor.concurrency() : 1;
  const std::size_t per_task = std::clamp<std::size_t>(points.size() / pieces, 512, std::size_t{1} << 20U);
  return written_by_tasks<Answer>(points.size(), per_task, executor,
                                  [&](std::size_t first, std::size_t last, Answer* out) {
                                    const auto piece = points.subspan(first, last - first);
                                    ask(piece, std::span<const std::uint32_t>(indices_along_curve(piece)), out);
                                  });
}

}  // namespace graze::detail
