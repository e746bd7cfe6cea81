// SPDX-License-Identifier: MIT
#include <graze/scene/scene.hpp>

int main() {
  graze::Scene<2> scene;
  scene.add(graze::Circle<>{{0, 0}, 1});
  scene.add(graze::Circle<>{{1, 1}, 1});
  scene.add(graze::Circle<>{{9, 9}, 1});
  return scene.pairs().size() == 1 ? 0 : 1;
}
