// SPDX-License-Identifier: MIT
// The queries of a scene besides its pairs, checked against a brute-force scene.
#include <cstdio>
#include <optional>
#include <vector>

#include <graze/graze.hpp>
#include <graze/scene/plain_scene.hpp>

/// Both kinds of scenes have the same member functions.
template <class S>
graze::ObjectId fill(S& scene) {
  scene.add(graze::HalfSpace<3>{{0, 0, 1}, 0}, {.name = "floor"});
  scene.add(graze::Aabb<3>{{-1, -1, 0}, {1, 1, 2}}, {.name = "crate"});
  scene.add(graze::Sphere<3>{{0, 0, 3}, 1}, {.name = "ball"});
  return scene.add(graze::Capsule<3>{{5, 0, 1}, {5, 0, 4}, 0.5F}, {.name = "pole"});
}

int main() {
  graze::Scene<3> scene;
  graze::PlainScene<3> judge;
  const graze::ObjectId pole = fill(scene);
  fill(judge);

  for (const graze::ObjectContact<3>& contact : scene.contacts()) {
    std::printf("%s and %s touch at %zu points\n", scene.object(contact.pair.a).name.c_str(),
                scene.object(contact.pair.b).name.c_str(), contact.manifold.points.size());
  }
  const std::vector<graze::NearObject<>> nearest = scene.nearest({6, 0, 2}, 2);
  for (const auto& near : nearest) {
    std::printf("%s is %g away\n", scene.object(near.id).name.c_str(), static_cast<double>(near.distance));
  }
  const std::optional<graze::ObjectHit<3>> hit = scene.ray_cast(graze::Ray<3>{{0, 0, 9}, {0, 0, -1}});
  if (!hit) return 1;
  std::printf("looking down: %s\n", scene.object(hit->id).name.c_str());
  for (const graze::ObjectId& id : scene.overlapping(graze::Sphere<3>{{0, 0, 2}, 0.5F})) {
    std::printf("in the region: %s\n", scene.object(id).name.c_str());
  }

  const bool agrees = scene.contacts().size() == judge.contacts().size() &&
                      scene.pairs().size() == judge.pairs().size() &&
                      judge.nearest({6, 0, 2}, 2).front().distance == nearest.front().distance;
  scene.remove(pole);
  return agrees && !scene.contains(pole) && scene.find("pole") == std::nullopt && nearest.front().id == pole ? 0 : 1;
}
