// SPDX-License-Identifier: MIT
// Which points are inside a mesh that is broken: a crate without a lid, one of whose faces is turned inside out.
#include <array>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <graze/broad/signed_distances.hpp>
#include <graze/broad/winding_numbers.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/mesh_report.hpp>

#include "picture.hpp"

using Point = graze::Vec<3>;

/// Ten triangles on eight corners, counter-clockwise as seen from outside, except for the last one.
graze::Mesh<3> broken_crate() {
  const std::vector<Point> corners = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0},
                                      {0, 0, 4}, {4, 0, 4}, {0, 4, 4}, {4, 4, 4}};
  const std::vector<std::array<std::uint32_t, 3>> faces = {{0, 2, 1}, {1, 2, 3}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3},
                                                           {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 5, 7}};
  return graze::mesh_of<3>(corners, faces, graze::MeshKind::solid);
}

int main(int argc, char** argv) {
  const graze::Mesh<3> crate = broken_crate();
  const graze::MeshReport found = graze::report(crate);
  std::printf("%zu open edges, %zu flipped edges, %s\n", found.open_edges, found.flipped_edges,
              found.is_closed ? "closed" : "not closed");

  std::vector<Point> points;
  for (const float height : {-1.0F, 1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F}) points.emplace_back(1.5F, 2, height);
  const std::vector<double> windings = graze::winding_numbers(crate, points);
  const std::vector<float> distances = graze::signed_distances(crate, points);

  const auto shell = graze::mesh_of<3>(crate.vertices(), crate.faces());  // without what it encloses
  cookbook::Picture<3> picture("inside a crate without a lid");
  for (std::size_t face = 0; face < shell.faces().size(); ++face) {
    const graze::Triangle<3> triangle = shell.triangle(face);
    picture.draw(graze::Segment<3>{triangle.a, triangle.b});
    picture.draw(graze::Segment<3>{triangle.b, triangle.c});
    picture.draw(graze::Segment<3>{triangle.c, triangle.a});
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_inside = contains(crate, points[i]);
    const bool is_below = ray_cast(shell, graze::Ray<3>{points[i], {0, 0, 1}}).has_value();
    std::printf("z = %2.0f: winding number %5.2f, %s, signed distance %5.2f, %s above\n", points[i].z, windings[i],
                is_inside ? "inside" : "outside", distances[i], is_below ? "one face" : "no face");
    if (is_inside) picture.add(graze::Sphere<3>{points[i], 0.25F}, "", 1);
    picture.add(points[i], "", is_inside ? 1 : 2);
  }
  return picture.save(argc, argv);
}
