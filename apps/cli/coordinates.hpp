// SPDX-License-Identifier: MIT
// Converts between vectors of either dimension and the lists of numbers in command lines and reports.
#pragma once

#include <cstddef>
#include <vector>

#include <graze/math/vec.hpp>

namespace graze::cli {

/// The N numbers from `first` on, which must exist.
template <Dim N>
Vec<N, double> vector_at(const std::vector<double>& numbers, std::size_t first) {
  Vec<N, double> v;
  for (Dim i = 0; i < N; ++i) v[i] = numbers[first + static_cast<std::size_t>(i)];
  return v;
}

template <Dim N>
std::vector<double> coordinates(const Vec<N, double>& v) {
  std::vector<double> numbers(static_cast<std::size_t>(N));
  for (Dim i = 0; i < N; ++i) numbers[static_cast<std::size_t>(i)] = v[i];
  return numbers;
}

}  // namespace graze::cli
