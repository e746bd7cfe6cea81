// SPDX-License-Identifier: MIT
// The clearance of an assembly: which parts are closer to each other than allowed, how close, and where.
#include <cstdio>
#include <string>
#include <vector>

#include <graze/broad/pairs.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/separation.hpp>

#include "picture.hpp"

struct Part {
  std::string name;
  graze::AnyShape<2> shape;
};

int main(int argc, char** argv) {
  const std::vector<Part> parts{
      {"housing", graze::compound_of<2, float>({graze::Rect<>{{0, 0}, {12, 1}}, graze::Rect<>{{0, 1}, {1, 7}},
                                                graze::Rect<>{{11, 1}, {12, 3.25F}}, graze::Rect<>{{11, 5}, {12, 7}}})},
      {"shaft", graze::Capsule<2>{{3, 4}, {13, 4}, 0.5F}},
      {"gear", graze::Circle<>{{4, 2.25F}, 1}},
      {"pinion", graze::Circle<>{{6, 2.25F}, 1.125F}},
      {"lever", graze::OrientedRect<>{{8, 6}, {2.5F, 0.25F}, graze::Mat<2>(graze::rotation_matrix(-15))}},
      {"screw", graze::Rect<>{{2.2F, 1.06F}, {2.6F, 1.2F}}},
  };
  const float clearance = 0.5F;

  std::vector<graze::Rect<>> boxes;
  boxes.reserve(parts.size());
  for (const Part& part : parts) boxes.push_back(graze::bounds(part.shape));
  // Boxes within this distance overlap when each is grown by half of it.
  const auto candidates = graze::overlapping_pairs(boxes, {.margin = clearance / 2});
  std::printf("%zu of %zu pairs are worth a look\n", candidates.size(), parts.size() * (parts.size() - 1) / 2);

  cookbook::Picture<2> picture("parts that are nearer than 0.5");
  for (const Part& part : parts) picture.draw(part.shape, part.name);
  for (const graze::Pair pair : candidates) {
    const auto near = graze::separation(parts[pair.a].shape, parts[pair.b].shape);
    if (near.distance > clearance) continue;
    std::printf("%s and %s: ", parts[pair.a].name.c_str(), parts[pair.b].name.c_str());
    if (near.relation == graze::Relation::apart) {
      std::printf("%.3f apart, at (%.2f, %.2f)\n", near.distance, near.point_a.x, near.point_a.y);
      picture.connect(near.point_a, near.point_b);
    } else {
      std::printf("%.3f deep in each other, at (%.2f, %.2f)\n", -near.distance, near.point_a.x, near.point_a.y);
    }
  }
  return picture.save(argc, argv);
}
