// SPDX-License-Identifier: MIT
// A ball against walls: when and where it hits, and how it bounces. Testing its positions frame by frame would miss
// every hit.
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <graze/query/intersects.hpp>
#include <graze/query/shape_cast.hpp>

#include "picture.hpp"

using Point = graze::Vec<2>;
using Shape = graze::AnyShape<2>;

// The first wall that the ball hits on its path.
std::optional<graze::Impact<2>> first_impact(const graze::Circle<>& ball, const Point& way,
                                             const std::vector<Shape>& walls) {
  std::optional<graze::Impact<2>> first;
  for (const Shape& wall : walls) {
    const auto impact = graze::shape_cast(ball, way, wall);
    if (impact && (!first || impact->t < first->t)) first = impact;
  }
  return first;
}

int main(int argc, char** argv) {
  const std::vector<Shape> walls{graze::Segment<2>{{6, -5}, {6, 5}}, graze::HalfSpace<2>{{0, 1}, -5},
                                 graze::Triangle<2>{{-6, 5}, {-6, 1}, {-2, 5}}};
  graze::Circle<> ball{{-8, 0}, 0.5F};
  Point way{18, -7};  // of one frame

  cookbook::Picture<2> picture("a ball between walls");
  for (std::size_t i = 0; i < walls.size(); ++i) picture.draw(walls[i], "wall " + std::to_string(i + 1));
  picture.draw(ball, "start");
  for (const Shape& wall : walls) {
    const graze::Circle<> end{ball.center + way, ball.radius};
    std::printf("at the end of the frame: %s\n", graze::intersects(end, wall) ? "touching" : "apart");
  }
  while (const auto impact = first_impact(ball, way, walls)) {
    const Point from = ball.center;
    ball.center += way * impact->t;
    std::printf("t = %.3f at (%.2f, %.2f), normal (%.2f, %.2f)\n", static_cast<double>(impact->t),
                static_cast<double>(impact->point.x), static_cast<double>(impact->point.y),
                static_cast<double>(impact->normal.x), static_cast<double>(impact->normal.y));
    picture.connect(from, ball.center);
    picture.draw(ball);
    const Point left = way * (1 - impact->t);
    way = left - impact->normal * (2 * dot(left, impact->normal));  // the rest of the path, reflected
    ball.center -= impact->normal * 1e-4F;  // away from the wall, or the next cast would start with this contact
  }
  picture.connect(ball.center, ball.center + way, "end");
  return picture.save(argc, argv);
}
