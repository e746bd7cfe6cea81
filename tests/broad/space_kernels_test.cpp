// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/broad/space_kernels.hpp>

namespace graze::detail::space_kernels_test {

template <Dim N, class T>
struct Named {
  int number;
};

namespace {

TEST(SpaceKernels, AreFoundByDimensionAndScalar) {
  constexpr SpaceKernels<Named> all{{20}, {30}, {200}, {300}};
  EXPECT_EQ((all.of<2, float>().number), 20);
  EXPECT_EQ((all.of<3, float>().number), 30);
  EXPECT_EQ((all.of<2, double>().number), 200);
  EXPECT_EQ((all.of<3, double>().number), 300);
}

}  // namespace
}  // namespace graze::detail::space_kernels_test
