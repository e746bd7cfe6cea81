// SPDX-License-Identifier: MIT
// What is under the mouse in 3D: a ray from the camera's matrix, the first object on it, and what is behind.
#include <cmath>
#include <cstdio>
#include <limits>

#include <graze/scene/scene.hpp>
#include <graze/shape/pick.hpp>

#include "picture.hpp"

using Point = graze::Vec<3>;

/// projection * view of a camera that looks from `eye` at `target`, with z up: reversed depth, no far plane, near plane
/// at 0.1, and a field of view of 90 degrees in both directions.
graze::Mat<4> camera_at(const Point& eye, const Point& target) {
  const Point ahead = (target - eye) / std::sqrt(dot(target - eye, target - eye));
  const Point side = cross(ahead, Point(0, 0, 1));
  const Point right = side / std::sqrt(dot(side, side));
  const Point up = cross(right, ahead);
  graze::Mat<4> matrix(0);  // rows: right, up, near plane, ahead
  for (int j = 0; j < 3; ++j) matrix[j] = {right[j], up[j], 0, ahead[j]};
  matrix[3] = {-dot(eye, right), -dot(eye, up), 0.1F, -dot(eye, ahead)};
  return matrix;
}

int main(int argc, char** argv) {
  graze::Scene<3> yard;
  const graze::Layer ground = yard.layer("ground");
  const graze::Layer things = yard.layer("things");
  yard.add(graze::HalfSpace<3>{{0, 0, 1}, 0}, {.name = "ground", .layer = ground});
  yard.add(graze::Aabb<3>{{2, -1, 0}, {4, 1, 2}}, {.name = "crate", .layer = things});
  yard.add(graze::Sphere<3>{{6, 1, 1.5F}, 1.5F}, {.name = "ball", .layer = things});
  yard.add(graze::Capsule<3>{{3, 3, 0.5F}, {3, 3, 2.5F}, 0.5F}, {.name = "post", .layer = things});

  const Point eye(-4, -2, 4);
  const graze::Mat<4> camera = camera_at(eye, {3, 0.5F, 1});
  for (const graze::Vec<2> pixel : {graze::Vec<2>(400, 300), graze::Vec<2>(240, 280), graze::Vec<2>(400, 20)}) {
    const graze::Vec<2> mouse = graze::device_point(pixel, graze::Vec<2>(800, 600));
    const graze::Ray<3> sight = graze::pick_ray(camera, mouse, graze::ClipDepth::one_to_zero);
    std::printf("pixel (%.0f, %.0f):", pixel.x, pixel.y);
    for (const auto& [id, hit] : yard.ray_cast_all(sight)) {
      std::printf(" %s at (%.2f, %.2f, %.2f),", yard.object(id).name.c_str(), hit.point.x, hit.point.y, hit.point.z);
    }
    std::printf(" then nothing\n");
  }
  const graze::Ray<3> sight = graze::pick_ray(camera, {0, 0}, graze::ClipDepth::one_to_zero);
  const auto floor = yard.ray_cast(sight, std::numeric_limits<float>::infinity(), graze::only_layer(ground));
  std::printf("the ground behind: (%.2f, %.2f)\n", floor->hit.point.x, floor->hit.point.y);

  cookbook::Picture<3> picture("what is under the mouse");
  for (const graze::ObjectId id : yard.ids()) picture.draw(yard.object(id).shape, yard.object(id).name);
  picture.draw(eye, "eye");
  picture.connect(sight.origin, yard.ray_cast(sight)->hit.point, "picked");
  return picture.save(argc, argv);
}
