// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "spatial_index_laws.hpp"

namespace graze::test {
namespace {

using Tested = Indexes<2, double>;
INSTANTIATE_TYPED_TEST_SUITE_P(InPlaneInDouble, SpatialIndexLaws, Tested);

}  // namespace
}  // namespace graze::test
