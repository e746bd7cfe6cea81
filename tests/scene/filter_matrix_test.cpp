// SPDX-License-Identifier: MIT
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/scene/filter_matrix.hpp>
#include <graze/scene/scene.hpp>

namespace graze::filter_matrix_test {
namespace {

TEST(FilterMatrix, LetsAllTouchAtFirst) {
  const FilterMatrix matrix;
  for (Layer layer = 0; layer < max_layers; ++layer) EXPECT_EQ(matrix.mask_of(layer), all_layers);
}

TEST(FilterMatrix, IsTheSameWhicheverLayerComesFirst) {
  FilterMatrix matrix;
  matrix.part(3, 63);
  matrix.part(5, 5);
  for (Layer a = 0; a < max_layers; ++a) {
    for (Layer b = 0; b < max_layers; ++b) {
      const bool is_apart = (a == 3 && b == 63) || (a == 63 && b == 3) || (a == 5 && b == 5);
      EXPECT_EQ(matrix.can_touch(a, b), !is_apart);
      EXPECT_EQ((matrix.mask_of(a) & only_layer(b)) != 0, !is_apart);
    }
  }
  matrix.join(63, 3);
  matrix.join(5, 5);
  EXPECT_EQ(matrix, FilterMatrix());
}

TEST(FilterMatrix, DecidesWhichObjectsOfASceneArePairs) {
  constexpr Layer players = 0;
  constexpr Layer shots = 1;
  constexpr Layer walls = 2;
  FilterMatrix matrix;
  matrix.part(players, shots);
  matrix.part(shots, shots);
  Scene<2> scene;
  std::vector<ObjectId> ids;
  const auto add = [&](Layer layer) {
    ids.push_back(scene.add(Circle<>{{0, 0}, 1}, {.layer = layer, .mask = matrix.mask_of(layer)}));
  };
  for (const Layer layer : {players, shots, shots, walls}) add(layer);
  EXPECT_EQ(scene.pairs(), (std::vector<ObjectPair>{{ids[0], ids[3]}, {ids[1], ids[3]}, {ids[2], ids[3]}}));
}

TEST(FilterMatrix, NamesALayerThatThereIsNot) {
  FilterMatrix matrix;
  try {
    matrix.part(2, 64);
    FAIL() << "there is no layer 64";
  } catch (const std::out_of_range& error) {
    EXPECT_EQ(std::string(error.what()), "FilterMatrix: there is no layer 64; layers are numbered 0 to 63");
  }
  EXPECT_THROW(matrix.join(255, 2), std::out_of_range);
  EXPECT_THROW(static_cast<void>(matrix.can_touch(64, 64)), std::out_of_range);
  EXPECT_THROW(static_cast<void>(matrix.mask_of(64)), std::out_of_range);
  EXPECT_EQ(matrix, FilterMatrix());
}

}  // namespace
}  // namespace graze::filter_matrix_test
