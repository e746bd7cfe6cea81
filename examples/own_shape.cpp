// SPDX-License-Identifier: MIT
// A user-defined type is a shape if `support` is found for it: the point of the shape farthest along a direction.
#include <cmath>
#include <cstdio>

#include <graze/graze.hpp>

namespace garden {

/// A cone standing upright on its base.
struct Cone {
  graze::Vec<3, double> base_center;
  double radius;
  double height;
};

graze::Vec<3, double> support(const Cone& cone, const graze::Vec<3, double>& direction) {
  const graze::Vec<3, double> apex = cone.base_center + graze::Vec<3, double>(0, 0, cone.height);
  graze::Vec<3, double> rim = cone.base_center;
  const double sideways = std::hypot(direction.x, direction.y);
  if (sideways > 0) rim += graze::Vec<3, double>(direction.x, direction.y, 0) * (cone.radius / sideways);
  return dot(apex, direction) > dot(rim, direction) ? apex : rim;
}

}  // namespace garden

int main() {
  const garden::Cone tree{{0, 0, 0}, 1, 4};
  const graze::Sphere<3, double> bird{{0, 0, 5}, 1};
  const graze::Aabb<3, double> bench{{1.5, -1, 0}, {2, 1, 0.5}};
  const graze::Aabb<3, double> box = graze::bounds(tree);
  const graze::GjkResult<3> distance = graze::gjk(tree, bench);
  std::printf("tree is %.1f wide, up to %.1f high\n", box.max.x - box.min.x, box.max.z);
  std::printf("bird and tree: %s\n", graze::name_of(graze::relation(bird, tree)).data());
  std::printf("bench and tree: %s, %.2f apart\n", graze::name_of(graze::relation(bench, tree)).data(), distance.upper);

  const bool as_expected = graze::relation(bird, tree) == graze::Relation::touching && !graze::intersects(bench, tree);
  return as_expected ? 0 : 1;
}
