// SPDX-License-Identifier: MIT
// The convex hull of 3D points: its corners and faces, and whether it stands on its lowest face or falls over.
#include <cstdio>
#include <vector>

#include <graze/query/mass_properties.hpp>
#include <graze/shape/convex_mesh.hpp>

#include "picture.hpp"

using Point = graze::Vec<3>;
using Wide = graze::Vec<3, double>;

// A leaning tower: a square, the same one above it, and all lattice points between them.
std::vector<Point> tower(const Point& foot, float lean) {
  std::vector<Point> points;
  for (const float z : {0.0F, 1.0F, 2.0F, 3.0F, 4.0F}) {
    for (const float x : {-1.0F, 0.0F, 1.0F}) {
      for (const float y : {-1.0F, 0.0F, 1.0F}) points.push_back(foot + Point(x + lean * z, y, z));
    }
  }
  return points;
}

Point start_of(const graze::ConvexMesh<>& mesh, const graze::HalfEdge& side) { return mesh.vertices[side.origin]; }
Point end_of(const graze::ConvexMesh<>& mesh, const graze::HalfEdge& side) {
  return mesh.vertices[mesh.half_edges[side.next].origin];
}

// Whether the centroid is above the face that the solid stands on: on the inner side of all its edges.
bool stands_on(const graze::ConvexMesh<>& mesh, std::size_t face, const Wide& centroid) {
  const Wide outward = graze::face_plane(mesh, face).normal;
  for (const graze::HalfEdge& side : mesh.half_edges) {
    const Wide start(start_of(mesh, side));
    const Wide inward = cross(outward, Wide(end_of(mesh, side)) - start);
    if (side.face == face && dot(inward, centroid - start) < 0) return false;
  }
  return true;
}

int main(int argc, char** argv) {
  cookbook::Picture<3> picture("towers, and where their weight pulls");
  for (const std::vector<Point>& points : {tower({-3, -3, 0}, 0.25F), tower({0, 0, 0}, 0.75F)}) {
    const auto solid = graze::convex_hull<3, float>(points);
    const auto mesh = graze::convex_mesh(solid);
    const auto mass = graze::mass_properties(solid);
    std::printf("%zu points: %zu corners, %zu edges, %zu faces, volume %g\n", points.size(), mesh.vertices.size(),
                mesh.half_edges.size() / 2, mesh.faces.size(), mass.volume);
    std::size_t lowest = 0;
    while (graze::face_plane(mesh, lowest).normal.z > -0.5) ++lowest;
    std::printf("it %s\n", stands_on(mesh, lowest, mass.centroid) ? "stands" : "falls over");
    for (const graze::HalfEdge& side : mesh.half_edges) {
      picture.draw(graze::Segment<3>{start_of(mesh, side), end_of(mesh, side)});
    }
    picture.connect(Point(mass.centroid), Point(mass.centroid.x, mass.centroid.y, 0));
  }
  return picture.save(argc, argv);
}
