// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "spatial_index_laws.hpp"

namespace graze::test::spatial_index_laws_grid_2d_test {
namespace {

using Tested = testing::Types<Grid<2, float>, Grid<2, double>>;
INSTANTIATE_TYPED_TEST_SUITE_P(GridInPlane, SpatialIndexLaws, Tested);

}  // namespace
}  // namespace graze::test::spatial_index_laws_grid_2d_test
