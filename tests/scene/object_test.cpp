// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/scene/object.hpp>

namespace graze::object_test {
namespace {

TEST(ObjectId, IsOrderedByIndexThenGeneration) {
  EXPECT_LT((ObjectId{1, 9, 3}), (ObjectId{2, 1, 3}));
  EXPECT_LT((ObjectId{1, 1, 3}), (ObjectId{1, 3, 3}));
  EXPECT_EQ((ObjectId{1, 3, 3}), (ObjectId{1, 3, 3}));
}

TEST(MayTouch, AsksBothMasksAndLeavesOutWhatIsFixed) {
  const auto object = [](Layer layer, LayerMask mask, Mobility mobility) {
    return Object<2, float>{{}, Vec<2, float>(0), "", layer, mobility, mask, 0};
  };
  const auto ghost = object(1, only_layer(1), Mobility::moving);
  const auto wall = object(0, all_layers, Mobility::fixed);
  const auto player = object(0, all_layers, Mobility::moving);
  EXPECT_TRUE(may_touch(player, wall));
  EXPECT_TRUE(may_touch(wall, player));
  EXPECT_TRUE(may_touch(player, player));
  EXPECT_FALSE(may_touch(wall, wall));
  EXPECT_FALSE(may_touch(ghost, player));
  EXPECT_FALSE(may_touch(player, ghost));
}

TEST(ObjectOptions, DefaultToAnUnnamedObjectThatTouchesEverything) {
  const ObjectOptions options;
  EXPECT_TRUE(options.name.empty());
  EXPECT_EQ(options.layer, 0);
  EXPECT_EQ(options.mask, all_layers);
  EXPECT_EQ(options.user, 0U);
  EXPECT_EQ(options.mobility, Mobility::moving);
}

}  // namespace
}  // namespace graze::object_test
