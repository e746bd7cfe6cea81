// SPDX-License-Identifier: MIT
#include <graze/query/bounds.hpp>
#include <graze/shape/sphere.hpp>

int main() {
  const graze::Aabb<3> box = graze::bounds(graze::Sphere<3>{{1, 2, 3}, 1});
  return box.min == graze::Vec<3>{0, 1, 2} && box.max == graze::Vec<3>{2, 3, 4} ? 0 : 1;
}
