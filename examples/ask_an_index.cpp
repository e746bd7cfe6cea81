// SPDX-License-Identifier: MIT
// All queries of an index of boxes, in one function that takes any index. All indexes give the same results.
#include <cstdio>
#include <utility>
#include <vector>

#include <graze/broad/scene_generators.hpp>
#include <graze/graze.hpp>

using Box = graze::Aabb<2>;

/// The numbers of results, which do not depend on the index.
template <graze::SpatialIndex I>
std::vector<std::size_t> ask(I index) {
  std::vector<graze::Key> keys;
  for (int row = 0; row < 10; ++row) {
    for (int column = 0; column < 10; ++column) {
      const graze::Vec<2> center(static_cast<float>(column) * 3, static_cast<float>(row) * 3);
      keys.push_back(index.insert(Box::from_center(center, {1, 1})));
    }
  }
  index.update(keys[0], Box{{2, 2}, {4, 4}});  // onto its neighbour
  index.erase(keys[99]);

  // Regions of any bounded shape; a visitor that returns false ends the visit.
  std::size_t in_ball = 0;
  index.query(graze::Circle<>{{9, 9}, 4}, [&in_ball](graze::Key) { ++in_ball; });

  // A ray hits boxes in order.
  std::vector<std::pair<graze::Key, double>> hits;
  index.ray_cast(graze::Ray<2>{{-5, 9}, {1, 0}}, [&hits](graze::Key key, double t) {
    hits.emplace_back(key, t);
    return hits.size() < 3;
  });

  // So does a box that moves: here up, from below all of them.
  std::size_t in_the_way = 0;
  index.cast(Box{{8, -9}, {10, -8}}, {0, 20}, [&in_the_way](graze::Key, double) { ++in_the_way; });

  const graze::Neighbour nearest = index.nearest({28, 28}, 1).front();
  std::size_t pairs = 0;
  index.pairs([&pairs](graze::Key, graze::Key) { ++pairs; });
  std::printf("%zu boxes in the ball, the third hit at t = %g, box %u is nearest, %zu pairs\n", in_ball, hits[2].second,
              nearest.key.index, pairs);
  const bool knows_keys = index.contains(keys[0]) && !index.contains(keys[99]) && index.box(keys[0]).min.x == 2;
  return {in_ball, hits[2].first.index, in_the_way, nearest.key.index, pairs, knows_keys ? index.size() : 0};
}

/// The number of cells of an index, which can be drawn.
template <class I>
std::size_t cells_of(const graze::MovingBoxes<2>& world) {
  I index;
  for (const Box& box : world.boxes()) index.insert(box);
  std::size_t cells = 0;
  index.visit_cells([&cells](const auto& cell) { cells += cell.count > 0 ? 1 : 0; });
  return cells;
}

int main() {
  const std::vector<std::size_t> answers = ask(graze::BruteForce<2>());
  const graze::MovingBoxes<2> world(graze::World::brownian, 1000, 1);
  std::printf("cells: Bvh %zu, QuadTree %zu, Grid %zu\n", cells_of<graze::Bvh<2>>(world),
              cells_of<graze::QuadTree<>>(world), cells_of<graze::Grid<2>>(world));
  const bool are_equal = ask(graze::Bvh<2>()) == answers && ask(graze::QuadTree<>()) == answers;
  return are_equal && ask(graze::Grid<2>()) == answers && answers.back() == 99 ? 0 : 1;
}
