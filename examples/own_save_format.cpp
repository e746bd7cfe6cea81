// SPDX-License-Identifier: MIT
// Saves a scene in a format of your own. The index and generation of an object are the same in the loaded scene, and
// the next object gets the same id in both.
#include <cstdio>
#include <vector>

#include <graze/graze.hpp>

struct Saved {
  std::vector<graze::ObjectId> ids;
  std::vector<graze::ObjectId> vacant;  ///< Places of removed objects.
  std::vector<std::vector<graze::Vec<2>>> corners;
};

Saved save(const graze::Scene<2>& scene) {
  Saved saved{scene.ids(), scene.vacant_ids(), {}};
  for (const graze::ObjectId& id : saved.ids) {
    const auto& polygon = std::get<graze::Polytope<2>>(scene.object(id).shape);
    saved.corners.emplace_back(polygon.vertices().begin(), polygon.vertices().end());
  }
  return saved;
}

graze::Scene<2> load(const Saved& saved) {
  graze::Scene<2> scene;
  scene.plan_ids(saved.ids, saved.vacant);  // before the first `add`
  // The vertices keep their numbers, which contacts refer to; convex_hull would sort them.
  for (const auto& corners : saved.corners) scene.add(graze::convex_hull_in_order(corners));
  return scene;
}

int main() {
  graze::Scene<2> scene;
  const std::vector<graze::Vec<2>> kite = {{2, 0}, {0, 3}, {-2, 0}, {0, -1}};
  const graze::ObjectId first = scene.add(graze::convex_hull_in_order(kite));
  scene.add(graze::convex_hull_in_order(kite));
  scene.remove(first);

  graze::Scene<2> loaded = load(save(scene));
  const graze::ObjectId next = scene.add(graze::convex_hull(kite));
  const graze::ObjectId next_loaded = loaded.add(graze::convex_hull(kite));
  std::printf("the next object has index %u, generation %u; in the loaded scene %u, %u\n", next.index, next.generation,
              next_loaded.index, next_loaded.generation);

  const auto& polygon = std::get<graze::Polytope<2>>(loaded.object(loaded.ids().back()).shape);
  const bool is_in_order = polygon.vertices().front() == kite.front();
  const bool is_same = next.index == next_loaded.index && next.generation == next_loaded.generation;
  return is_same && is_in_order && !loaded.find(first.index, first.generation) && loaded.size() == 2 ? 0 : 1;
}
