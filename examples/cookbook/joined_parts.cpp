// SPDX-License-Identifier: MIT
// A crane whose parts overlap at their joints: which parts collide, apart from those that are joined.
#include <cstdio>

#include <graze/scene/scene.hpp>

#include "picture.hpp"

void print_pairs(const char* when, const graze::Scene<2>& yard) {
  std::printf("%s:", when);
  for (const auto& [a, b] : yard.pairs()) {
    std::printf(" %s-%s", yard.object(a).name.c_str(), yard.object(b).name.c_str());
  }
  std::printf("\n");
}

int main(int argc, char** argv) {
  graze::Scene<2> yard;
  const auto mast = yard.add(graze::Capsule<2>{{0, 0}, {0, 5}, 0.4F}, {.name = "mast"});
  const auto boom = yard.add(graze::Capsule<2>{{0, 5}, {5, 6}, 0.35F}, {.name = "boom"});
  const auto arm = yard.add(graze::Capsule<2>{{5, 6}, {6, 3}, 0.3F}, {.name = "arm"});
  yard.add(graze::Rect<>{{-2, -1}, {9, -0.2F}}, {.name = "ground"});
  yard.add(graze::Circle<>{{3.6F, 2}, 1.2F}, {.name = "load"});
  print_pairs("every pair", yard);

  yard.except(mast, boom);
  yard.except(boom, arm);
  yard.except(mast, yard.find("ground").value());
  print_pairs("without the joints", yard);
  yard.update();

  yard.move(arm, graze::Capsule<2>{{5, 6}, {4.2F, 3}, 0.3F});
  for (const auto& [a, b] : yard.update().began) {
    std::printf("the arm swings: %s hits %s\n", yard.object(a).name.c_str(), yard.object(b).name.c_str());
  }

  std::printf("%zu pairs are excepted", yard.excepted_pairs().size());
  yard.accept(boom, arm);  // the arm comes off
  std::printf("; then %s\n", yard.excepted(arm, boom) ? "the joint is" : "the joint is no more");

  cookbook::Picture<2> picture("a crane and its load");
  for (const graze::ObjectId id : yard.ids()) {
    const bool is_hit = id == arm || yard.object(id).name == "load";
    if (is_hit) picture.add(yard.object(id).shape, yard.object(id).name);
    if (!is_hit) picture.draw(yard.object(id).shape, yard.object(id).name);
  }
  return picture.save(argc, argv);
}
