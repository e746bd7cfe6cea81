// SPDX-License-Identifier: MIT
// The convex hull of points against any shape; a non-convex polygon as several convex ones.
#include <cstdio>
#include <vector>

#include <graze/query/bounds.hpp>
#include <graze/query/convex_parts.hpp>
#include <graze/query/intersects.hpp>
#include <graze/shape/polytope.hpp>

#include "picture.hpp"

using Point = graze::Vec<2>;
using Points = std::vector<Point>;

// The convex parts of a polygon that need not be convex; empty if its outline crosses itself.
graze::Compound<2> solid_polygon(const Points& outline) {
  std::vector<graze::AnyShape<2>> parts;
  if (const auto convex = graze::convex_parts<float>(outline)) {
    for (const Points& corners : *convex) parts.emplace_back(graze::convex_hull<2, float>(corners));
  }
  return graze::compound_of<2, float>(parts);
}

const char* say(bool yes) { return yes ? "touching" : "apart"; }

int main(int argc, char** argv) {
  const Points points{{-9, 0}, {-5, -2}, {-2, 1}, {-4, 5}, {-8, 4}, {-6, 2}, {-3.5F, -0.5F}};
  const auto rock = graze::convex_hull<2, float>(points);
  std::printf("the hull of %zu points has %zu corners\n", points.size(), rock.vertices().size());
  const graze::OrientedRect<> plank{{-9, 4}, {2.5F, 0.4F}, graze::Mat<2>(graze::rotation_matrix(-50))};
  const graze::Circle<> pebble{{-1, -2}, 1.5F};
  std::printf("rock and plank: %s, rock and pebble: %s\n", say(graze::intersects(rock, plank)),
              say(graze::intersects(rock, pebble)));

  const Points outline{{3, -2}, {13, -2}, {13, 6}, {11, 6}, {11, 0}, {5, 0}, {5, 6}, {3, 6}};
  const graze::Compound<2> basin = solid_polygon(outline);
  const graze::Circle<> fish{{8, 3}, 2};
  std::printf("the basin has %zu convex parts\n", basin.parts.size());
  std::printf("basin and fish: %s, by the hull of its corners: %s\n", say(graze::intersects(basin, fish)),
              say(graze::intersects(graze::convex_hull<2, float>(outline), fish)));
  const Points bow{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  std::printf("a bow tie, which crosses itself: %s\n", graze::convex_parts<float>(bow) ? "parts" : "no polygon");

  cookbook::Picture<2> picture("polygons");
  picture.add(rock, "rock");
  picture.add(plank, "plank");
  picture.add(pebble, "pebble");
  picture.add(basin, "basin");
  picture.add(fish, "fish");
  return picture.save(argc, argv);
}
