// SPDX-License-Identifier: MIT
#include "arrays.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>

#include "keys.hpp"

namespace graze::python {
namespace {

/// numpy.asarray, whose errors about ragged lists and the like become ours.
py::array any_array(Argument argument, py::handle value) {
  if (py::isinstance<py::array>(value)) return py::reinterpret_borrow<py::array>(value);
  // What is neither an array nor a sequence would become an array of one object.
  if (PySequence_Check(value.ptr()) == 0 || PyUnicode_Check(value.ptr()) != 0 || PyBytes_Check(value.ptr()) != 0) {
    throw py::type_error(
        fmt::format("{} is a {}; an array of numbers is needed", argument.text(), Py_TYPE(value.ptr())->tp_name));
  }
  try {
    return py::module_::import("numpy").attr("asarray")(value);
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError)) throw;
    throw py::value_error(
        fmt::format("{} cannot become an array: {}", argument.text(), std::string(py::str(error.value()))));
  }
}

char kind_of(const py::array& array) { return array.dtype().kind(); }

bool is_float_array(const py::array& array) {
  return kind_of(array) == 'f' && (array.itemsize() == 4 || array.itemsize() == 8);
}

std::string shape_text(const py::array& array) {
  std::string text;
  for (py::ssize_t axis = 0; axis < array.ndim(); ++axis)
    text += fmt::format("{}{}", axis == 0 ? "" : ", ", array.shape(axis));
  return fmt::format("({})", text);
}

/// An array of numbers as a contiguous one of T.
template <class T>
py::array converted(Argument argument, const py::array& array) {
  const char kind = kind_of(array);
  if (kind != 'f' && kind != 'i' && kind != 'u') {
    throw py::type_error(
        fmt::format("{} has dtype {}; numbers are needed", argument.text(), std::string(py::str(array.dtype()))));
  }
  auto result = py::array_t<T, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!result) throw py::error_already_set();
  return result;
}

void require_columns(Argument argument, const py::array& array, std::span<const std::size_t> columns) {
  if (array.ndim() == 2) {
    const auto size = static_cast<std::size_t>(array.shape(1));
    if (std::find(columns.begin(), columns.end(), size) != columns.end()) return;
  }
  throw py::value_error(fmt::format("{} has shape {}; (n, {}) is needed", argument.text(), shape_text(array),
                                    fmt::join(columns, " or ")));
}

/// A contiguous and aligned array in native byte order, the same one if it is so.
template <class T>
py::array in_memory_order(const py::array& array) {
  auto result = py::array_t<T, py::array::c_style>::ensure(array);
  if (!result) throw py::error_already_set();
  return result;
}

/// An empty list has no second axis.
py::array table_of(Argument argument, py::handle value, std::size_t columns, bool is_double) {
  py::array array = any_array(argument, value);
  const bool is_array = py::isinstance<py::array>(value);
  if (!is_array && array.size() == 0 && array.ndim() == 1) {
    const std::array<py::ssize_t, 2> sizes = {0, static_cast<py::ssize_t>(columns)};
    return is_double ? py::array(py::array_t<double>(sizes)) : py::array(py::array_t<float>(sizes));
  }
  if (!is_array) return is_double ? converted<double>(argument, array) : converted<float>(argument, array);
  if (!is_float_array(array)) {
    throw py::type_error(fmt::format("{} has dtype {}; float32 or float64 is needed: use astype", argument.text(),
                                     std::string(py::str(array.dtype()))));
  }
  return array.itemsize() == 8 ? in_memory_order<double>(array) : in_memory_order<float>(array);
}

template <class T>
std::size_t first_not_finite(const T* numbers, std::size_t count) {
  T sum = 0;  // is not finite if a number is not; checked first, because it needs no branches
  for (std::size_t i = 0; i < count; ++i) sum += numbers[i] * T(0);
  if (sum == T(0)) return count;
  return static_cast<std::size_t>(
      std::find_if(numbers, numbers + count, [](T number) { return !std::isfinite(number); }) - numbers);
}

