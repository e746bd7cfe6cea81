// SPDX-License-Identifier: MIT
// Many things that move: what began to touch and what no longer does, what is near the player, what a shot hits, and
// what an id is worth after a removal.
#include <cstdio>
#include <stdexcept>
#include <vector>

#include <graze/scene/scene.hpp>

#include "picture.hpp"

graze::Circle<> coin_at(int i, int frame) {
  const int column = i % 14;
  const int row = i / 14;
  return {{static_cast<float>(3 * column + (i * 7 + frame * (i % 3)) % 5), 1.25F * static_cast<float>(row)}, 0.8F};
}

int main(int argc, char** argv) {
  graze::Scene<2> scene;
  std::vector<graze::ObjectId> coins;
  coins.reserve(200);
  for (int i = 0; i < 200; ++i) coins.push_back(scene.add(coin_at(i, 0)));
  for (int frame = 0; frame < 3; ++frame) {
    for (int i = 0; i < 200; ++i) scene.move(coins[static_cast<std::size_t>(i)], coin_at(i, frame));
    const graze::SceneEvents& events = scene.update();
    std::printf("frame %d: of %d pairs %zu touch; %zu began to, %zu have ended\n", frame, 200 * 199 / 2,
                scene.pairs().size(), events.began.size(), events.ended.size());
  }

  const graze::Aabb<2> region = graze::Aabb<2>::from_center({20, 9}, {6, 4});
  std::printf("near the player: %zu coins\n", scene.overlapping(region).size());
  const graze::Segment<2> shot{{-3, 2}, {36, 14}};
  const auto hit = scene.ray_cast(graze::ray_between(shot.start, shot.end), 1);
  std::printf("the shot hits coin %u at (%.2f, %.2f)\n", hit->id.index, hit->hit.point.x, hit->hit.point.y);

  scene.remove(coins[7]);
  const graze::ObjectId newcomer = scene.add(graze::Aabb<2>{{20, 20}, {23, 22}}, {.name = "crate"});
  std::printf("the crate is at index %u, where coin 7 was\n", newcomer.index);
  try {
    scene.move(coins[7], coin_at(7, 1));
  } catch (const std::out_of_range& error) {
    std::printf("moving coin 7: %s\n", error.what());
  }

  cookbook::Picture<2> picture("coins in frame 2");
  for (const graze::ObjectId id : scene.ids()) picture.add(scene.object(id).shape, scene.object(id).name);
  picture.draw(region, "near the player");
  picture.draw(graze::Segment<2>{shot.start, hit->hit.point}, "shot");
  return picture.save(argc, argv);
}
