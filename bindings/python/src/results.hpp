// SPDX-License-Identifier: MIT
// The results of queries as the named tuples of graze/_results.py.
#pragma once

#include <optional>
#include <utility>

#include <pybind11/pybind11.h>

#include <graze/query/contact.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/mesh_hit.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/query/verdict.hpp>

#include "arrays.hpp"

namespace graze::python {

/// A class of graze._results, found at its first use.
class ResultClass {
 public:
  constexpr explicit ResultClass(const char* name) : name_(name) {}

  template <class... Values>
  py::object operator()(Values&&... values) {
    if (!class_) class_ = py::object(py::module_::import("graze._results").attr(name_)).release();
    return class_(std::forward<Values>(values)...);
  }

 private:
  const char* name_;
  py::handle class_;  ///< As long as the program runs.
};

py::str python_word(Relation relation);
py::str python_word(Status status);

template <Dim N, class T>
py::object python_result(const Proximity<N, T>& proximity);
template <Dim N, class T>
py::object python_result(const Contact<N, T>& contact);
template <Dim N, class T>
py::object python_result(const Manifold<N, T>& manifold);
template <Dim N, class T>
py::object python_result(const RayHit<N, T>& hit);
template <Dim N, class T>
py::object python_result(const MeshHit<N, T>& hit);
template <Dim N, class T>
py::object python_result(const Impact<N, T>& impact);

/// None without a value.
template <class Value>
py::object python_result(const std::optional<Value>& value) {
  return value ? python_result(*value) : py::none();
}

}  // namespace graze::python