bool has_shape(const py::array& array, std::span<const std::size_t> sizes) {
  return std::equal(sizes.begin(), sizes.end(), array.shape(), array.shape() + array.ndim(),
                    [](std::size_t needed, py::ssize_t given) { return std::cmp_equal(needed, given); });
}

}  // namespace

Rows rows_of(Argument argument, py::handle value, std::initializer_list<std::size_t> columns, bool is_double) {
  const std::span<const std::size_t> allowed(columns.begin(), columns.size());
  Rows rows;
  rows.array = table_of(argument, value, allowed.front(), is_double);
  require_columns(argument, rows.array, allowed);
  rows.is_double = rows.array.itemsize() == 8;
  rows.count = static_cast<std::size_t>(rows.array.shape(0));
  rows.columns = static_cast<std::size_t>(rows.array.shape(1));
  return rows;
}

Rows rows_in(Argument argument, py::handle value, std::size_t columns, World world, std::string_view other) {
  Rows rows = rows_of(argument, value, {columns}, world.is_double);
  if (rows.is_double != world.is_double) {
    throw py::type_error(fmt::format("{} has dtype {}, but {} {}: use astype", argument.text(),
                                     name_of_numbers({2, rows.is_double}), other, name_of_numbers(world)));
  }
  return rows;
}

void require_finite(Argument argument, const Rows& rows) {
  const std::size_t count = rows.count * rows.columns;
  const std::size_t first = rows.is_double ? first_not_finite(static_cast<const double*>(rows.array.data()), count)
                                           : first_not_finite(static_cast<const float*>(rows.array.data()), count);
  if (first == count) return;
  throw py::value_error(
      fmt::format("{} has a number that is not finite in row {}", argument.text(), first / rows.columns));
}

bool has_rows(py::handle value) {
  if (py::isinstance<py::array>(value)) return py::reinterpret_borrow<py::array>(value).ndim() == 2;
  if (PySequence_Check(value.ptr()) == 0) return false;
  const auto first = py::reinterpret_steal<py::object>(PySequence_GetItem(value.ptr(), 0));
  if (!first) PyErr_Clear();
  return first && PySequence_Check(first.ptr()) != 0 && PyUnicode_Check(first.ptr()) == 0;
}

bool is_empty_sequence(py::handle value) {
  if (py::isinstance<py::array>(value) || PySequence_Check(value.ptr()) == 0) return false;
  const py::ssize_t size = PySequence_Size(value.ptr());
  if (size < 0) throw py::error_already_set();
  return size == 0;
}

template <class T>
py::array numbers_of(Argument argument, py::handle value, std::span<const std::size_t> sizes, Rowwise rowwise) {
  const bool may_be_one = rowwise == Rowwise::or_one_for_all;
  const bool is_number = PyFloat_Check(value.ptr()) != 0 || PyLong_Check(value.ptr()) != 0;
  const py::module_ numpy = py::module_::import("numpy");
  py::array array = may_be_one && is_number ? py::array(numpy.attr("asarray")(number_of(argument, value)))
                                            : any_array(argument, value);
  if (may_be_one && has_shape(array, sizes.subspan(1))) {
    array = numpy.attr("broadcast_to")(array, py::tuple(py::cast(std::vector(sizes.begin(), sizes.end()))));
  }
  if (!has_shape(array, sizes)) {
    throw py::value_error(fmt::format("{} has shape {}; ({}{}) is needed", argument.text(), shape_text(array),
                                      fmt::join(sizes, ", "), sizes.size() == 1 ? "," : ""));
  }
  return converted<T>(argument, array);
}

Dim columns_of_points(Argument argument, py::handle value) {
  const py::array array = any_array(argument, value);
  const std::array<std::size_t, 2> allowed = {2, 3};
  require_columns(argument, array, allowed);
  return static_cast<Dim>(array.shape(1));
}

