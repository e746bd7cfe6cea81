// SPDX-License-Identifier: MIT
// What only meshes have, and many rays or points against one mesh.
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include <graze/broad/closest_points.hpp>
#include <graze/broad/self_intersections.hpp>
#include <graze/broad/signed_distances.hpp>
#include <graze/broad/touching/pair_tasks.hpp>
#include <graze/broad/touching_faces.hpp>
#include <graze/broad/winding_numbers.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/shape/mesh_report.hpp>
#include <graze/shape/welded.hpp>

#include "module.hpp"
#include "results.hpp"

namespace graze::python {
namespace {

/// use(mesh) of a shape that is a mesh. Throws TypeError for any other.
template <class Use>
auto on_mesh(const char* function, const HeldShape& shape, const Use& use) {
  return on_shape(shape, [&]<Dim N, class T>(const AnyShape<N, T>& any) {
    const auto* const mesh = std::get_if<Mesh<N, T>>(&any);
    if (mesh == nullptr)
      throw py::type_error(fmt::format("{}: mesh is {}; a Mesh is needed", function, described(shape)));
    return use(*mesh);
  });
}

bool holds_mesh(const HeldShape& shape) {
  return on_shape(shape,
                  []<Dim N, class T>(const AnyShape<N, T>& any) { return std::holds_alternative<Mesh<N, T>>(any); });
}

/// The rows of points, all finite, of the mesh's number type.
template <Dim N, class T>
Rows points_for(const char* function, const py::object& points) {
  const Argument argument{function, "points"};
  Rows rows = rows_in(argument, points, static_cast<std::size_t>(N), In<N, T>::world, "the mesh");
  require_finite(argument, rows);
  return rows;
}

py::object report_of(const HeldShape& shape) {
  static ResultClass report_class("MeshReport");
  return on_mesh("report", shape, [](const auto& mesh) {
    const MeshReport found = without_gil([&] { return report(mesh); });
    return report_class(found.open_edges, found.non_manifold_edges, found.flipped_edges, found.degenerate_faces,
                        found.duplicate_faces, found.unused_vertices, found.components, found.is_closed);
  });
}

double winding_number_of(const HeldShape& shape, const py::object& point) {
  return on_mesh("winding_number", shape, [&]<Dim N, class T>(const Mesh<N, T>& mesh) {
    const auto at = point_of<N, T>({"winding_number", "point"}, point);
    return without_gil([&] { return winding_number(mesh, at); });
  });
}

py::object touching_faces_of(const HeldShape& a, const HeldShape& b) {
  return on_pair("touching_faces", a, b, [&]<Dim N, class T>(const AnyShape<N, T>& in_a, const AnyShape<N, T>& in_b) {
    const auto* const mesh_a = std::get_if<Mesh<N, T>>(&in_a);
    const auto* const mesh_b = std::get_if<Mesh<N, T>>(&in_b);
    if (mesh_a == nullptr || mesh_b == nullptr) throw py::type_error("touching_faces: two meshes are needed");
    return array_of(without_gil([&] { return touching_faces(*mesh_a, *mesh_b); }));
  });
}

py::object self_intersections_of(const HeldShape& shape) {
  return on_mesh("self_intersections", shape,
                 [](const auto& mesh) { return array_of(without_gil([&] { return self_intersections(mesh); })); });
}

py::object moved_mesh(const HeldShape& shape, const py::object& vertices) {
  return on_mesh("moved", shape, [&]<Dim N, class T>(const Mesh<N, T>& mesh) {
    const auto points = points_of<N, T>({"moved", "vertices"}, vertices);
    return python_shape<N, T>(without_gil([&] { return moved<N, T>(mesh, points); }), "moved");
  });
}

py::object welded_mesh(const HeldShape& shape) {
  return on_mesh("welded", shape, [&]<Dim N, class T>(const Mesh<N, T>& mesh) {
    return python_shape<N, T>(without_gil([&] { return welded(mesh); }), "welded");
  });
}

// ---- Batches

/// Two shapes, or a mesh and points.
py::object closest_points_of(const HeldShape& a, const py::object& b, const py::object& threads) {
  if (is_boxed<HeldShape>(b)) {
    return on_pair("closest_points", a, unboxed<HeldShape>(b), [](const auto& in_a, const auto& in_b) {
      return python_result(
          without_gil_if(is_large(in_a) || is_large(in_b), [&] { return closest_points(in_a, in_b); }));
    });
  }
  if (!holds_mesh(a) && !py::isinstance<py::array>(b)) {
    throw py::type_error(fmt::format("closest_points: b is a {}, not a graze.Shape{}", Py_TYPE(b.ptr())->tp_name,
                                     WayOut<HeldShape>::of(b)));
  }
  return on_mesh("closest_points", a, [&]<Dim N, class T>(const Mesh<N, T>& mesh) {
    const Rows rows = points_for<N, T>("closest_points", b);
    const Threads used("closest_points", threads);
    return array_of<T>(without_gil([&] { return closest_points(mesh, rows.as<Vec<N, T>>(), {&used.executor()}); }),
                       static_cast<std::size_t>(N));
  });
}

py::object signed_distances_of(const HeldShape& shape, const py::object& points, const py::object& threads) {
  return on_mesh("signed_distances", shape, [&]<Dim N, class T>(const Mesh<N, T>& mesh) {
    const Rows rows = points_for<N, T>("signed_distances", points);
    const Threads used("signed_distances", threads);
    return array_of<T>(without_gil([&] { return signed_distances(mesh, rows.as<Vec<N, T>>(), {&used.executor()}); }),
                       0);
  });
}

py::object winding_numbers_of(const HeldShape& shape, const py::object& points, const py::object& threads) {
  return on_mesh("winding_numbers", shape, [&]<Dim N, class T>(const Mesh<N, T>& mesh) {
    const Rows rows = points_for<N, T>("winding_numbers", points);
    const Threads used("winding_numbers", threads);
    return array_of<double>(
        without_gil([&] { return winding_numbers(mesh, rows.as<Vec<N, T>>(), {&used.executor()}); }), 0);
  });
}

/// The hits of many rays, by their fields.
template <Dim N, class T>
struct HitColumns {
  explicit HitColumns(std::size_t count)
      : t(count), point(count), normal(count), face(count), barycentric(count), error(count) {}

