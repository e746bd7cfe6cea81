// SPDX-License-Identifier: MIT
// An object made of several shapes: it owns them, and touches whatever one of them touches.
#include <cstdio>
#include <variant>

#include <graze/query/bounds.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/transformed.hpp>

#include "picture.hpp"

const char* answer(bool yes) { return yes ? "yes" : "no"; }

int main(int argc, char** argv) {
  const graze::Mat<2> turn(graze::rotation_matrix(30));
  const graze::Compound<2> crane = graze::compound_of<2, float>({
      graze::Aabb<2>{{-1, 0}, {1, 1}},                       // foot
      graze::Aabb<2>{{-0.3F, 1}, {0.3F, 6}},                 // mast
      graze::OrientedRect<>{{2.6F, 7.3F}, {3, 0.3F}, turn},  // arm
      graze::Circle<>{{0, 6}, 0.6F},                         // joint
  });
  const graze::Pose<2> drive{graze::Mat<2>(1), {9, 0}};
  const graze::Compound<2> other = graze::transformed(crane, drive);
  const graze::Compound<2> both = graze::compound_of<2, float>({crane, other});

  const graze::Circle<> ball{{3, 3}, 1.5F};
  const graze::Circle<> load{{5, 7.5F}, 1};
  const graze::Capsule<2> rope{{9.7F, 2}, {12, 4.5F}, 0.5F};
  std::printf("ball: crane %s, its bounding box %s\n", answer(graze::intersects(crane, ball)),
              answer(graze::intersects(graze::bounds(crane), ball)));
  std::printf("load: crane %s, other crane %s, both %s\n", answer(graze::intersects(crane, load)),
              answer(graze::intersects(other, load)), answer(graze::intersects(both, load)));
  std::printf("rope: other crane %s; crane against crane: %s\n", answer(graze::intersects(other, rope)),
              answer(graze::intersects(crane, other)));
  const graze::Vec<2> nearest = graze::closest_point(crane, ball.center);
  std::printf("nearest to the ball's center: (%g, %g)\n", nearest.x, nearest.y);
  std::printf("an empty compound touches the ball: %s\n", answer(graze::intersects(graze::Compound<2>{}, ball)));

  cookbook::Picture<2> picture("two cranes");
  picture.add(crane, "crane");
  picture.add(other, "other crane");
  picture.add(ball, "ball");
  picture.add(load, "load");
  picture.add(rope, "rope");
  return picture.save(argc, argv);
}
