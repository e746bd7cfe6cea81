// SPDX-License-Identifier: MIT
// What a camera sees of a town from above, by its view-projection matrix, and what is under the mouse.
#include <algorithm>
#include <cstdio>
#include <vector>

#include <graze/scene/scene.hpp>
#include <graze/shape/pick.hpp>

#include "picture.hpp"

/// A 2D camera: its position, viewing direction and range; its view is as wide as it is long.
graze::Mat<3> camera_at(const graze::Vec<2>& eye, const graze::Vec<2>& ahead, float reach) {
  const graze::Vec<2> right(2 * ahead.y, -2 * ahead.x);
  // Clip coordinates of a point p: x = (p - eye) * right, w = (p - eye) * ahead, and y from -w at the near plane, at 1,
  // to w at the reach: y = (w (reach + 1) - 2 reach) / (reach - 1).
  const float slope = (reach + 1) / (reach - 1);
  graze::Mat<3> matrix(0);
  for (int j = 0; j < 2; ++j) matrix[j] = {right[j], slope * ahead[j], ahead[j]};
  const float depth = -dot(eye, ahead);
  matrix[2] = {-dot(eye, right), slope * depth - 2 * reach / (reach - 1), depth};
  return matrix;
}

int main(int argc, char** argv) {
  graze::Scene<2> town;
  for (int i = 0; i < 300; ++i) {
    const int row = i / 20;
    const graze::Vec<2> corner(static_cast<float>(i % 20 * 3 + i * 7 % 3), static_cast<float>(row * 3 + i * 5 % 2));
    town.add(graze::Aabb<2>{corner, corner + 1.5F});
  }
  const graze::Mat<3> camera = camera_at({8.3F, 6.1F}, {0.8F, 0.6F}, 40);
  const graze::Frustum<2> frustum = graze::frustum_of(camera);
  const std::vector<graze::ObjectId> seen = town.cull(frustum);
  std::printf("in view: %zu of %zu houses\n", seen.size(), town.size());
  const auto box = graze::bounds(frustum);
  std::printf("in the box around the view: %zu\n", town.cull(box).size());

  const graze::Vec<2> mouse = graze::device_point(graze::Vec<2>(300, 40), graze::Vec<2>(800, 600));
  const graze::Vec<2> place = graze::pick_point(camera, mouse);
  std::printf("the mouse is at (%.2f, %.2f), on %zu houses\n", place.x, place.y, town.overlapping(place).size());

  cookbook::Picture<2> picture("houses in view");
  const graze::Polytope<2> view = graze::convex_hull<2, float>(frustum.corners);
  for (const graze::ObjectId id : town.ids()) {
    if (std::binary_search(seen.begin(), seen.end(), id)) {
      picture.add(town.object(id).shape);
    } else {
      picture.draw(town.object(id).shape);
    }
  }
  picture.add(view, "view");
  picture.draw(place, "mouse");
  return picture.save(argc, argv);
}
