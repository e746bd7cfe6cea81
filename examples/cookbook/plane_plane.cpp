// SPDX-License-Identifier: MIT
// Two planes intersect unless they are parallel and apart. A plane intersects itself.
#include <cstdio>

#include <graze/query/intersects.hpp>

#include "picture.hpp"

using Plane = graze::Plane<3>;

// "They intersect if the normals are not parallel": unit normals whose dot product is not 1 or -1.
bool naive(const Plane& a, const Plane& b) {
  const float cosine = dot(normalize(a.normal), normalize(b.normal));
  return cosine != 1 && cosine != -1;
}

void print(const char* what, const Plane& a, const Plane& b) {
  std::printf("%-36s %s, naively %s\n", what, graze::intersects(a, b) ? "they meet" : "apart",
              naive(a, b) ? "they meet" : "apart");
}

int main(int argc, char** argv) {
  const Plane floor{{0, 0, 1}, 0};
  const Plane ceiling{{0, 0, 1}, 3};
  const Plane wall{{1, 0, 0}, 2};
  print("floor and wall:", floor, wall);
  print("floor and ceiling:", floor, ceiling);
  print("the floor and itself:", floor, floor);
  print("the floor, its normal turned over:", floor, Plane{{0, 0, -1}, 0});
  print("the ceiling, its normal 7 long:", ceiling, Plane{{0, 0, 7}, 21});
  print("a ramp that rises 1 in 10,000:", floor, Plane{{0.0001F, 0, 1}, 1});
  print("a ramp that rises 1 in 10,000,000:", floor, Plane{{0.0000001F, 0, 1}, 1});
  print("a tilted plane, and it 2.5 times:", Plane{{1, 2, 3}, 4}, Plane{{2.5F, 5, 7.5F}, 10});
  print("the same, one of them moved:", Plane{{1, 2, 3}, 4}, Plane{{2.5F, 5, 7.5F}, 11});

  cookbook::Picture<3> picture("planes");
  picture.add(floor, "floor");
  picture.add(wall, "wall");
  picture.draw(graze::Sphere<3>{{-2, -1, 1}, 1}, "ball");
  picture.draw(graze::Segment<3>{{-2, -1, 2}, {-2, -1, 4}});
  picture.draw(graze::Segment<3>{{2, -4, 0}, {2, 4, 0}});
  return picture.save(argc, argv);
}
