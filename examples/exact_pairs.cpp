// SPDX-License-Identifier: MIT
// Both phases by hand, without a scene: overlapping boxes first, then the exact test of these candidates.
#include <cstdio>
#include <vector>

#include <graze/graze.hpp>

int main() {
  const std::vector<graze::AnyShape<3>> shapes = {
      graze::Sphere<3>{{0, 0, 0}, 1},
      graze::Sphere<3>{{2, 0, 0}, 1},                 // touches the first
      graze::Sphere<3>{{1.5F, 1.5F, 0}, 0.5F},        // only its box overlaps that of the first
      graze::Capsule<3>{{2, 0, 0}, {2, 0, 5}, 0.5F},  // overlaps the second
      graze::HalfSpace<3>{{0, 0, 1}, -1},             // both big spheres lie on it
  };
  std::vector<graze::Aabb<3>> boxes;
  for (const graze::AnyShape<3>& shape : shapes) {
    if (!graze::is_valid(shape)) {
      std::fprintf(stderr, "a %s %s\n", graze::type_name(shape).data(), graze::defect(shape).data());
      return 1;
    }
    boxes.push_back(graze::touching_bounds(shape));  // larger than bounds(shape), so that rounding hides no pair
  }
  const std::vector<graze::Pair> candidates = graze::overlapping_pairs(boxes);

  // One verdict for each candidate.
  const std::vector<graze::Relation> verdicts = graze::relations<3, float>(shapes, candidates);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    std::printf("%s %u and %s %u: %s\n", graze::type_name(shapes[candidates[i].a]).data(), candidates[i].a,
                graze::type_name(shapes[candidates[i].b]).data(), candidates[i].b, graze::name_of(verdicts[i]).data());
  }

  // Or only those that intersect.
  const std::vector<graze::Pair> pairs = graze::touching_pairs<3, float>(shapes, candidates);
  std::printf("%zu candidates, %zu pairs\n", candidates.size(), pairs.size());

  // Or also where they touch.
  const std::vector<graze::PairContact<3>> contacts = graze::contacts(shapes, pairs);
  for (const graze::PairContact<3>& contact : contacts) {
    std::printf("%u and %u touch at %zu points\n", contact.pair.a, contact.pair.b, contact.manifold.points.size());
  }
  return contacts.size() == pairs.size() && pairs == std::vector<graze::Pair>{{0, 1}, {0, 4}, {1, 3}, {1, 4}} ? 0 : 1;
}
