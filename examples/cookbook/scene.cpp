// SPDX-License-Identifier: MIT
// A player among a thousand moving coins: which coins it begins and ceases to touch, what is near it, what its shot
// hits, and what happens to an id after removal.
#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include <graze/scene/scene.hpp>

#include "picture.hpp"

graze::Circle<> coin_at(int i, int frame) {
  const auto column = static_cast<float>(3 * (i % 26) + (i * 7 + frame * (i % 3)) % 5);
  return {{column, 1.25F * static_cast<float>(i / 26)}, 0.8F};
}

graze::Circle<> player_at(int frame) { return {{29.5F + 2.5F * static_cast<float>(frame), 25}, 1.5F}; }

auto count_of(graze::ObjectId id, const std::vector<graze::ObjectPair>& pairs) {
  return std::count_if(pairs.begin(), pairs.end(), [id](const auto& pair) { return pair.a == id || pair.b == id; });
}

int main(int argc, char** argv) {
  graze::Scene<2> scene;
  const graze::Layer players = scene.layer("players");
  const graze::Layer loot = scene.layer("loot");
  const graze::ObjectId player = scene.add(player_at(0), {.name = "player", .layer = players});
  std::vector<graze::ObjectId> coins;
  for (int i = 0; i < 1000; ++i) coins.push_back(scene.add(coin_at(i, 0), {.layer = loot}));
  for (int frame = 0; frame < 4; ++frame) {
    scene.move(player, player_at(frame));
    for (int i = 0; i < 1000; ++i) scene.move(coins[static_cast<std::size_t>(i)], coin_at(i, frame));
    const graze::SceneEvents& events = scene.update();
    std::printf("frame %d: %zu pairs touch, %zu began to; the player meets %td coins and leaves %td\n", frame,
                scene.pairs().size(), events.began.size(), count_of(player, events.began),
                count_of(player, events.ended));
  }

  const graze::Circle<> reach{player_at(3).center, 6};
  std::printf("near the player: %zu coins\n", scene.overlapping(reach, graze::only_layer(loot)).size());
  const graze::Ray<2> shot{reach.center, {1, -2}};
  const auto hit = scene.ray_cast(shot, 100, graze::only_layer(loot));
  std::printf("its shot hits coin %u at (%.2f, %.2f)\n", hit->id.index, hit->hit.point.x, hit->hit.point.y);

  scene.remove(hit->id);
  const graze::ObjectId crate = scene.add(graze::Aabb<2>{{60, 30}, {63, 32}}, {.name = "crate", .layer = loot});
  std::printf("the crate is at index %u, where that coin was\n", crate.index);
  try {
    scene.move(hit->id, coin_at(0, 4));
  } catch (const std::out_of_range& error) {
    std::printf("moving the coin: %s\n", error.what());
  }

  cookbook::Picture<2> picture("a player and a thousand coins in frame 3");
  for (const graze::ObjectId id : scene.ids()) picture.add(scene.object(id).shape, scene.object(id).name);
  picture.draw(reach, "near the player");
  picture.draw(graze::Segment<2>{shot.origin, hit->hit.point}, "shot");
  return picture.save(argc, argv);
}
