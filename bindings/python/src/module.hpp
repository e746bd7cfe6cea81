// SPDX-License-Identifier: MIT
// The parts of the module, each in a file of its own, and what they share.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <pybind11/pybind11.h>

#include <graze/broad/executor.hpp>
#include <graze/math/motion.hpp>

#include "arrays.hpp"
#include "shape.hpp"

namespace graze::python {

void add_queries(py::module_& module);
void add_casts(py::module_& module);
void add_constructions(py::module_& module);
void add_meshes(py::module_& module);
void add_pairs(py::module_& module);
void add_indexes(py::module_& module);
void add_scenes(py::module_& module);
void add_files(py::module_& module);
void add_mesh_files(py::module_& module);

/// ask() while other Python threads run.
template <class Ask>
auto without_gil(const Ask& ask) {
  const py::gil_scoped_release released;
  return ask();
}

/// The same only for work that may take long, because letting go and taking again takes longer than a small query.
template <class Ask>
auto without_gil_if(bool is_long, const Ask& ask) {
  std::optional<py::gil_scoped_release> released;
  if (is_long) released.emplace();
  return ask();
}

/// The executor of a batch from its argument `threads`: None for all cores, or a number from 1 on.
class Threads {
 public:
  Threads(const char* function, const py::object& threads);

  const Executor& executor() const { return limited_ ? *limited_ : default_executor(); }

 private:
  std::unique_ptr<Executor> limited_;
};

/// The world of a container, from its arguments `dimension` and `dtype`.
World world_of_words(const char* type, const py::object& dimension, const py::object& dtype);

/// A point whose coordinates are finite.
template <Dim N, class T>
Vec<N, T> point_of(Argument argument, py::handle value);

/// A length: finite and at least zero.
double length_of(Argument argument, py::handle value);

/// A graze.Motion, or only a vector for its linear part, or None for no motion.
template <Dim N, class T>
Motion<N, T> motion_of(Argument argument, py::handle value);

/// A graze.Pose or anything with `rotation` and `position`, or a homogeneous matrix.
template <Dim N, class T>
Pose<N, T> pose_of(Argument argument, py::handle value);

}  // namespace graze::python
