// SPDX-License-Identifier: MIT
// A character with the shape of a capsule walks through a level: over a step, up a slope, along a wall that it cannot
// pass.
#include <cstdio>
#include <string>

#include <graze/query/transformed.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/slide.hpp>

#include "picture.hpp"

using Point = graze::Vec<2>;

int main(int argc, char** argv) {
  graze::Scene<2> level;
  level.add(graze::Rect<>{{-2, -1}, {30, 0}}, {.name = "floor"});
  level.add(graze::Rect<>{{3, 0}, {6, 0.3F}}, {.name = "step"});
  level.add(graze::Triangle<2>{{9, 0}, {14, 2}, {14, 0}}, {.name = "ramp"});
  level.add(graze::Rect<>{{14, 0}, {18, 2}}, {.name = "platform"});
  level.add(graze::Rect<>{{18, 0}, {19, 6}}, {.name = "wall"});
  const graze::ObjectId hero = level.add(graze::Capsule<2>{{0, 0.5F}, {0, 1.5F}, 0.4F}, {.name = "hero"});

  const graze::SlideOptions walk{.query = {.except = {&hero, 1}}, .max_slope = 0.8, .step_height = 0.4};
  cookbook::Picture<2> picture("a character that walks");
  for (const graze::ObjectId id : level.ids()) picture.draw(level.object(id).shape, level.object(id).name);

  Point place{0, 0};
  Point velocity{0, 0};
  std::string last;
  for (int frame = 0; frame < 240; ++frame) {
    velocity = {6, velocity.y - 0.4F};  // to the right; gravity pulls down
    const graze::AnyShape<2> shape = level.object(hero).shape;
    const graze::Slide<2> path = slide(level, shape, velocity / 60.0F, walk);
    level.move(hero, graze::translated<2, float>(shape, path.motion));
    place += path.motion;
    bool stands = false;
    for (const auto& [id, impact] : path.touches) {
      if (impact.normal.y > -0.7F) continue;
      stands = true;
      const std::string& ground = level.object(id).name;
      if (ground != last)
        std::printf("frame %3d: on the %s, at (%.1f, %.1f)\n", frame, ground.c_str(), place.x, place.y);
      last = ground;
    }
    if (stands) velocity.y = 0;
    if (frame % 24 == 23) picture.draw(level.object(hero).shape);
  }
  std::printf("at the end: (%.1f, %.1f), before the wall\n", place.x, place.y);
  return picture.save(argc, argv);
}
