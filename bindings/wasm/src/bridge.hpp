// SPDX-License-Identifier: MIT
// How values are passed between JavaScript and C++. Arrays of numbers use two buffers, which JavaScript reads and
// writes in place; texts and single numbers are arguments and results; shapes are described in arguments.hpp;
// exceptions are stored until JavaScript fetches them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::wasm {

/// Memory for this many bytes of input from JavaScript, aligned to 16. Previous content is lost.
std::byte* reserve_input(std::size_t bytes);

/// The numbers that JavaScript has written.
template <class T>
std::span<const T> input(std::size_t count);

/// The numbers of the current output; the next call starts a new one.
std::vector<double>& answer();

/// Tells JavaScript the address of the output.
void publish_answer();

/// Stores an error message for JavaScript to throw.
void keep_error(const std::exception& error);

/// Thrown if numbers are not a valid shape: JavaScript then passes the shape again as text, so that the library's
/// reader reports the fault and the field.
struct Refused : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Wraps a function for calls from JavaScript: starts a new output and turns exceptions into messages.
template <auto function>
struct Guarded;

template <class R, class... Arguments, R (*function)(Arguments...)>
struct Guarded<function> {
  static R call(Arguments... arguments) {
    answer().clear();
    try {
      if constexpr (std::is_void_v<R>) {
        function(static_cast<Arguments>(arguments)...);
        return publish_answer();
      } else {
        R result = function(static_cast<Arguments>(arguments)...);
        publish_answer();
        return result;
      }
    } catch (const std::exception& error) {
      keep_error(error);
    }
    if constexpr (!std::is_void_v<R>) return R();
  }
};

template <Dim N>
void put(const Vec<N, double>& vector) {
  for (Dim i = 0; i < N; ++i) answer().push_back(vector[i]);
}

template <Dim N>
void put(const Aabb<N, double>& box) {
  put<N>(box.min);
  put<N>(box.max);
}

/// Vector `index` of a consecutive array.
template <Dim N>
Vec<N, double> vector_at(std::span<const double> numbers, std::size_t index) {
  Vec<N, double> vector;
  for (Dim i = 0; i < N; ++i) vector[i] = numbers[index * static_cast<std::size_t>(N) + static_cast<std::size_t>(i)];
  return vector;
}

/// Box `index` of a consecutive array, min before max.
template <Dim N>
Aabb<N, double> box_at(std::span<const double> numbers, std::size_t index) {
  return {vector_at<N>(numbers, 2 * index), vector_at<N>(numbers, 2 * index + 1)};
}

/// Calls visit(constant of type Dim) for dimension 2 or 3. Throws std::invalid_argument for others.
template <class Visit>
auto in_dimension(int dimension, const Visit& visit) {
  if (dimension == 2) return visit(std::integral_constant<Dim, 2>());
  if (dimension == 3) return visit(std::integral_constant<Dim, 3>());
  throw std::invalid_argument("the dimension must be 2 or 3");
}

/// JavaScript has one type of number, which is exact for integers up to 2^53: 29 bits hold the slot of an object, the
/// rest its generation. Within 4 GiB of memory, no slot exceeds that, and a slot can be reused eight million times. The
/// owner is omitted, because ids are only passed to the scene or index that returned them.
double packed_id(std::uint32_t index, std::uint32_t generation);

/// The two numbers of an id. Throws std::invalid_argument unless it is an integer from 0 to 2^53 - 1.
struct UnpackedId {
  std::uint32_t index;
  std::uint32_t generation;
};
UnpackedId unpacked_id(double id);

}  // namespace graze::wasm
