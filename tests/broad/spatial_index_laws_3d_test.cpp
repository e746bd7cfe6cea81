// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "spatial_index_laws.hpp"

namespace graze::test {
namespace {

INSTANTIATE_TYPED_TEST_SUITE_P(InSpace, SpatialIndexLaws, Indexes<3>);

}  // namespace
}  // namespace graze::test
