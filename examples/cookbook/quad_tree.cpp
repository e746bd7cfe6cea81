// SPDX-License-Identifier: MIT
// A quadtree of boxes: what is in a region, what a ray hits first, what is near, and how its cells change.
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include <graze/broad/orthtree.hpp>

#include "picture.hpp"

// Coins on a spiral that becomes denser towards its center.
graze::Circle<> coin(std::size_t i) {
  const auto from_middle = static_cast<float>(91 - i);
  const float radius = 0.0025F * from_middle * from_middle;
  return {{radius * std::cos(0.7F * from_middle), radius * std::sin(0.7F * from_middle)}, 0.1F + 0.04F * radius};
}

int main(int argc, char** argv) {
  graze::QuadTree<> tree({.capacity = 4, .max_depth = 6});
  std::vector<graze::Key> keys;
  for (std::size_t i = 0; i < 90; ++i) keys.push_back(tree.insert(graze::bounds(coin(i))));

  cookbook::Picture<2> picture("the leaves of a quad tree");
  tree.visit_cells([&picture](const graze::OrthtreeCell<2, float>& cell) {
    if (cell.is_leaf) picture.draw(cell.box);
  });
  for (std::size_t i = 0; i < 90; ++i) picture.draw(coin(i));

  const graze::Circle<> light{{5, 5}, 6};
  picture.add(light, "light");
  tree.query(light, [&picture](graze::Key key) { picture.add(coin(key.index)); });
  std::printf("%zu of %zu boxes meet the light\n", graze::count(tree, light), tree.size());

  const graze::Ray<2> shot{{-20, -11}, {2, 1}};
  tree.ray_cast(shot, [](graze::Key key, double t) {
    std::printf("the shot hits box %u first, at t = %.3f\n", key.index, t);
    return false;  // the others, which come in order of t, are not needed
  });
  for (const graze::Neighbour& near : tree.nearest({10, 10}, 2)) {
    std::printf("near (10, 10): box %u, %.3f away\n", near.key.index, std::sqrt(near.distance_squared));
  }

  for (std::size_t i = 2; i < 90; ++i) tree.erase(keys[i]);
  std::size_t cells = 0;
  tree.visit_cells([&cells](const auto&) { ++cells; });
  std::printf("with two boxes left: %zu cell\n", cells);
  try {
    tree.update(keys[7], graze::Aabb<2>{});
  } catch (const std::out_of_range& error) {
    std::printf("%s\n", error.what());
  }
  return picture.save(argc, argv);
}
