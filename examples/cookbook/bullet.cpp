// SPDX-License-Identifier: MIT
// A cannonball that is wider than the gap in a wall, and a bottle that tumbles as it flies: what each hits first.
#include <cstdio>

#include <graze/math/motion.hpp>
#include <graze/query/transformed.hpp>
#include <graze/scene/scene.hpp>

#include "picture.hpp"

using Point = graze::Vec<2>;

void print(const char* what, const graze::Scene<2>& yard, const graze::ObjectImpact<2>& first) {
  const auto& [id, impact] = first;
  std::printf("%s hits the %s: t = %.3f at (%.2f, %.2f), normal (%.2f, %.2f)\n", what, yard.object(id).name.c_str(),
              impact.t, impact.point.x, impact.point.y, impact.normal.x, impact.normal.y);
}

int main(int argc, char** argv) {
  graze::Scene<2> yard;
  const graze::ObjectId cannon = yard.add(graze::Capsule<2>{{0, 3}, {2, 3}, 0.8F}, {.name = "cannon"});
  yard.add(graze::Rect<>{{8, 3.4F}, {8.5F, 6}}, {.name = "upper wall"});
  yard.add(graze::Rect<>{{8, 0}, {8.5F, 2.5F}}, {.name = "lower wall"});
  const graze::ObjectId mist = yard.add(graze::Circle<>{{5, 3}, 1}, {.name = "mist"});
  yard.add(graze::Capsule<2>{{14, 2}, {14, 4}, 0.6F}, {.name = "robot"});
  yard.add(graze::HalfSpace<2>{{0, 1}, 0}, {.name = "floor"});

  const graze::Circle<> ball{{2, 3}, 0.6F};
  const Point flight{16, 0};
  const graze::SceneQuery solid{.except = {&cannon, 1}, .predicate = [mist](graze::ObjectId id) { return id != mist; }};
  const auto ray = yard.ray_cast({ball.center, flight}, 1, solid);
  std::printf("its center would hit the %s\n", yard.object(ray->id).name.c_str());
  const auto first = yard.shape_cast(ball, flight, solid);
  print("the ball", yard, *first);
  std::printf("on its way are");
  for (const auto& [id, impact] : yard.shape_cast_all(ball, flight, {.except = {&cannon, 1}})) {
    std::printf(" %s,", yard.object(id).name.c_str());
  }
  std::printf(" in this order\n");

  const graze::Capsule<2> bottle{{2, 7.4F}, {2, 9}, 0.2F};
  const graze::Motion<2> tumble{{16, -4}, -4, {2, 8.2F}};
  print("a bottle that does not rotate", yard, *yard.shape_cast(bottle, tumble.linear, solid));
  const auto smash = yard.time_of_impact(bottle, tumble, solid);
  print("a bottle that tumbles", yard, *smash);

  cookbook::Picture<2> picture("a cannonball and a bottle");
  for (const graze::ObjectId id : yard.ids()) picture.draw(yard.object(id).shape, yard.object(id).name);
  picture.connect(ball.center, ball.center + flight * first->impact.t, "ball");
  picture.draw(graze::Circle<>{ball.center + flight * first->impact.t, ball.radius});
  for (const float part : {0.0F, 0.25F, 0.5F, 0.75F, 1.0F}) {
    const auto [rotation, position] = pose_at(tumble, static_cast<double>(part * smash->impact.t));
    picture.draw(transformed(bottle, graze::Pose<2>{graze::Mat<2>(rotation), Point(position)}));
  }
  return picture.save(argc, argv);
}
