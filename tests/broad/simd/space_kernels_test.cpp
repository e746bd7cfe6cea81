// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/broad/simd/space_kernels.hpp>

namespace graze::detail::space_kernels_test {

template <Dim N, class T>
struct Named {
  int number;
};

template <class T>
struct NamedByScalar {
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

TEST(ScalarKernels, AreFoundByScalar) {
  constexpr ScalarKernels<NamedByScalar> all{{4}, {8}};
  EXPECT_EQ(all.of<float>().number, 4);
  EXPECT_EQ(all.of<double>().number, 8);
}

}  // namespace
}  // namespace graze::detail::space_kernels_test
