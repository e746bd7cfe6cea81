// SPDX-License-Identifier: MIT
// Layers and masks: which pairs of objects are tested at all.
#include <cstdio>
#include <span>

#include <graze/graze.hpp>

int main() {
  graze::Scene<2> scene;
  const graze::Layer heroes = scene.layer("heroes");
  const graze::Layer shots = scene.layer("shots");
  const graze::Layer walls = scene.layer("walls");

  graze::FilterMatrix rules;  // at first everything can touch everything
  rules.part(heroes, shots);
  rules.part(heroes, heroes);
  rules.part(shots, shots);
  rules.join(heroes, heroes);  // undoes the second line: heroes block each other

  const auto add = [&](const char* name, graze::Layer layer, const graze::Circle<>& circle) {
    return scene.add(circle, {.name = name, .layer = layer, .mask = rules.mask_of(layer)});
  };
  const graze::ObjectId ann = add("Ann", heroes, {{0, 0}, 1});
  const graze::ObjectId ben = add("Ben", heroes, {{1, 0}, 1});
  const graze::ObjectId shot = add("the shot", shots, {{0.5F, 0}, 0.1F});
  const graze::ObjectOptions of_walls{.layer = walls, .mask = rules.mask_of(walls), .mobility = graze::Mobility::fixed};
  scene.add(graze::Rect<>{{-1, -2}, {2, -0.5F}}, of_walls);
  scene.add(graze::Rect<>{{1, -2}, {3, 2}}, of_walls);  // overlaps the other wall, but both are fixed

  for (const graze::Layer a : {heroes, shots, walls}) {
    for (const graze::Layer b : {heroes, shots, walls}) {
      if (b > a) continue;
      std::printf("%s and %s %s\n", scene.layer_names()[a].c_str(), scene.layer_names()[b].c_str(),
                  rules.can_touch(a, b) ? "can touch" : "pass through each other");
    }
  }

  // Pairs that may touch and whose boxes overlap, in blocks.
  std::size_t candidates = 0;
  graze::visit_candidates(scene, [&](std::span<const graze::ObjectPair> block) {
    candidates += block.size();
    return true;
  });
  std::printf("%zu candidates, %zu pairs\n", candidates, scene.pairs().size());

  // The same rules for single pairs.
  const graze::Object<2>& hero = scene.object(ann);
  const bool rules_hold = graze::may_touch(hero, scene.object(ben)) && !graze::may_touch(hero, scene.object(shot)) &&
                          !graze::filters_admit(shots, rules.mask_of(shots), heroes, rules.mask_of(heroes));
  const bool boxes_meet =
      graze::boxes_overlap(graze::touching_bounds(hero), graze::touching_bounds(scene.object(shot)));
  return rules_hold && boxes_meet && candidates == scene.candidates().size() && scene.pairs().size() == 5 ? 0 : 1;
}
