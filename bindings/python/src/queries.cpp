// SPDX-License-Identifier: MIT
// Questions about two shapes, and about a shape and points.
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include <graze/broad/batch/answers.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/separation.hpp>
#include <graze/query/signed_distance.hpp>

#include "module.hpp"
#include "results.hpp"

namespace graze::python {
namespace {

/// ask(a, b) of two shapes of one world, without the GIL if it may take long.
template <class Ask>
auto ask_pair(const char* function, const HeldShape& a, const HeldShape& b, const Ask& ask) {
  return on_pair(function, a, b, [&](const auto& in_a, const auto& in_b) {
    return without_gil_if(is_large(in_a) || is_large(in_b), [&] { return ask(in_a, in_b); });
  });
}

bool do_intersect(const HeldShape& a, const HeldShape& b) {
  return ask_pair("intersects", a, b, [](const auto& in_a, const auto& in_b) { return intersects(in_a, in_b); });
}

py::str relation_of(const HeldShape& a, const HeldShape& b) {
  return python_word(
      ask_pair("relation", a, b, [](const auto& in_a, const auto& in_b) { return relation(in_a, in_b); }));
}

double distance_of(const HeldShape& a, const HeldShape& b) {
  return ask_pair("distance", a, b, [](const auto& in_a, const auto& in_b) -> double { return distance(in_a, in_b); });
}

/// The result of a query on two shapes whose type depends on their world.
template <class Ask>
py::object result_of_pair(const char* function, const HeldShape& a, const HeldShape& b, const Ask& ask) {
  return on_pair(function, a, b, [&](const auto& in_a, const auto& in_b) {
    return python_result(without_gil_if(is_large(in_a) || is_large(in_b), [&] { return ask(in_a, in_b); }));
  });
}

py::object separation_of(const HeldShape& a, const HeldShape& b) {
  return result_of_pair("separation", a, b, [](const auto& in_a, const auto& in_b) { return separation(in_a, in_b); });
}

py::object contact_of(const HeldShape& a, const HeldShape& b, const py::object& margin) {
  const ContactOptions options{.margin = length_of({"contact", "margin"}, margin)};
  return result_of_pair("contact", a, b,
                        [options](const auto& in_a, const auto& in_b) { return contact(in_a, in_b, options); });
}

py::object manifold_of(const HeldShape& a, const HeldShape& b, const py::object& margin) {
  const ContactOptions options{.margin = length_of({"manifold", "margin"}, margin)};
  return result_of_pair("manifold", a, b,
                        [options](const auto& in_a, const auto& in_b) { return manifold(in_a, in_b, options); });
}

// ---- intersects, called without pybind11, whose dispatch takes longer than the query

/// The general function, for keywords, errors, and queries that may take long.
PyObject* general_intersects = nullptr;

/// The verdict on two small shapes of one world; none otherwise.
std::optional<bool> quick_verdict(PyObject* const* arguments) {
  if (!is_boxed<HeldShape>(arguments[0]) || !is_boxed<HeldShape>(arguments[1])) return std::nullopt;
  const auto& a = unboxed<HeldShape>(arguments[0]);
  const auto& b = unboxed<HeldShape>(arguments[1]);
  if (a.any.index() != b.any.index()) return std::nullopt;
  return on_pair("intersects", a, b, [](const auto& in_a, const auto& in_b) -> std::optional<bool> {
    if (is_large(in_a) || is_large(in_b)) return std::nullopt;
    return intersects(in_a, in_b);
  });
}

PyObject* call_intersects(PyObject* /*module*/, PyObject* const* arguments, py::ssize_t count, PyObject* names) {
  if (names == nullptr && count == 2) {
    try {
      if (const std::optional<bool> verdict = quick_verdict(arguments)) return PyBool_FromLong(*verdict ? 1 : 0);
    } catch (...) {  // the general function meets the same error and reports it
    }
  }
  return PyObject_Vectorcall(general_intersects, arguments, static_cast<std::size_t>(count), names);
}

PyMethodDef intersects_method = {
    "intersects", reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(&call_intersects)),
    METH_FASTCALL | METH_KEYWORDS, "intersects(a, b)\n--\n\nWhether two shapes share a point; touching counts."};

void add_intersects(py::module_& module) {
  general_intersects =
      py::cpp_function(&do_intersect, py::name("intersects"), py::arg("a"), py::arg("b")).release().ptr();
  module.attr("intersects") = py::reinterpret_steal<py::object>(
      PyCFunction_NewEx(&intersects_method, nullptr, py::str("graze").release().ptr()));
}

// ---- A shape and points

/// One answer for a point, or an array of them for an array of points with two axes.
template <class Number, class Ask>
py::object ask_points(const char* function, const HeldShape& shape, const py::object& points, const py::object& threads,
                      const Ask& ask) {
  const bool are_many = has_rows(points);
  return on_shape(shape, [&]<Dim N, class T>(const AnyShape<N, T>& any) -> py::object {
    if (!are_many) {
      const auto point = point_of<N, T>({function, "point"}, points);
      return py::cast(static_cast<Number>(without_gil_if(is_large(any), [&] { return ask(any, point); })));
    }
    const Argument argument{function, "points"};
    const Rows rows = rows_in(argument, points, static_cast<std::size_t>(N), In<N, T>::world, "the shape");
    require_finite(argument, rows);
    const Threads used(function, threads);
    using Answer = std::conditional_t<std::is_same_v<Number, bool>, std::uint8_t, T>;
    auto answers = without_gil([&] {
      const auto all = rows.as<Vec<N, T>>();
      return detail::answers<Answer>(all.size(), {&used.executor()},
                                     [&](std::size_t i) { return static_cast<Answer>(ask(any, all[i])); });
    });
    py::array array = array_of<Answer>(std::move(answers), 0);
    return std::is_same_v<Number, bool> ? py::object(array.attr("view")("bool")) : py::object(array);
  });
}

py::object contains_points(const HeldShape& shape, const py::object& point, const py::object& threads) {
  return ask_points<bool>("contains", shape, point, threads,
                          [](const auto& any, const auto& at) { return contains(any, at); });
}

py::object signed_distance_to(const HeldShape& shape, const py::object& point) {
  return on_shape(shape, [&]<Dim N, class T>(const AnyShape<N, T>& any) -> py::object {
    const auto at = point_of<N, T>({"signed_distance", "point"}, point);
    return py::float_(without_gil_if(is_large(any), [&] { return static_cast<double>(signed_distance(any, at)); }));
  });
}

py::object closest_point_of(const HeldShape& shape, const py::object& point) {
  return on_shape(shape, [&]<Dim N, class T>(const AnyShape<N, T>& any) -> py::object {
    const auto at = point_of<N, T>({"closest_point", "point"}, point);
    return frozen_vector<N, T>(without_gil_if(is_large(any), [&] { return closest_point(any, at); }));
  });
}

py::object boundary_point_of(const HeldShape& shape, const py::object& point) {
  return on_shape(shape, [&]<Dim N, class T>(const AnyShape<N, T>& any) -> py::object {
    const auto at = point_of<N, T>({"closest_boundary_point", "point"}, point);
    return frozen_vector<N, T>(without_gil_if(is_large(any), [&] { return closest_boundary_point(any, at); }));
  });
}

// ---- One shape

template <Dim N, class T>
py::object boxes_of_all(std::span<const AnyShape<N, T>> shapes) {
  std::vector<Aabb<N, T>> boxes;
  boxes.reserve(shapes.size());
  for (const AnyShape<N, T>& shape : shapes) boxes.push_back(bounds(shape));
  return array_of<T>(std::move(boxes), 2 * static_cast<std::size_t>(N));
}

py::object bounds_of(const py::object& shape) {
  if (is_boxed<HeldShape>(shape)) {
    return on_shape(unboxed<HeldShape>(shape), []<Dim N, class T>(const AnyShape<N, T>& any) -> py::object {
      const Aabb<N, T> box = bounds(any);
      return frozen_array<T>(&box.min[0], {static_cast<py::ssize_t>(2 * N)});
    });
  }
  return in_world(world_of_shapes("bounds", shape), [&]<Dim N, class T>(In<N, T>) {
    return boxes_of_all<N, T>(ShapeSequence<N, T>("bounds", shape).any());
  });
}

py::object mass_properties_of(const HeldShape& shape) {
  static ResultClass mass_class("MassProperties");
  return on_shape(shape, []<Dim N, class T>(const AnyShape<N, T>& any) {
    const MassProperties<N> mass = without_gil_if(is_large(any), [&] { return mass_properties(any); });
    const py::object centroid = frozen_vector<N, double>(mass.centroid);
    if constexpr (N == 2) {
      return mass_class(mass.volume, centroid, mass.inertia);
    } else {
      return mass_class(mass.volume, centroid, frozen_matrix<3, double>(mass.inertia));
    }
  });
}

}  // namespace