template <Dim N, class T>
std::vector<Vec<N, T>> points_of(Argument argument, py::handle value) {
  const py::array array = any_array(argument, value);
  if (array.size() == 0 && array.ndim() == 1) return {};  // an empty list has no second axis
  const std::array<std::size_t, 1> allowed = {static_cast<std::size_t>(N)};
  require_columns(argument, array, allowed);
  const py::array numbers = converted<T>(argument, array);
  const auto* const first = static_cast<const Vec<N, T>*>(numbers.data());
  return {first, first + numbers.shape(0)};
}

namespace {

std::vector<std::uint32_t> indices_of(Argument argument, py::handle value, std::size_t columns) {
  const py::array array = any_array(argument, value);
  if (array.size() == 0 && array.ndim() <= 2) return {};
  const std::array<std::size_t, 1> allowed = {columns};
  require_columns(argument, array, allowed);
  const char kind = kind_of(array);
  if (kind != 'i' && kind != 'u') {
    throw py::type_error(
        fmt::format("{} has dtype {}; integers are needed", argument.text(), std::string(py::str(array.dtype()))));
  }
  // As int64 only what is above 2^63 changes, and it becomes negative.
  const auto wide = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!wide) throw py::error_already_set();
  std::vector<std::uint32_t> result(static_cast<std::size_t>(wide.size()));
  const std::int64_t* const numbers = wide.data();
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (numbers[i] < 0 || numbers[i] > std::numeric_limits<std::uint32_t>::max()) {
      throw py::index_error(fmt::format("{} has {} in row {}; indices from 0 to 4294967295 are allowed",
                                        argument.text(), numbers[i], i / columns));
    }
    result[i] = static_cast<std::uint32_t>(numbers[i]);
  }
  return result;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> faces_of(Argument argument, py::handle value) {
  const std::vector<std::uint32_t> indices = indices_of(argument, value, 3);
  std::vector<std::array<std::uint32_t, 3>> faces(indices.size() / 3);
  for (std::size_t i = 0; i < indices.size(); ++i) faces[i / 3][i % 3] = indices[i];
  return faces;
}

PairRows::PairRows(Argument argument, py::handle value) {
  if (py::isinstance<py::array_t<std::uint32_t>>(value)) {
    auto array = py::array_t<std::uint32_t, py::array::c_style>::ensure(value);
    if (!array) throw py::error_already_set();
    const std::array<std::size_t, 1> allowed = {2};
    require_columns(argument, array, allowed);
    pairs_ = {reinterpret_cast<const Pair*>(array.data()), static_cast<std::size_t>(array.shape(0))};
    array_ = std::move(array);
    return;
  }
  const std::vector<std::uint32_t> indices = indices_of(argument, value, 2);
  copied_.resize(indices.size() / 2);
  for (std::size_t i = 0; i < copied_.size(); ++i) copied_[i] = {indices[2 * i], indices[2 * i + 1]};
  pairs_ = copied_;
}

std::optional<std::uint64_t> packed_if_possible(Argument argument, py::handle value) {
  const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!index) {
    PyErr_Clear();
    throw py::type_error(
        fmt::format("{} is a {}; an integer is needed", argument.text(), Py_TYPE(value.ptr())->tp_name));
  }
  const unsigned long long number = PyLong_AsUnsignedLongLong(index.ptr());
  if (PyErr_Occurred() == nullptr) return number;
  PyErr_Clear();
  return std::nullopt;
}

std::uint64_t packed_of(Argument argument, py::handle value) {
  if (const auto number = packed_if_possible(argument, value)) return *number;
  throw py::index_error(
      fmt::format("{} is {}, which was never given out", argument.text(), std::string(py::str(value))));
}

