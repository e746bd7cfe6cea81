// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "spatial_index_laws.hpp"

namespace graze::test::spatial_index_laws_3d_double_test {
namespace {

using Tested = Indexes<3, double>;
INSTANTIATE_TYPED_TEST_SUITE_P(InSpaceInDouble, SpatialIndexLaws, Tested);

}  // namespace
}  // namespace graze::test::spatial_index_laws_3d_double_test
