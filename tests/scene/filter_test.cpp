// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/scene/filter.hpp>

namespace graze::filter_test {
namespace {

TEST(Filter, AMaskHasOneBitForEachLayer) {
  EXPECT_EQ(only_layer(0), 1U);
  EXPECT_EQ(only_layer(63), LayerMask{1} << 63U);
  LayerMask all = 0;
  for (Layer layer = 0; layer < max_layers; ++layer) all |= only_layer(layer);
  EXPECT_EQ(all, all_layers);
}

TEST(Filter, BothMasksMustAdmitTheOther) {
  EXPECT_TRUE(filters_admit(1, all_layers, 2, all_layers));
  EXPECT_TRUE(filters_admit(1, only_layer(2), 2, only_layer(1)));
  EXPECT_FALSE(filters_admit(1, only_layer(1), 2, all_layers));
  EXPECT_FALSE(filters_admit(1, all_layers, 2, only_layer(2)));
  EXPECT_FALSE(filters_admit(1, 0, 1, all_layers));
}

TEST(Filter, SwappingTheObjectsChangesNothing) {
  for (Layer a = 0; a < 4; ++a) {
    for (Layer b = 0; b < 4; ++b) {
      for (LayerMask mask_a = 0; mask_a < 16; ++mask_a) {
        for (LayerMask mask_b = 0; mask_b < 16; ++mask_b) {
          EXPECT_EQ(filters_admit(a, mask_a, b, mask_b), filters_admit(b, mask_b, a, mask_a));
        }
      }
    }
  }
}

}  // namespace
}  // namespace graze::filter_test
