// SPDX-License-Identifier: MIT
// CGAL's AABB_tree and Side_of_triangle_mesh, with the kernel Simple_cartesian<double>: the fastest one, whose
// decisions are rounded, as those of a user who wants speed.
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include "contestant.hpp"

namespace mesh_bench {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Corner = Kernel::Point_3;
using Corners = std::vector<Kernel::Triangle_3>;
/// Triangles one after another: the fastest for closest points.
using Soup = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Corners::const_iterator>>>;
using SurfaceMesh = CGAL::Surface_mesh<Corner>;
/// What Side_of_triangle_mesh requires.
using FaceTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<SurfaceMesh>>>;
using Side = CGAL::Side_of_triangle_mesh<SurfaceMesh, Kernel>;

Corner corner_of(const Point& point) {
  const graze::Vec<3, double> wide(point);
  return {wide.x, wide.y, wide.z};
}

SurfaceMesh mesh_of(const Surface& surface) {
  SurfaceMesh mesh;
  for (const Point& vertex : surface.vertices) mesh.add_vertex(corner_of(vertex));
  using Index = SurfaceMesh::Vertex_index;
  for (const Face& face : surface.faces) mesh.add_face(Index(face[0]), Index(face[1]), Index(face[2]));
  return mesh;
}

/// Also false if CGAL refuses a face, because it is not manifold or oriented unlike its neighbour.
bool is_closed(const Surface& surface) {
  const SurfaceMesh mesh = mesh_of(surface);
  return mesh.number_of_faces() == surface.faces.size() && CGAL::is_closed(mesh);
}

/// The vertices must keep their places in memory, so it is not moved.
struct Solid {
  explicit Solid(const Surface& surface)
      : mesh(mesh_of(surface)), tree(faces(mesh).first, faces(mesh).second, mesh), side(tree) {
    tree.build();
  }

  SurfaceMesh mesh;
  FaceTree tree;
  Side side;
};

class OfCgal {
 public:
  explicit OfCgal(const Course& course) : course_(course) {}

  void clear() {
    soup_.reset();
    corners_ = {};
  }
  void build() {
    const Surface& surface = course_.surface;
    corners_.reserve(surface.faces.size());
    for (const Face& face : surface.faces) {
      corners_.emplace_back(corner_of(surface.vertices[face[0]]), corner_of(surface.vertices[face[1]]),
                            corner_of(surface.vertices[face[2]]));
    }
    soup_ = std::make_unique<Soup>(corners_.begin(), corners_.end());
    soup_->build();
    soup_->accelerate_distance_queries();
  }
  void build_if_needed() {
    if (!soup_) build();
  }
  void build_solid_if_needed() {
    if (!solid_) solid_ = std::make_unique<Solid>(course_.surface);
  }

  void closest(Answers& answers) const {
    answer_each(course_.points, answers,
                [this](const Point& point) { return std::sqrt(soup_->squared_distance(corner_of(point))); });
  }
  void inside(Answers& answers) const {
    answer_each(course_.points, answers,
                [this](const Point& point) { return solid_->side(corner_of(point)) != CGAL::ON_UNBOUNDED_SIDE; });
  }

 private:
  const Course& course_;
  Corners corners_;
  std::unique_ptr<Soup> soup_;
  std::unique_ptr<Solid> solid_;
};

}  // namespace

void enter_cgal(const Course& course, Entries& field) {
  Enrolment<OfCgal> cgal("CGAL", false, std::make_shared<OfCgal>(course), field);
  cgal.add(Work::build, &OfCgal::clear, &OfCgal::build);
  cgal.add(Work::closest, &OfCgal::build_if_needed, &OfCgal::closest);
  cgal.add(Work::closest_batch, &OfCgal::build_if_needed, &OfCgal::closest);
  if (!is_closed(course.surface)) return;
  cgal.add(Work::inside, &OfCgal::build_solid_if_needed, &OfCgal::inside);
  cgal.add(Work::inside_batch, &OfCgal::build_solid_if_needed, &OfCgal::inside);
}

}  // namespace mesh_bench