void add_queries(py::module_& module) {
  const py::arg a("a");
  const py::arg b("b");
  const py::arg shape("shape");
  const py::arg point("point");
  add_intersects(module);
  module.def(
      "relation", &relation_of, a, b,
      "'apart', 'touching' or 'overlapping'. 'touching': the gap or depth is zero or below the rounding error; the "
      "other two are certain.");
  module.def("distance", &distance_of, a, b, "The distance of two shapes; 0 if and only if they touch or overlap.");
  module.def("separation", &separation_of, a, b,
             "A Proximity whose distance is minus the depth if the shapes overlap.");
  module.def("contact", &contact_of, a, b, py::arg("margin") = 0.0,
             "The Contact of shapes that touch or overlap, or that are at most `margin` apart; else None.");
  module.def("manifold", &manifold_of, a, b, py::arg("margin") = 0.0,
             "The contact points of two shapes, up to 2 in 2D and 4 in 3D: a Manifold.");
  module.def("contains", &contains_points, shape, point, py::kw_only(), py::arg("threads") = py::none(),
             "Whether a point (N,) belongs to a shape, its surface included; for points (n, N) an array of bool.");
  module.def("signed_distance", &signed_distance_to, shape, point,
             "The distance of a point (N,) from the surface of a shape, negative inside.");
  module.def("closest_point", &closest_point_of, shape, point,
             "The point of a shape nearest to a point (N,); the point itself if a solid contains it.");
  module.def("closest_boundary_point", &boundary_point_of, shape, point,
             "The point of a shape's surface nearest to a point (N,).");
  module.def(
      "bounds", &bounds_of, shape,
      "The box around a shape, (2 * N,): minima, then maxima, rounded outward, infinite where the shape is. For a "
      "sequence of shapes an array of boxes, (n, 2 * N).");
  module.def("mass_properties", &mass_properties_of, shape, "Volume, centroid and inertia at density 1.");
}

}  // namespace graze::python
