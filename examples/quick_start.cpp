// SPDX-License-Identifier: MIT
// Which shapes touch: two of them, then many.
#include <cstdio>

#include <graze/graze.hpp>

int main() {
  const graze::Sphere<3> ball{{0, 0, 1}, 1};
  const graze::Capsule<3> pole{{2, 0, 0}, {2, 0, 5}, 1};
  std::printf("ball and pole %s\n", graze::intersects(ball, pole) ? "touch" : "are apart");

  graze::Scene<3> scene;
  scene.add(ball, {.name = "ball"});
  scene.add(pole, {.name = "pole"});
  scene.add(graze::HalfSpace<3>{{0, 0, 1}, 0}, {.name = "floor"});
  for (const auto& [a, b] : scene.pairs()) {
    std::printf("%s touches %s\n", scene.object(a).name.c_str(), scene.object(b).name.c_str());
  }
}
