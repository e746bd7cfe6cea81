// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "spatial_index_laws.hpp"

namespace graze::test {
namespace {

INSTANTIATE_TYPED_TEST_SUITE_P(InPlane, SpatialIndexLaws, Indexes<2>);

}  // namespace
}  // namespace graze::test
