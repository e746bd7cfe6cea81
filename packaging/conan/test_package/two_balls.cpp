// SPDX-License-Identifier: MIT
#include <graze/scene/scene.hpp>

int main() {
  graze::Scene<3> scene;
  scene.add(graze::Sphere<3>{{0, 0, 0}, 1});
  scene.add(graze::Sphere<3>{{1, 0, 0}, 1});
  return scene.pairs().size() == 1 ? 0 : 1;
}
