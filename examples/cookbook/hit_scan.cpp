// SPDX-License-Identifier: MIT
// A shot that hits instantly: the first object in its path, those behind it, and those that it must not hit.
#include <cstdio>
#include <string>

#include <graze/scene/scene.hpp>
#include <graze/shape/ray.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
  graze::Scene<2> yard;
  const graze::Layer walls = yard.layer("walls");
  const graze::Layer robots = yard.layer("robots");
  const graze::Layer friends = yard.layer("friends");
  yard.add(graze::Rect<>{{13.5F, 0}, {14, 6}}, {.name = "wall", .layer = walls});
  yard.add(graze::OrientedRect<>{{9, 8}, {2, 0.25F}, graze::Mat<2>(graze::rotation_matrix(30))},
           {.name = "plank", .layer = walls});
  yard.add(graze::Capsule<2>{{6, 2.5F}, {6, 4}, 0.5F}, {.name = "friend", .layer = friends});
  for (int i = 0; i < 4; ++i) {
    const graze::Vec<2> feet(10 + 2.5F * static_cast<float>(i), 2 + static_cast<float>(i % 2));
    yard.add(graze::Capsule<2>{feet, feet + graze::Vec<2>(0, 2), 0.6F},
             {.name = "robot " + std::to_string(i + 1), .layer = robots});
  }

  const graze::LayerMask in_the_way = graze::only_layer(walls) | graze::only_layer(robots);
  const graze::Ray<2> aim{{1, 3}, {1, 0.03125F}};
  const float range = 30;
  const auto first = yard.ray_cast(aim, range, in_the_way);
  std::printf("hit: %s at (%.2f, %.2f), normal (%.2f, %.2f)\n", yard.object(first->id).name.c_str(), first->hit.point.x,
              first->hit.point.y, first->hit.normal.x, first->hit.normal.y);
  std::printf("a rail gun goes through");
  for (const auto& [id, hit] : yard.ray_cast_all(aim, range, in_the_way)) {
    std::printf(" %s,", yard.object(id).name.c_str());
  }
  std::printf(" in this order\n");
  std::printf("without the mask: %s\n", yard.object(yard.ray_cast(aim, range)->id).name.c_str());
  const auto high = yard.ray_cast({{1, 12}, {1, 0}}, range, in_the_way);
  std::printf("over their heads: %s\n", high ? "a hit" : "nothing");

  cookbook::Picture<2> picture("a shot");
  for (const graze::ObjectId id : yard.ids()) picture.draw(yard.object(id).shape, yard.object(id).name);
  picture.connect(aim.origin, first->hit.point, "hit");
  return picture.save(argc, argv);
}
