// SPDX-License-Identifier: MIT
// The same boxes in each index. Results do not depend on the index or its options; time and memory do.
#include <cstdio>
#include <vector>

#include <graze/broad/scene_generators.hpp>
#include <graze/graze.hpp>

/// Whether an index gives the same results as brute force.
template <graze::SpatialIndex I>
bool agrees(const char* name, const I& index, const graze::BruteForce<3>& judge) {
  const graze::Sphere<3> region{{0, 0, 0}, 10};
  const std::size_t found = graze::count(index, region);
  std::printf("%-11s %zu of %zu boxes meet the ball; %zu KiB\n", name, found, index.size(), index.bytes() / 1024);
  const std::vector<graze::Neighbour> nearest = index.nearest({0, 0, 0}, 3);
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    if (nearest[i].distance_squared != judge.nearest({0, 0, 0}, 3)[i].distance_squared) return false;
  }
  return found > 0 && found == graze::count(judge, region);
}

int main() {
  const graze::MovingBoxes<3> world(graze::World::brownian, 20'000, 1);

  graze::BruteForce<3> judge;
  for (const auto& box : world.boxes()) judge.insert(box);

  // The fastest queries. The margin saves work while boxes move only a little.
  graze::Bvh<3> bvh(graze::BvhOptions{.margin = 0.5});
  const std::vector<graze::Key> keys = bvh.assign(world.boxes());
  bvh.update(keys[0], bvh.box(keys[0]));

  // Cells that split where there are many boxes.
  graze::Octree<> octree({.capacity = 16, .max_depth = 12});
  octree.assign(world.boxes());

  // Cells of one size for boxes of about the same size.
  graze::Grid<3> grid(graze::GridOptions{.smallest_cell = 2});
  for (const auto& box : world.boxes()) grid.insert(box);

  std::printf("margin %g, capacity %zu, smallest cell %g\n", bvh.options().margin, octree.options().capacity,
              grid.options().smallest_cell);
  const bool all_agree = agrees("BruteForce", judge, judge) && agrees("Bvh", bvh, judge) &&
                         agrees("Octree", octree, judge) && agrees("Grid", grid, judge);

  // Boxes that are far away or infinite are in no cell, but are found like the others.
  octree.insert(graze::Aabb<3>::everything());
  std::printf("%zu of %zu boxes are in no cell\n", octree.outside() + grid.outside(), octree.size() + grid.size());
  const bool is_found = graze::count(octree, graze::Aabb<3>::everything()) == octree.size();

  // clear() erases all boxes; their keys are never valid again.
  bvh.clear();
  octree.clear();
  grid.clear();
  return all_agree && is_found && bvh.size() + octree.size() + grid.size() == 0 && !bvh.contains(keys[0]) ? 0 : 1;
}
