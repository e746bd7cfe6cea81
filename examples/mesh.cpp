// SPDX-License-Identifier: MIT
// A mesh of triangles: what is wrong with it, what is inside, what a ray hits, and where two meshes touch.
#include <array>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <graze/broad/closest_points.hpp>
#include <graze/broad/ray_casts.hpp>
#include <graze/broad/self_intersections.hpp>
#include <graze/broad/signed_distances.hpp>
#include <graze/broad/touching_faces.hpp>
#include <graze/broad/winding_numbers.hpp>
#include <graze/graze.hpp>
#include <graze/shape/mesh_report.hpp>
#include <graze/shape/welded.hpp>

using Corner = graze::Vec<3>;

/// A crate without a lid: ten triangles on eight corners, counter-clockwise as seen from outside.
graze::Mesh<3> open_crate() {
  const std::vector<Corner> corners = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0},
                                       {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}};
  const std::vector<std::array<std::uint32_t, 3>> faces = {{0, 2, 1}, {1, 2, 3}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3},
                                                           {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return graze::mesh_of<3>(corners, faces, graze::MeshKind::solid);
}

/// The winding number tells inside from outside although there is no lid, for one point or for many.
void ask_about_points(const graze::Mesh<3>& crate) {
  const bool is_inside = graze::winding_number(crate, Corner(1, 1, 1)) > 0.5;
  std::printf("the middle is %s\n", is_inside ? "inside" : "outside");
  const std::vector<Corner> points = {{1, 1, 0.5F}, {1, 1, 1.9F}, {1, 1, 2.5F}, {3, 1, 1}};
  const std::vector<double> windings = graze::winding_numbers(crate, points);
  const std::vector<float> distances = graze::signed_distances(crate, points);
  const std::vector<Corner> nearest = graze::closest_points(crate, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::printf("%g, %g, %g: winding number %.2f, signed distance %.2f, nearest %g, %g, %g\n", points[i].x, points[i].y,
                points[i].z, windings[i], distances[i], nearest[i].x, nearest[i].y, nearest[i].z);
  }
}

void cast_rays(const graze::Mesh<3>& crate) {
  const std::vector<graze::Ray<3>> rays = {{{1, 1, 9}, {0, 0, -1}}, {{-5, 1, 1}, {1, 0, 0}}, {{9, 9, 9}, {1, 0, 0}}};
  for (const auto& hit : graze::ray_casts(crate, rays)) {
    if (!hit) {
      std::printf("misses\n");
      continue;
    }
    const Corner first = crate.triangle(hit->face).a;
    std::printf("hits face %zu at t = %g; its first corner is %g, %g, %g\n", hit->face, hit->t, first.x, first.y,
                first.z);
  }
}

/// A second crate, moved, shares the triangles of the first.
void meet_another(const graze::Mesh<3>& crate) {
  const graze::Mesh<3> other = graze::transformed(crate, graze::Pose<3>{.position = {1.5F, 1, 0.5F}});
  std::printf("%s; %zu pairs of faces touch\n", graze::intersects(crate, other) ? "they clash" : "they are apart",
              graze::touching_faces(crate, other).size());
  graze::visit_touching_faces(crate, other, [](const graze::Pair& pair) {
    std::printf("such as %u and %u\n", pair.a, pair.b);
    return false;  // one is enough
  });
}

/// A corner pulled through the opposite side makes the mesh cross itself.
std::size_t crossings_of_bent(const graze::Mesh<3>& crate) {
  std::vector<Corner> pulled(crate.vertices().begin(), crate.vertices().end());
  pulled[7] = {-1, -1, 1};
  const graze::Mesh<3> bent = graze::moved<3>(crate, pulled);
  const bool is_good = graze::visit_self_intersections(bent, [](const graze::Pair&) { return false; });
  const bool is_solid = bent.kind() == graze::MeshKind::solid;
  std::printf("%zu faces, a %s; %s\n", bent.faces().size(), is_solid ? "solid" : "surface",
              is_good ? "good" : "not good");
  return graze::self_intersections(bent).size();
}

int main() {
  const graze::Mesh<3> crate = open_crate();
  const graze::MeshReport found = graze::report(graze::welded(crate));
  std::printf("%zu open edges, %s\n", found.open_edges, found.is_closed ? "closed" : "not closed");
  ask_about_points(crate);
  cast_rays(crate);
  meet_another(crate);
  return found.open_edges == 4 && crossings_of_bent(crate) == 6 ? 0 : 1;
}