  void put(std::size_t row, const std::optional<MeshHit<N, T>>& hit) {
    t[row] = hit ? hit->t : std::numeric_limits<T>::infinity();
    point[row] = hit ? hit->point : Vec<N, T>(std::numeric_limits<T>::quiet_NaN());
    normal[row] = hit ? hit->normal : Vec<N, T>(T(0));
    face[row] = hit && hit->face != no_face ? static_cast<std::int64_t>(hit->face) : -1;
    barycentric[row] = hit ? hit->barycentric : Vec<3, T>(T(0));
    error[row] = hit ? hit->error : 0.0;
  }

  NewRows<T> t;
  NewRows<Vec<N, T>> point;
  NewRows<Vec<N, T>> normal;
  NewRows<std::int64_t> face;
  NewRows<Vec<3, T>> barycentric;
  NewRows<double> error;
};

constexpr std::size_t rays_per_task = 256;

/// Throws ValueError, naming the row, for a ray without a direction.
template <Dim N, class T>
void require_directions(std::span<const Ray<N, T>> rays) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (max_abs(rays[i].direction) > 0) continue;
    throw py::value_error(fmt::format("ray_casts: the ray of row {} has a direction of length zero", i));
  }
}

py::object ray_casts_of(const HeldShape& shape, const py::object& rays, const py::object& threads) {
  static ResultClass hits_class("RayHits");
  return on_mesh("ray_casts", shape, [&]<Dim N, class T>(const Mesh<N, T>& mesh) {
    const Argument argument{"ray_casts", "rays"};
    constexpr auto columns = static_cast<std::size_t>(N);
    const Rows rows = rows_in(argument, rays, 2 * columns, In<N, T>::world, "the mesh");
    require_finite(argument, rows);
    require_directions(rows.as<Ray<N, T>>());
    const Threads used("ray_casts", threads);
    HitColumns<N, T> hits(rows.count);
    without_gil([&] {  // as graze::ray_casts, but straight to columns
      const auto all = rows.as<Ray<N, T>>();
      detail::in_tasks(all.size(), rays_per_task, used.executor(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) hits.put(i, ray_cast(mesh, all[i]));
      });
    });
    return hits_class(array_of<T>(std::move(hits.t), 0), array_of<T>(std::move(hits.point), columns),
                      array_of<T>(std::move(hits.normal), columns), array_of<std::int64_t>(std::move(hits.face), 0),
                      array_of<T>(std::move(hits.barycentric), 3), array_of<double>(std::move(hits.error), 0));
  });
}

}  // namespace

void add_meshes(py::module_& module) {
  const py::arg mesh("mesh");
  const py::arg points("points");
  const py::arg_v threads("threads", py::none(), "None");
  module.def("report", &report_of, mesh, "What is unusual about a mesh: a MeshReport.");
  module.def("winding_number", &winding_number_of, mesh, py::arg("point"),
             "How often the faces run around a point (N,): above 1/2 inside, also for open and dirty meshes.");
  module.def("touching_faces", &touching_faces_of, py::arg("a"), py::arg("b"),
             "All pairs of faces of two meshes that share a point: (n, 2) of uint32, ascending.");
  module.def("self_intersections", &self_intersections_of, mesh,
             "All pairs of faces that share more than their common vertices and edges: (n, 2) of uint32, ascending.");
  module.def("moved", &moved_mesh, mesh, py::arg("vertices"),
             "The same faces with other vertices, (n, N): faster than a new mesh.");
  module.def("welded", &welded_mesh, mesh, "The same faces on vertices of which no two are equal.");
  module.def("closest_points", &closest_points_of, py::arg("a"), py::arg("b"), py::kw_only(), threads,
             "The Proximity of two shapes; for a mesh and points (n, N) the nearest points of the mesh, (n, N).");
  module.def("signed_distances", &signed_distances_of, mesh, points, py::kw_only(), threads,
             "The distances of points (n, N) from the nearest face, negative inside a solid: (n,).");
  module.def("winding_numbers", &winding_numbers_of, mesh, points, py::kw_only(), threads,
             "winding_number of points (n, N): (n,).");
  module.def("ray_casts", &ray_casts_of, mesh, py::arg("rays"), py::kw_only(), threads,
             "The first hits of rays (n, 2 * N), origins and directions: RayHits.");
}

}  // namespace graze::python
