// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "spatial_index_laws.hpp"

namespace graze::test::spatial_index_laws_3d_float_test {
namespace {

using Tested = Indexes<3, float>;
INSTANTIATE_TYPED_TEST_SUITE_P(InSpaceInFloat, SpatialIndexLaws, Tested);

}  // namespace
}  // namespace graze::test::spatial_index_laws_3d_float_test
