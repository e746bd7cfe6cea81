// SPDX-License-Identifier: MIT
// Shapes from points, and shapes from shapes.
#include <vector>

#include <fmt/format.h>

#include <graze/query/bounding.hpp>
#include <graze/query/convex_parts.hpp>
#include <graze/query/transformed.hpp>

#include "module.hpp"

namespace graze::python {
namespace {

/// make(points), a shape around points of any number type.
template <class Make>
py::object around_points(const char* function, const py::object& points, const py::object& dtype, const Make& make) {
  const Argument argument{function, "points"};
  const World world{columns_of_points(argument, points), is_double_dtype(dtype)};
  return in_world(world, [&]<Dim N, class T>(In<N, T>) {
    const std::vector<Vec<N, T>> all = points_of<N, T>(argument, points);
    return python_shape<N, T>(without_gil([&] { return AnyShape<N, T>(make(all)); }), function);
  });
}

py::object hull_of(const py::object& points, const py::object& dtype) {
  return around_points("convex_hull", points, dtype, [](const auto& all) { return convex_hull(all); });
}
py::object box_of(const py::object& points, const py::object& dtype) {
  return around_points("bounding_box", points, dtype, [](const auto& all) { return bounding_box(all); });
}
py::object sphere_of(const py::object& points, const py::object& dtype) {
  return around_points("bounding_sphere", points, dtype, [](const auto& all) { return bounding_sphere(all); });
}
py::object fast_sphere_of(const py::object& points, const py::object& dtype) {
  return around_points("bounding_sphere_fast", points, dtype,
                       [](const auto& all) { return bounding_sphere_fast(all); });
}
py::object obb_of(const py::object& points, const py::object& dtype) {
  return around_points("bounding_obb", points, dtype, [](const auto& all) { return bounding_obb(all); });
}

py::object transformed_shape(const HeldShape& shape, const py::object& pose) {
  return on_shape(shape, [&]<Dim N, class T>(const AnyShape<N, T>& any) {
    const auto by = pose_of<N, T>({"transformed", "pose"}, pose);
    return python_shape<N, T>(transformed(any, by), "transformed: the result");
  });
}

py::object translated_shape(const HeldShape& shape, const py::object& offset) {
  return on_shape(shape, [&]<Dim N, class T>(const AnyShape<N, T>& any) {
    const auto by = point_of<N, T>({"translated", "offset"}, offset);
    return python_shape<N, T>(translated<N, T>(any, by), "translated: the result");
  });
}

py::list parts_of_polygon(const py::object& polygon) {
  const auto corners = points_of<2, double>({"convex_parts", "polygon"}, polygon);
  auto parts = convex_parts<double>(corners);
  if (!parts) {
    throw py::value_error("convex_parts: the outline crosses or touches itself, or has a number that is not finite");
  }
  py::list arrays;
  for (auto& part : *parts) arrays.append(array_of<double>(std::move(part), 2));
  return arrays;
}

}  // namespace

void add_constructions(py::module_& module) {
  const py::arg points("points");
  const py::arg_v dtype("dtype", py::none(), "numpy.float64");
  module.def("convex_hull", &hull_of, points, py::kw_only(), dtype,
             "The convex hull of points (n, N), as a Polytope whose corners are sorted.");
  module.def("bounding_box", &box_of, points, py::kw_only(), dtype, "The least Aabb around points (n, N).");
  module.def("bounding_sphere", &sphere_of, points, py::kw_only(), dtype, "The least Sphere around points (n, N).");
  module.def("bounding_sphere_fast", &fast_sphere_of, points, py::kw_only(), dtype,
             "A slightly larger Sphere around points (n, N), sooner.");
  module.def("bounding_obb", &obb_of, points, py::kw_only(), dtype,
             "An Obb around points (n, N): in 2D the one of least area, in 3D one of small surface.");
  module.def("transformed", &transformed_shape, py::arg("shape"), py::arg("pose"),
             "A shape moved by a Pose or a homogeneous matrix, (N + 1, N + 1). An Aabb becomes an Obb.");
  module.def("translated", &translated_shape, py::arg("shape"), py::arg("offset"),
             "A shape moved by a vector; an Aabb stays one.");
  module.def("convex_parts", &parts_of_polygon, py::arg("polygon"),
             "Cuts a simple polygon, (n, 2), into convex ones: a list of arrays (m, 2).");
}

}  // namespace graze::python
