// SPDX-License-Identifier: MIT
#include "module.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include <graze/io/input_error.hpp>
#include <graze/io/output_error.hpp>
#include <graze/math/rotation.hpp>

namespace graze::python {

Threads::Threads(const char* function, const py::object& threads) {
  if (threads.is_none()) return;
  if (PyLong_Check(threads.ptr()) == 0) {
    throw py::type_error(
        fmt::format("{}: threads is a {}; None or an integer is needed", function, Py_TYPE(threads.ptr())->tp_name));
  }
  const long long count = PyLong_AsLongLong(threads.ptr());
  if (PyErr_Occurred() != nullptr) PyErr_Clear();
  if (count < 1 || count > 4096) throw py::value_error(fmt::format("{}: threads is not from 1 to 4096", function));
  limited_ = limited_executor(static_cast<std::size_t>(count));
}

World world_of_words(const char* type, const py::object& dimension, const py::object& dtype) {
  const double given = number_of({type, "dimension"}, dimension);
  if (given != 2 && given != 3)
    throw py::value_error(fmt::format("{}: dimension is {}; 2 or 3 is needed", type, given));
  return {static_cast<Dim>(given), is_double_dtype(dtype)};
}

template <Dim N, class T>
Vec<N, T> point_of(Argument argument, py::handle value) {
  const auto point = vector_of<N, T>(argument, value);
  if (!is_finite<N, T>(point)) throw py::value_error(argument.text() + " has a coordinate that is not finite");
  return point;
}

double length_of(Argument argument, py::handle value) {
  const double length = number_of(argument, value);
  if (length >= 0 && std::isfinite(length)) return length;
  throw py::value_error(fmt::format("{} is {}; a finite number of 0 or more is needed", argument.text(), length));
}

template <Dim N, class T>
Motion<N, T> motion_of(Argument argument, py::handle value) {
  Motion<N, T> motion;
  if (value.is_none()) return motion;
  if (!py::hasattr(value, "linear")) {
    motion.linear = vector_of<N, T>(argument, value);
  } else {
    const py::object linear = value.attr("linear");
    const py::object angular = value.attr("angular");
    const py::object center = value.attr("center");
    if (!linear.is_none()) motion.linear = vector_of<N, T>(argument, linear);
    if (!center.is_none()) motion.center = vector_of<N, T>(argument, center);
    if (!angular.is_none()) {
      if constexpr (N == 2) {
        motion.angular = static_cast<T>(number_of(argument, angular));
      } else {
        motion.angular = vector_of<N, T>(argument, angular);
      }
    }
  }
  if (!is_finite(motion)) throw py::value_error(argument.text() + " has a number that is not finite");
  return motion;
}

template <Dim N, class T>
Pose<N, T> pose_of(Argument argument, py::handle value) {
  Pose<N, T> pose;
  const py::object given = py::hasattr(value, "rotation")
                               ? py::reinterpret_borrow<py::object>(value)
                               : py::module_::import("graze._shapes").attr("Pose").attr("from_matrix")(value);
  pose.rotation = matrix_of<N, T>(argument, given.attr("rotation"));
  pose.position = point_of<N, T>(argument, given.attr("position"));
  if (!(orthonormal_error(pose.rotation) <= tolerance::orthonormal)) {
    throw py::value_error(argument.text() +
                          " has a rotation whose columns are not orthonormal (unit length, at right angles)");
  }
  if (glm::determinant(pose.rotation) < 0) {
    throw py::value_error(argument.text() +
                          " has a reflection instead of a rotation; to mirror a mesh, mirror its "
                          "vertices and reverse the order in its faces");
  }
  return pose;
}

namespace {

py::array rotation_about(const py::object& axis, const py::object& radians) {
  const auto about = vector_of<3, double>({"rotation_from_axis_angle", "axis"}, axis);
  return frozen_matrix<3, double>(
      rotation_from_axis_angle(about, number_of({"rotation_from_axis_angle", "radians"}, radians)));
}

struct QuaternionNumbers {
  double x, y, z, w;
};

py::array rotation_by_quaternion(const py::object& quaternion) {
  const Argument argument{"rotation_from_quaternion", "quaternion"};
  if (PySequence_Check(quaternion.ptr()) == 0 || PySequence_Size(quaternion.ptr()) != 4) {
    PyErr_Clear();
    throw py::value_error(argument.text() + " needs four numbers: x, y, z, w");
  }
  const auto at = [&](py::ssize_t i) {
    const auto number = py::reinterpret_steal<py::object>(PySequence_GetItem(quaternion.ptr(), i));
    if (!number) throw py::error_already_set();
    return number_of(argument, number);
  };
  return frozen_matrix<3, double>(rotation_from_quaternion(QuaternionNumbers{at(0), at(1), at(2), at(3)}));
}

void add_errors(py::module_& module) {
  py::register_exception<io::InputError>(module, "InputError", PyExc_ValueError);
  py::register_exception<io::OutputError>(module, "OutputError", PyExc_ValueError);
}

}  // namespace

#define GRAZE_PYTHON_ARGUMENTS(N, T)                           \
  template Vec<N, T> point_of<N, T>(Argument, py::handle);     \
  template Motion<N, T> motion_of<N, T>(Argument, py::handle); \
  template Pose<N, T> pose_of<N, T>(Argument, py::handle);
GRAZE_PYTHON_ARGUMENTS(2, float)
GRAZE_PYTHON_ARGUMENTS(2, double)
GRAZE_PYTHON_ARGUMENTS(3, float)
GRAZE_PYTHON_ARGUMENTS(3, double)
#undef GRAZE_PYTHON_ARGUMENTS

PYBIND11_MODULE(_graze, module) {  // NOLINT(readability-function-size)
  module.attr("__version__") = GRAZE_VERSION;
  add_errors(module);
  add_shapes(module);
  add_shape_list(module);
  add_queries(module);
  add_casts(module);
  add_constructions(module);
  add_meshes(module);
  add_pairs(module);
  add_indexes(module);
  add_scenes(module);
  add_files(module);
  add_mesh_files(module);
  module.def("rotation_from_angle", [](const py::object& radians) {
    return frozen_matrix<2, double>(rotation_from_angle(number_of({"rotation_from_angle", "radians"}, radians)));
  });
  module.def("rotation_from_axis_angle", &rotation_about);
  module.def("rotation_from_quaternion", &rotation_by_quaternion);
}

}  // namespace graze::python
