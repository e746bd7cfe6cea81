// SPDX-License-Identifier: MIT
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <graze/scene/scene.hpp>
#include <graze/scene/visit_candidates.hpp>

namespace graze::visit_candidates_test {
namespace {

/// Boxes in a cluster, with gaps where some were removed, on layers of which two do not collide.
Scene<2, double> cluster() {
  Scene<2, double> scene;
  const Layer walls = scene.layer("walls");
  const Layer others = scene.layer("others");
  std::vector<ObjectId> ids;
  for (int i = 0; i < 300; ++i) {
    const double x = 0.1 * (i % 50);
    const bool is_wall = i % 3 == 0;
    ids.push_back(scene.add(Aabb<2, double>{{x, 0}, {x + 1, 1}},
                            {.layer = is_wall ? walls : others, .mask = is_wall ? only_layer(others) : all_layers}));
  }
  for (std::size_t i = 0; i < ids.size(); i += 7) scene.remove(ids[i]);
  return scene;
}

TEST(VisitCandidates, gives_the_candidates_in_their_order_and_in_blocks) {
  const Scene<2, double> scene = cluster();
  for (const double margin : {0.0, 0.5}) {
    std::vector<ObjectPair> visited;
    const auto take = [&visited](std::span<const ObjectPair> block) {
      EXPECT_FALSE(block.empty());
      EXPECT_LE(block.size(), 4096U);
      visited.insert(visited.end(), block.begin(), block.end());
      return true;
    };
    visit_candidates(scene, take, margin);
    EXPECT_GT(visited.size(), 4096U);
    EXPECT_EQ(visited, scene.candidates(margin));
  }
}

TEST(VisitCandidates, stops_when_the_visitor_has_enough) {
  const Scene<2, double> scene = cluster();
  int calls = 0;
  visit_candidates(scene, [&calls](std::span<const ObjectPair>) { return ++calls < 2; });
  EXPECT_EQ(calls, 2);
}

TEST(VisitCandidates, refuses_a_margin_that_is_none) {
  const Scene<3, float> scene;
  const auto ignore = [](std::span<const ObjectPair>) { return true; };
  EXPECT_NO_THROW(visit_candidates(scene, ignore, 0));
  EXPECT_THROW(visit_candidates(scene, ignore, -1), std::invalid_argument);
  EXPECT_THROW(visit_candidates(scene, ignore, std::numeric_limits<double>::infinity()), std::invalid_argument);
}

}  // namespace
}  // namespace graze::visit_candidates_test
