// SPDX-License-Identifier: MIT
// How values cross between JavaScript and C++. Numbers in bulk go through two buffers, which JavaScript reads and
// writes in place; texts and single numbers are arguments and results; shapes are in arguments.hpp; what is thrown is
// kept until JavaScript asks for it.
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

/// Room for so many bytes of numbers that JavaScript hands over, on a boundary of 16. What was there is lost.
std::byte* reserve_input(std::size_t bytes);

/// The numbers that JavaScript handed over.
template <class T>
std::span<const T> input(std::size_t count);

/// The numbers of the answer being given; the next call of anything begins a new one.
std::vector<double>& answer();

/// Tells JavaScript where the answer is.
void publish_answer();

/// Keeps the message of an error for JavaScript to throw.
void keep_error(const std::exception& error);

/// Thrown where numbers are no valid shape: JavaScript hands the shape over again as text, of which the library's
/// reader says what is wrong, and with which field.
struct Refused : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// A function as JavaScript may call it: begins a new answer, and what is thrown becomes a message.
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

/// Vector `index` of many in a row.
template <Dim N>
Vec<N, double> vector_at(std::span<const double> numbers, std::size_t index) {
  Vec<N, double> vector;
  for (Dim i = 0; i < N; ++i) vector[i] = numbers[index * static_cast<std::size_t>(N) + static_cast<std::size_t>(i)];
  return vector;
}

/// Box `index` of many in a row, min before max.
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

/// JavaScript has one type of number, whose integers are exact up to 2^53: 29 bits say the place of an object, the rest
/// its generation. Within 4 GiB of memory no place is beyond that, and a place is used eight million times before its
/// generation is; the owner is left out, as only one scene or index is asked about its ids.
double packed_id(std::uint32_t index, std::uint32_t generation);

/// The two numbers of an id. Throws std::invalid_argument for what is no whole number from 0 to 2^53 - 1.
struct UnpackedId {
  std::uint32_t index;
  std::uint32_t generation;
};
UnpackedId unpacked_id(double id);

}  // namespace graze::wasm