PackedNumbers::PackedNumbers(Argument argument, py::handle value) {
  if (py::isinstance<py::array_t<std::uint64_t>>(value)) {
    const auto array = py::array_t<std::uint64_t, py::array::c_style>::ensure(value);
    if (!array) throw py::error_already_set();
    if (array.ndim() != 1) {
      throw py::value_error(fmt::format("{} has shape {}; (n,) is needed", argument.text(), shape_text(array)));
    }
    array_ = array;
    numbers_ = {array.data(), static_cast<std::size_t>(array.size())};
    return;
  }
  if (PySequence_Check(value.ptr()) == 0 || PySequence_Size(value.ptr()) < 0) {
    PyErr_Clear();
    throw py::type_error(
        fmt::format("{} is a {}; a sequence of integers is needed", argument.text(), Py_TYPE(value.ptr())->tp_name));
  }
  const auto list = py::reinterpret_steal<py::object>(PySequence_Tuple(value.ptr()));
  if (!list) throw py::error_already_set();
  for (py::ssize_t i = 0; i < PyTuple_GET_SIZE(list.ptr()); ++i) {
    copied_.push_back(packed_of(argument, PyTuple_GET_ITEM(list.ptr(), i)));
  }
  numbers_ = copied_;
}

double number_of(Argument argument, py::handle value) {
  const double number = PyFloat_AsDouble(value.ptr());
  if (number == -1 && PyErr_Occurred() != nullptr) {
    if (PyErr_ExceptionMatches(PyExc_TypeError) == 0) throw py::error_already_set();
    PyErr_Clear();
    throw py::type_error(fmt::format("{} is a {}; a number is needed", argument.text(), Py_TYPE(value.ptr())->tp_name));
  }
  if (std::isnan(number)) throw py::value_error(fmt::format("{} is not a number (NaN)", argument.text()));
  return number;
}

template <Dim N, class T>
Vec<N, T> vector_of(Argument argument, py::handle value) {
  if (PySequence_Check(value.ptr()) == 0 || PyUnicode_Check(value.ptr()) != 0) {
    throw py::type_error(
        fmt::format("{} is a {}; {} numbers are needed", argument.text(), Py_TYPE(value.ptr())->tp_name, N));
  }
  const py::ssize_t size = PySequence_Size(value.ptr());
  if (size < 0) throw py::error_already_set();
  if (size != N)
    throw py::value_error(fmt::format("{} has {} elements; {} numbers are needed", argument.text(), size, N));
  Vec<N, T> vector;
  for (Dim i = 0; i < N; ++i) {
    const auto element = py::reinterpret_steal<py::object>(PySequence_GetItem(value.ptr(), i));
    if (!element) throw py::error_already_set();
    vector[i] = static_cast<T>(number_of(argument, element));
  }
  return vector;
}

template <Dim N, class T>
Mat<N, T> matrix_of(Argument argument, py::handle value) {
  const std::vector<Vec<N, T>> rows = points_of<N, T>(argument, value);
  if (rows.size() != static_cast<std::size_t>(N)) {
    throw py::value_error(
        fmt::format("{} has {} rows; a matrix of {} x {} numbers is needed", argument.text(), rows.size(), N, N));
  }
  Mat<N, T> matrix;
  for (Dim i = 0; i < N; ++i) {
    for (Dim j = 0; j < N; ++j) matrix[j][i] = rows[static_cast<std::size_t>(i)][j];
  }
  return matrix;
}

template py::array numbers_of<float>(Argument, py::handle, std::span<const std::size_t>, Rowwise);
template py::array numbers_of<double>(Argument, py::handle, std::span<const std::size_t>, Rowwise);
#define GRAZE_PYTHON_ARRAYS(N, T)                                        \
  template std::vector<Vec<N, T>> points_of<N, T>(Argument, py::handle); \
  template Vec<N, T> vector_of<N, T>(Argument, py::handle);              \
  template Mat<N, T> matrix_of<N, T>(Argument, py::handle);
GRAZE_PYTHON_ARRAYS(2, float)
GRAZE_PYTHON_ARRAYS(2, double)
GRAZE_PYTHON_ARRAYS(3, float)
GRAZE_PYTHON_ARRAYS(3, double)
#undef GRAZE_PYTHON_ARRAYS

}  // namespace graze::python
