// SPDX-License-Identifier: MIT
// Which triangle of a mesh is under the mouse, and how warm it is there, as each vertex has a temperature.
#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <graze/broad/ray_casts.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/shape/mesh.hpp>

#include "picture.hpp"

using Point = graze::Vec<3>;

/// A tent: eight triangles around a tip, on nine vertices.
graze::Mesh<3> tent() {
  const std::vector<Point> vertices = {{0, 0, 3},  {3, 0, 0},   {2, 2, 1},  {0, 3, 0}, {-2, 2, 1},
                                       {-3, 0, 0}, {-2, -2, 1}, {0, -3, 0}, {2, -2, 1}};
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (std::uint32_t i = 1; i <= 8; ++i) faces.push_back({0, i, i % 8 + 1});
  return graze::mesh_of<3>(vertices, faces);
}

int main(int argc, char** argv) {
  const graze::Mesh<3> mesh = tent();
  const std::array<float, 9> warmth = {30, 10, 14, 10, 14, 10, 14, 10, 14};  // of each vertex

  cookbook::Picture<3> picture("the face under the mouse");
  for (std::size_t face = 0; face < mesh.faces().size(); ++face) picture.draw(mesh.triangle(face));
  const Point eye(1, -9, 5);
  for (const Point& target : {Point(0.5F, -1.25F, 2), Point(0, 0, 3), Point(2, -0.5F, 1), Point(5, 5, 0)}) {
    const graze::Ray<3> sight{eye, target - eye};
    const std::optional<graze::MeshHit<3>> hit = ray_cast(mesh, sight);
    if (!hit) {
      std::printf("nothing\n");
      continue;
    }
    const std::array<std::uint32_t, 3>& corners = mesh.faces()[hit->face];
    float value = 0;
    for (int i = 0; i < 3; ++i) value += hit->barycentric[i] * warmth[corners[static_cast<std::size_t>(i)]];
    std::printf("face %zu at (%.2f, %.2f, %.2f), weights %.2f %.2f %.2f, warmth %.1f\n", hit->face, hit->point.x,
                hit->point.y, hit->point.z, hit->barycentric.x, hit->barycentric.y, hit->barycentric.z, value);
    picture.connect(eye, hit->point, "face " + std::to_string(hit->face));
  }

  const std::vector<graze::Ray<3>> rain(1000, {{0.25F, 0.25F, 9}, {0, 0, -1}});  // many rays at once
  std::size_t wet = 0;
  for (const auto& hit : graze::ray_casts(mesh, rain)) wet += hit.has_value() ? 1 : 0;
  std::printf("%zu of %zu drops hit the tent\n", wet, rain.size());
  return picture.save(argc, argv);
}
