// SPDX-License-Identifier: MIT
// Equality and hash of shapes in Python.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <pybind11/pybind11.h>

#include <graze/math/platform/bit_cast.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/mesh.hpp>

#include "boxed.hpp"

namespace graze::python {

/// Of numbers that are equal if the shapes are: minus zero counts as zero.
class Hash {
 public:
  void add(std::uint64_t bits) { hash_ = (hash_ ^ bits ^ (hash_ >> 29U)) * 0x9e3779b97f4a7c15U; }
  void add(double number) { add(bit_cast<std::uint64_t>(number + 0.0)); }
  void add(float number) { add(static_cast<double>(number)); }
  template <Dim N, class T>
  void add(const Vec<N, T>& vector) {
    for (Dim i = 0; i < N; ++i) add(vector[i]);
  }
  template <Dim N, class T>
  void add(const Mat<N, T>& matrix) {
    for (Dim i = 0; i < N; ++i) add<N, T>(matrix[i]);
  }
  template <Dim N, class T>
  void add(std::span<const Vec<N, T>> points) {
    for (const Vec<N, T>& point : points) add<N, T>(point);
  }
  void add(std::span<const std::array<std::uint32_t, 3>> faces) {
    for (const auto& face : faces) {
      for (const std::uint32_t vertex : face) add(std::uint64_t{vertex});
    }
  }
  void add(MeshKind kind) { add(static_cast<std::uint64_t>(kind)); }
  template <Dim N, class T>
  void add(const Parts<N, T>& parts) {
    for (const Part<N, T>& part : parts) add<N, T>(part.shape);
  }
  template <Dim N, class T>
  void add(const AnyShape<N, T>& shape) {
    add(static_cast<std::uint64_t>(shape.index()));
    detail::visit(
        [this](const auto& held) {
          detail::for_each_field(held, [this](const auto&, const auto& value) { this->add(value); });
        },
        shape);
  }

  py::ssize_t value() const { return static_cast<py::ssize_t>(hash_ >> 1U); }

 private:
  std::uint64_t hash_ = 1;
};

template <class Value>
void add_equality(TypeMaker& maker, bool (*are_equal)(const Value&, const Value&),
                  py::ssize_t (*hash_of)(const Value&)) {
  maker.method("__eq__", [are_equal](const Value& a, const py::object& b) -> py::object {
    if (!is_boxed<Value>(b)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
    return py::bool_(are_equal(a, unboxed<Value>(b)));
  });
  maker.method("__hash__", hash_of);
}

}  // namespace graze::python
