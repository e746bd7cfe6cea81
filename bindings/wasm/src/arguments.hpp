// SPDX-License-Identifier: MIT
// Arguments as consecutive numbers, which JavaScript writes into shared memory (js/arguments.js).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <graze/math/motion.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/ray.hpp>

namespace graze::wasm {

/// Reads arguments from their start. The lengths that JavaScript wrote are trusted.
class Arguments {
 public:
  /// Reads from a position in the argument memory.
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

  /// A form's number, then the numbers of its fields. Throws Refused for an invalid shape.
  template <Dim N>
  AnyShape<N, double> shape();

  template <Dim N>
  Ray<N, double> ray();

  /// The translation, the rotation and the center.
  template <Dim N>
  Motion<N, double> motion() {
    Motion<N, double> motion;
    motion.linear = vector<N>();
    if constexpr (N == 2) {
      motion.angular = number();
    } else {
      motion.angular = vector<N>();
    }
    motion.center = vector<N>();
    return motion;
  }

  /// A count, then that many shapes.
  template <Dim N>
  std::vector<AnyShape<N, double>> shapes();

 private:
  std::span<const double> numbers_;
  std::size_t place_;
};

/// Appends a shape to the output in the format that Arguments reads.
template <Dim N>
void put_shape(const AnyShape<N, double>& shape);

}  // namespace graze::wasm
