// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/scene/object.hpp>

namespace graze {
namespace {

TEST(ObjectId, IsOrderedByIndexThenGeneration) {
  EXPECT_LT((ObjectId{1, 9}), (ObjectId{2, 0}));
  EXPECT_LT((ObjectId{1, 0}), (ObjectId{1, 1}));
  EXPECT_EQ((ObjectId{1, 2}), (ObjectId{1, 2}));
}

TEST(ObjectOptions, DefaultToAnUnnamedObjectThatTouchesEverything) {
  const ObjectOptions options;
  EXPECT_TRUE(options.name.empty());
  EXPECT_EQ(options.layer, 0);
  EXPECT_EQ(options.mask, all_layers);
  EXPECT_EQ(options.user, 0U);
}

}  // namespace
}  // namespace graze
