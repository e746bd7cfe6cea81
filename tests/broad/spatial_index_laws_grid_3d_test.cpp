// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "spatial_index_laws.hpp"

namespace graze::test::spatial_index_laws_grid_3d_test {
namespace {

using Tested = testing::Types<Grid<3, float>, Grid<3, double>>;
INSTANTIATE_TYPED_TEST_SUITE_P(GridInSpace, SpatialIndexLaws, Tested);

}  // namespace
}  // namespace graze::test::spatial_index_laws_grid_3d_test
