// SPDX-License-Identifier: MIT
// NumPy arrays as spans of graze's types and back. Arrays of the right type are neither copied on the way in nor on the
// way out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <graze/broad/pair.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

#include "shape.hpp"

namespace graze::python {

/// What an argument is, for messages: "overlapping_pairs: boxes".
struct Argument {
  std::string_view function;
  std::string_view name;

  std::string text() const { return std::string(function) + ": " + std::string(name); }
};

/// A table of numbers that keeps its array alive.
struct Rows {
  py::array array;
  bool is_double = true;
  std::size_t count = 0;
  std::size_t columns = 0;

  template <class Row>
  std::span<const Row> as() const {
    return {static_cast<const Row*>(array.data()), count};
  }
};

/// The rows of an array of float32 or float64; anything else that is not an array becomes one of float64, or of
/// float32 unless `is_double`. Throws TypeError for other number types, and ValueError unless there are two axes, the
/// second with one of these sizes. Only arrays that are not contiguous are copied.
Rows rows_of(Argument argument, py::handle value, std::initializer_list<std::size_t> columns, bool is_double = true);

/// The same of a number type and a number of columns that another argument has determined.
Rows rows_in(Argument argument, py::handle value, std::size_t columns, World world, std::string_view other);

/// Whether this is an array with two axes, or a sequence whose first element is one, too.
bool has_rows(py::handle value);

/// Whether this is a list or other sequence, not an array, without elements.
bool is_empty_sequence(py::handle value);

enum class Rowwise : std::uint8_t { always, or_one_for_all };

/// An array of numbers of any type as a contiguous one of T. Throws ValueError unless its axes have these lengths, or,
/// if that is allowed, those but the first: then every row is the same.
template <class T>
py::array numbers_of(Argument argument, py::handle value, std::span<const std::size_t> sizes,
                     Rowwise rowwise = Rowwise::always);

/// Points of any number type, converted to T.
template <Dim N, class T>
std::vector<Vec<N, T>> points_of(Argument argument, py::handle value);

/// The number of columns of something that can be points: 2 or 3. Throws ValueError otherwise.
Dim columns_of_points(Argument argument, py::handle value);

/// Three indices for each face. Throws for what are not integers from 0 to 2^32 - 1.
std::vector<std::array<std::uint32_t, 3>> faces_of(Argument argument, py::handle value);

/// Throws ValueError, naming the row, if a number is not finite.
void require_finite(Argument argument, const Rows& rows);

/// A vector of N numbers.
template <Dim N, class T>
Vec<N, T> vector_of(Argument argument, py::handle value);

/// A number that is not NaN.
double number_of(Argument argument, py::handle value);

/// N columns of a rotation or of axes, given as an N x N matrix.
template <Dim N, class T>
Mat<N, T> matrix_of(Argument argument, py::handle value);

/// Pairs of indices, as a view of an array of uint32 or as a copy of other integers.
class PairRows {
 public:
  PairRows(Argument argument, py::handle value);

  std::span<const Pair> pairs() const { return pairs_; }

 private:
  py::object array_;
  std::vector<Pair> copied_;
  std::span<const Pair> pairs_;
};

/// The array of a list, which it takes over: one row of `columns` numbers of type Number for each element.
template <class Number, class Element>
py::array array_of(std::vector<Element> list, std::size_t columns) {
  static_assert(sizeof(Element) % sizeof(Number) == 0);
  auto kept = std::make_unique<std::vector<Element>>(std::move(list));
  const auto* const data = reinterpret_cast<const Number*>(kept->data());
  const auto rows = static_cast<py::ssize_t>(kept->size());
  const py::capsule owner(kept.release(), [](void* memory) { delete static_cast<std::vector<Element>*>(memory); });
  const auto step = static_cast<py::ssize_t>(sizeof(Element));
  if (columns == 0) return py::array_t<Number>({rows}, {step}, data, owner);
  return py::array_t<Number>({rows, static_cast<py::ssize_t>(columns)},
                             {step, static_cast<py::ssize_t>(sizeof(Number))}, data, owner);
}

/// The rows of a new array, without initial values: several threads write them before `array_of` hands them over.
template <class Row>
class NewRows {
 public:
  explicit NewRows(std::size_t count) : rows_(std::make_unique_for_overwrite<Row[]>(count)), count_(count) {}

  Row& operator[](std::size_t row) { return rows_[row]; }
  std::size_t size() const { return count_; }

  /// The memory, which the caller then owns.
  Row* release() { return rows_.release(); }

 private:
  std::unique_ptr<Row[]> rows_;
  std::size_t count_;
};

/// The array of rows of `columns` numbers of type Number; one axis for 0 columns.
template <class Number, class Row>
py::array array_of(NewRows<Row> rows, std::size_t columns) {
  static_assert(sizeof(Row) % sizeof(Number) == 0 && std::is_trivially_destructible_v<Row>);
  std::vector<py::ssize_t> sizes = {static_cast<py::ssize_t>(rows.size())};
  if (columns > 0) sizes.push_back(static_cast<py::ssize_t>(columns));
  Row* const data = rows.release();
  const py::capsule owner(data, [](void* memory) { delete[] static_cast<Row*>(memory); });
  return py::array_t<Number>(sizes, reinterpret_cast<const Number*>(data), owner);
}

inline py::array array_of(std::vector<Pair> pairs) { return array_of<std::uint32_t>(std::move(pairs), 2); }

/// A new array of one vector, read-only.
template <class T>
py::array frozen_array(const T* numbers, std::initializer_list<py::ssize_t> sizes) {
  py::array_t<T> array(py::array::ShapeContainer(sizes), numbers);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

template <Dim N, class T>
py::array frozen_vector(const Vec<N, T>& vector) {
  return frozen_array<T>(&vector[0], {static_cast<py::ssize_t>(N)});
}

/// A matrix, by rows as NumPy has it.
template <Dim N, class T>
py::array frozen_matrix(const Mat<N, T>& matrix) {
  std::array<T, static_cast<std::size_t>(N * N)> rows{};
  for (Dim i = 0; i < N; ++i) {
    for (Dim j = 0; j < N; ++j) rows[static_cast<std::size_t>(i * N + j)] = matrix[j][i];
  }
  return frozen_array<T>(rows.data(), {static_cast<py::ssize_t>(N), static_cast<py::ssize_t>(N)});
}

/// A read-only view of memory that belongs to `owner`.
template <class Number, class Element>
py::array view_of(std::span<const Element> list, std::size_t columns, py::handle owner) {
  py::array_t<Number> array({static_cast<py::ssize_t>(list.size()), static_cast<py::ssize_t>(columns)},
                            {static_cast<py::ssize_t>(sizeof(Element)), static_cast<py::ssize_t>(sizeof(Number))},
                            reinterpret_cast<const Number*>(list.data()), owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

static_assert(sizeof(Aabb<2, float>) == 16 && sizeof(Aabb<3, double>) == 48, "boxes are rows of an array");
static_assert(sizeof(Ray<2, float>) == 16 && sizeof(Ray<3, double>) == 48, "rays are rows of an array");
static_assert(sizeof(Pair) == 8, "pairs are rows of an array");

}  // namespace graze::python
