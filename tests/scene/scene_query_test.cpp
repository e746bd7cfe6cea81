// SPDX-License-Identifier: MIT
#include <array>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <graze/scene/scene_query.hpp>

namespace graze::scene_query_test {
namespace {

using detail::admits;

const ObjectId one{1, 1, 7};
const ObjectId two{2, 1, 7};

TEST(SceneQuery, FindsEverythingByDefault) {
  EXPECT_TRUE(admits({}, one, 0));
  EXPECT_TRUE(admits({}, two, 63));
  EXPECT_TRUE(admits(SceneQuery{}, two, 63));
}

TEST(SceneQuery, FindsOnlyWhatIsOnItsLayers) {
  const SceneQuery query{.layers = only_layer(3) | only_layer(5)};
  EXPECT_TRUE(admits(query, one, 3));
  EXPECT_TRUE(admits(query, one, 5));
  EXPECT_FALSE(admits(query, one, 4));
  EXPECT_FALSE(admits({.layers = 0}, one, 0));
}

TEST(SceneQuery, FindsNothingThatIsExcepted) {
  const std::array<ObjectId, 2> except{ObjectId{9, 9, 9}, two};
  EXPECT_TRUE(admits({.except = except}, one, 0));
  EXPECT_FALSE(admits({.except = except}, two, 0));
  const ObjectId later{2, 3, 7};  // in the same place
  EXPECT_TRUE(admits({.except = except}, later, 0));
  EXPECT_FALSE(admits({.except = {&one, 1}}, one, 0));
}

TEST(SceneQuery, AsksThePredicateLast) {
  std::vector<ObjectId> asked;
  const SceneQuery query{.layers = only_layer(0), .except = {&one, 1}, .predicate = [&asked](ObjectId id) {
                           asked.push_back(id);
                           return id.index == 2;
                         }};
  EXPECT_TRUE(admits(query, two, 0));
  EXPECT_FALSE(admits(query, ObjectId{3, 1, 7}, 0));
  EXPECT_FALSE(admits(query, one, 0));
  EXPECT_FALSE(admits(query, two, 1));
  EXPECT_EQ(asked, (std::vector<ObjectId>{two, ObjectId{3, 1, 7}}));
}

TEST(SceneQuery, PassesOnWhatThePredicateThrows) {
  const SceneQuery query{.predicate = [](ObjectId) -> bool { throw std::runtime_error("no"); }};
  EXPECT_THROW(admits(query, one, 0), std::runtime_error);
}

}  // namespace
}  // namespace graze::scene_query_test
