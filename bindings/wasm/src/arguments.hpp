// SPDX-License-Identifier: MIT
// Arguments as numbers, which JavaScript writes one behind the other into memory that both see (js/arguments.js).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/ray.hpp>

namespace graze::wasm {

/// Takes arguments from their front. What JavaScript wrote is trusted to be as long as it says.
class Arguments {
 public:
  /// Those that begin at a place in the memory for arguments.
  explicit Arguments(std::size_t place);

  double number() { return numbers_[place_++]; }
  std::span<const double> numbers(std::size_t count) {
    place_ += count;
    return numbers_.subspan(place_ - count, count);
  }
  std::size_t count() { return static_cast<std::size_t>(number()); }

  template <Dim N>
  Vec<N, double> vector() {
    Vec<N, double> vector;
    for (Dim i = 0; i < N; ++i) vector[i] = number();
    return vector;
  }

  /// A form's number, then the numbers of its fields. Throws Refused for a shape that is not valid.
  template <Dim N>
  AnyShape<N, double> shape();

  template <Dim N>
  Ray<N, double> ray();

  /// A count, then so many shapes.
  template <Dim N>
  std::vector<AnyShape<N, double>> shapes();

 private:
  std::span<const double> numbers_;
  std::size_t place_;
};

/// Puts a shape into the answer as Arguments reads it.
template <Dim N>
void put_shape(const AnyShape<N, double>& shape);

}  // namespace graze::wasm
