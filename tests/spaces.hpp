// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <graze/shape/shape.hpp>

namespace graze::test {

/// The spaces for TYPED_TEST_SUITE: a test body reads TypeParam::dimension and TypeParam::scalar. Builds with
/// sanitizers define GRAZE_TEST_BRIEFLY: the same code, with each dimension and each scalar, in half the time.
#ifdef GRAZE_TEST_BRIEFLY
using Spaces = testing::Types<Space<2, float>, Space<3, double>>;
#else
using Spaces = testing::Types<Space<2, float>, Space<3, float>, Space<2, double>, Space<3, double>>;
#endif

}  // namespace graze::test
