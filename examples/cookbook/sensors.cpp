// SPDX-License-Identifier: MIT
// Sensors of a robot in a workshop: a bumper that feels contacts, a proximity sensor, and a warning of narrow gaps.
#include <cstdio>

#include <graze/scene/scene.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
  graze::Scene<2> workshop;
  workshop.layer("solid");  // layer 0, on which objects are unless they name another one
  const graze::Layer sensors = workshop.layer("sensors");
  const auto robot = workshop.add(graze::Circle<>{{0, 0}, 1}, {.name = "robot"});
  workshop.add(graze::Rect<>{{1.5F, -3}, {2.5F, -0.4F}}, {.name = "bench"});
  workshop.add(graze::Circle<>{{1, 2}, 0.6F}, {.name = "barrel"});
  workshop.add(graze::Rect<>{{-4, -2}, {-2.2F, 1}}, {.name = "shelf"});
  // A mask of none: it never is in a pair, so it stops nothing and makes no event.
  const graze::Circle<> zone{{2.5F, 0}, 1};
  workshop.add(zone, {.name = "zone", .layer = sensors, .mask = 0});

  const graze::SceneQuery solid{.layers = ~graze::only_layer(sensors), .except = {&robot, 1}};
  const graze::Rect<> bumper{{0.8F, -0.8F}, {1.55F, 0.8F}};
  for (const auto& [id, manifold] : workshop.contacts_with(bumper, solid)) {
    std::printf("the bumper feels the %s: %zu points, %.2f deep, towards (%.0f, %.0f)\n",
                workshop.object(id).name.c_str(), manifold.size, manifold.points[0].depth, manifold.normal.x,
                manifold.normal.y);
  }
  for (const auto& [id, distance] : workshop.nearest(workshop.object(robot).shape, 2, solid)) {
    std::printf("near the robot: the %s, %.2f away\n", workshop.object(id).name.c_str(), distance);
  }
  std::printf("in the zone:");
  for (const graze::ObjectId id : workshop.overlapping(zone, solid)) {
    std::printf(" the %s", workshop.object(id).name.c_str());
  }
  std::printf("\n");
  for (const auto& [pair, distance] : workshop.closest_pairs(1.25)) {
    std::printf("a narrow gap: %s to %s, %.2f\n", workshop.object(pair.a).name.c_str(),
                workshop.object(pair.b).name.c_str(), distance);
  }

  cookbook::Picture<2> picture("a robot and its sensors");
  for (const graze::ObjectId id : workshop.ids()) picture.draw(workshop.object(id).shape, workshop.object(id).name);
  picture.draw(bumper, "bumper");
  return picture.save(argc, argv);
}
