// SPDX-License-Identifier: MIT
// Rays and moving shapes.
#include <limits>
#include <string>

#include <fmt/format.h>

#include <graze/query/ray_cast.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/time_of_impact.hpp>

#include "module.hpp"
#include "results.hpp"

namespace graze::python {
namespace {

RaySide side_of(const std::string& side) {
  if (side == "entry") return RaySide::entry;
  if (side == "exit") return RaySide::exit;
  throw py::value_error(fmt::format("ray_cast: side is '{}'; 'entry' or 'exit' is needed", side));
}

template <Dim N, class T>
py::object hit_of_ray(const AnyShape<N, T>& shape, const Ray<N, T>& ray, double t_max, RayOptions options) {
  if (const auto* const mesh = std::get_if<Mesh<N, T>>(&shape)) {
    return python_result(without_gil([&] { return ray_cast(*mesh, ray, static_cast<T>(t_max), options); }));
  }
  return python_result(
      without_gil_if(is_large(shape), [&] { return ray_cast(shape, ray, static_cast<T>(t_max), options); }));
}

py::object ray_cast_of(const HeldShape& shape, const HeldShape& ray, const py::object& t_max, const std::string& side) {
  const double latest = number_of({"ray_cast", "t_max"}, t_max);
  const RayOptions options{side_of(side)};
  return on_pair("ray_cast", shape, ray, [&]<Dim N, class T>(const AnyShape<N, T>& any, const AnyShape<N, T>& way) {
    if (const auto* const of_ray = std::get_if<Ray<N, T>>(&way)) return hit_of_ray(any, *of_ray, latest, options);
    const auto* const segment = std::get_if<Segment<N, T>>(&way);
    if (segment == nullptr)
      throw py::type_error("ray_cast: ray is " + described(ray) + "; a Ray or a Segment is needed");
    return python_result(without_gil_if(is_large(any), [&] { return ray_cast(any, *segment, options); }));
  });
}

py::object shape_cast_of(const HeldShape& a, const py::object& motion, const HeldShape& b, bool ignore_initial_touch,
                         const py::object& target_distance) {
  const CastOptions options{.ignore_initial_touch = ignore_initial_touch,
                            .target_distance = length_of({"shape_cast", "target_distance"}, target_distance)};
  return on_pair("shape_cast", a, b, [&]<Dim N, class T>(const AnyShape<N, T>& in_a, const AnyShape<N, T>& in_b) {
    const auto way = point_of<N, T>({"shape_cast", "motion"}, motion);
    return python_result(
        without_gil_if(is_large(in_a) || is_large(in_b), [&] { return shape_cast(in_a, way, in_b, options); }));
  });
}

py::object time_of_impact_of(const HeldShape& a, const py::object& motion_a, const HeldShape& b,
                             const py::object& motion_b) {
  return on_pair("time_of_impact", a, b, [&]<Dim N, class T>(const AnyShape<N, T>& in_a, const AnyShape<N, T>& in_b) {
    const auto way_a = motion_of<N, T>({"time_of_impact", "motion_a"}, motion_a);
    const auto way_b = motion_of<N, T>({"time_of_impact", "motion_b"}, motion_b);
    return python_result(without_gil([&] { return time_of_impact(in_a, way_a, in_b, way_b); }));
  });
}

}  // namespace

void add_casts(py::module_& module) {
  module.def(
      "ray_cast", &ray_cast_of, py::arg("shape"), py::arg("ray"),
      py::arg("t_max") = std::numeric_limits<double>::infinity(), py::arg("side") = "entry",
      "Where a Ray, or a Segment, enters a shape, or leaves it (side='exit'): a RayHit, for a mesh a MeshHit, or "
      "None. t_max is in units of the ray's direction.");
  module.def("shape_cast", &shape_cast_of, py::arg("a"), py::arg("motion"), py::arg("b"), py::kw_only(),
             py::arg("ignore_initial_touch") = false, py::arg("target_distance") = 0.0,
             "When a, which moves by the vector `motion`, first touches b: an Impact, or None.");
  module.def(
      "time_of_impact", &time_of_impact_of, py::arg("a"), py::arg("motion_a"), py::arg("b"),
      py::arg("motion_b") = py::none(),
      "When two shapes that move and rotate first touch: an Impact, or None. A motion is a Motion, a vector, or None.");
}

}  // namespace graze::python
