// SPDX-License-Identifier: MIT
// A ball falls on hills that are a mesh, rolls downhill and comes to rest in a hollow.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <graze/query/closest_points.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/shape/mesh.hpp>

#include "picture.hpp"

using Point = graze::Vec<3>;

/// 16 x 16 vertices, two triangles for each cell: a bowl with waves.
graze::Mesh<3> hills() {
  constexpr std::uint32_t width = 16;
  std::vector<Point> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (std::uint32_t i = 0; i < width * width; ++i) {
    const float x = static_cast<float>(i % width) - 7.5F;
    const float y = static_cast<float>(i / width) - 7.5F;
    vertices.emplace_back(x, y, 0.06F * (x * x + y * y) + ((i / width) % 4 == 0 ? 0.2F : 0.0F));
    if (i % width == 0 || i < width) continue;
    faces.push_back({i - width - 1, i - width, i});
    faces.push_back({i - width - 1, i, i - 1});
  }
  return graze::mesh_of<3>(vertices, faces);
}

int main(int argc, char** argv) {
  const graze::Mesh<3> ground = hills();
  cookbook::Picture<3> picture("a ball on terrain");
  for (std::size_t face = 0; face < ground.faces().size(); ++face) picture.draw(ground.triangle(face));
  graze::Sphere<3> ball{{-5, 4, 7}, 0.8F};
  const graze::CastOptions touch{.ignore_initial_touch = true, .target_distance = 0.01};
  Point velocity(0);
  for (int step = 0; step <= 600; ++step) {
    if (step % 100 == 0) {
      const auto near = closest_points(ball, ground);
      std::printf("step %3d: at (%5.2f, %5.2f, %5.2f), gap %.3f\n", step, ball.center.x, ball.center.y, ball.center.z,
                  near.distance);
    }
    if (step % 40 == 0) picture.draw(ball);
    velocity = velocity * 0.98F + Point(0, 0, -0.004F);
    Point motion = velocity;
    for (int bounce = 0; bounce < 4 && dot(motion, motion) > 0; ++bounce) {
      const auto impact = shape_cast(ball, motion, ground, touch);
      const float share = impact ? impact->t : 1;
      ball.center += motion * share;
      if (!impact) break;
      const Point normal = -impact->normal;  // out of the ground
      for (Point* const way : {&velocity, &motion}) *way -= normal * std::min(dot(*way, normal), 0.0F);
      motion = motion * (1 - share);
    }
  }
  return picture.save(argc, argv);
}
