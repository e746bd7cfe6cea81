// SPDX-License-Identifier: MIT
#include <limits>

#include <gtest/gtest.h>

#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/nan_check.hpp>
#include <graze/shape/frustum.hpp>

namespace graze::nan_check_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
const Vec<2, float> plain(1, -2);
const Vec<2, float> spoiled(1, nan);
const Mat<2, float> turned(1.0F);

TEST(NanCheck, FindsANaNInAnyNumber) {
  EXPECT_TRUE(detail::any_nan(spoiled, plain));
  EXPECT_TRUE(detail::any_nan(plain, spoiled));
  EXPECT_TRUE(detail::any_nan(Segment<2>{plain, spoiled}, plain));
  EXPECT_TRUE(detail::any_nan(Ray<2>{spoiled, plain}, plain));
  EXPECT_TRUE(detail::any_nan(Sphere<2>{plain, nan}, plain));
  EXPECT_TRUE(detail::any_nan(Aabb<2>{plain, spoiled}, plain));
  EXPECT_TRUE(detail::any_nan(Obb<2>{plain, spoiled, turned}, plain));
  EXPECT_TRUE(detail::any_nan(Obb<2>{plain, plain, Mat<2>(plain, spoiled)}, plain));
  EXPECT_TRUE(detail::any_nan(Plane<2>{plain, nan}, plain));
  EXPECT_TRUE(detail::any_nan(HalfSpace<2>{spoiled, 1}, plain));
  EXPECT_TRUE(detail::any_nan(Triangle<2>{plain, plain, spoiled}, plain));
  EXPECT_TRUE(detail::any_nan(Capsule<2>{plain, plain, nan}, plain));
  EXPECT_TRUE(detail::any_nan(Frustum<2>{{{plain, plain, plain, spoiled}}}, plain));
}

TEST(NanCheck, TakesNothingElseForNaN) {
  const float largest = std::numeric_limits<float>::max();
  const Aabb<2> everything{Vec<2>(-infinity), Vec<2>(infinity)};
  EXPECT_FALSE(detail::any_nan(everything, everything));
  EXPECT_FALSE(detail::any_nan(Triangle<2>{Vec<2>(largest), Vec<2>(-largest), Vec<2>(largest)}, plain));
  EXPECT_FALSE(detail::any_nan(Sphere<2>{plain, 1}, Obb<2>{plain, plain, turned}));
}

}  // namespace
}  // namespace graze::nan_check_test
