// SPDX-License-Identifier: MIT
// Two gears as meshes: do they clash, on which faces, how deep, and from which distance on is there a gap?
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <graze/broad/touching_faces.hpp>
#include <graze/math/pose.hpp>
#include <graze/query/separation.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/mesh.hpp>

#include "picture.hpp"

/// A gear around the z axis with a hole: a rectangle that is swept around it, wider where there are teeth.
graze::Mesh<3> gear(std::uint32_t teeth, float radius) {
  const std::uint32_t count = 4 * teeth;
  std::vector<graze::Vec<3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (std::uint32_t i = 0; i < count; ++i) {
    const float angle = (static_cast<float>(i) - 0.5F) * 6.2831853F / static_cast<float>(count);
    const float rim = i % 4 < 2 ? radius + 1 : radius;
    for (std::uint32_t k = 0; k < 4; ++k) {
      const float r = k == 1 || k == 2 ? rim : radius / 2;
      vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), k < 2 ? -0.5F : 0.5F);
      const std::uint32_t next = 4 * ((i + 1) % count);
      faces.push_back({4 * i + k, next + k, next + (k + 1) % 4});
      faces.push_back({4 * i + k, next + (k + 1) % 4, 4 * i + (k + 1) % 4});
    }
  }
  return graze::mesh_of<3>(vertices, faces, graze::MeshKind::solid);
}

int main(int argc, char** argv) {
  const graze::Mesh<3> wheel = gear(12, 5);
  const graze::Mesh<3> pinion = gear(8, 3);
  cookbook::Picture<3> picture("the faces of two gears that clash");
  picture.draw(wheel, "wheel");
  for (const float distance : {8.75F, 9.F, 9.25F, 9.5F}) {
    const auto pose = graze::Pose<3>::from_axis_angle({distance, 0, 0}, {0, 0, 1}, 0.3926991);  // half a tooth
    const graze::Mesh<3> moved = transformed(pinion, pose);
    const auto found = separation(wheel, moved);
    std::printf("axles %.2f apart: ", distance);
    if (found.relation == graze::Relation::apart) {
      std::printf("clear by %.3f at (%.2f, %.2f)\n", found.distance, found.point_a.x, found.point_a.y);
      continue;
    }
    const std::vector<graze::Pair> pairs = touching_faces(wheel, moved);
    std::printf("clash %.3f deep, %zu pairs of faces touch\n", -found.distance, pairs.size());
    if (distance > 8.75F) continue;
    picture.draw(moved, "pinion");
    for (graze::Layer i = 0; i < pairs.size(); ++i) {  // a layer for each pair, so that only they touch
      picture.add(wheel.triangle(pairs[i].a), "", i);
      picture.add(moved.triangle(pairs[i].b), "", i);
    }
  }
  return picture.save(argc, argv);
}
