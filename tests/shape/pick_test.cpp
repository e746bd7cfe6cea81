// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/shape/pick.hpp>

#include "catalogue.hpp"

namespace graze::pick_test {
namespace {

using V3 = Vec<3, double>;
using V2 = Vec<2, double>;

std::string message_of(const auto& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

/// From (1, 2, 3) along x, with z upwards; so -y is to the right.
const glm::dmat4 view = glm::lookAtRH(glm::dvec3(1, 2, 3), glm::dvec3(2, 2, 3), glm::dvec3(0, 0, 1));

constexpr double right_angle = 1.5707963267948966;  // so that half the height is the depth, and half the width twice it

template <class T>
void expect_ray(const Ray<3, T>& ray, const V3& origin, const V3& along, double error) {
  EXPECT_LE(max_abs(V3(ray.origin) - origin), error) << test::to_source(ray);
  EXPECT_LE(max_abs(V3(ray.direction) - along / std::sqrt(dot(along, along))), error) << test::to_source(ray);
}

TEST(Pick, PixelsCountFromTheUpperLeftCorner) {
  const V2 window(800, 400);
  EXPECT_EQ(device_point(V2(0, 0), window), V2(-1, 1));
  EXPECT_EQ(device_point(V2(800, 400), window), V2(1, -1));
  EXPECT_EQ(device_point(V2(400, 200), window), V2(0, 0));
  EXPECT_EQ(device_point(V2(600, 100), window), V2(0.5, 0.5));
  EXPECT_EQ(device_point(Vec<2, float>(0.5F, 0.5F), Vec<2, float>(1, 1)), (Vec<2, float>(0, 0)));
}

TEST(Pick, AWindowWithoutAreaIsRefused) {
  const char* const message = "device_point: the window has no area; its width and height must be above zero";
  for (const V2& window : {V2(0, 1), V2(1, -1), V2(1, std::numeric_limits<double>::quiet_NaN())}) {
    EXPECT_EQ(message_of([&] { device_point(V2(1, 1), window); }), message);
  }
}

TEST(Pick, ARayStartsOnTheNearPlaneAndLooksForwardByEveryConvention) {
  const glm::dmat4 plain = glm::perspectiveRH_NO(right_angle, 2.0, 1.0, 10.0) * view;
  expect_ray(pick_ray(plain, {0, 0}), {2, 2, 3}, {1, 0, 0}, 1e-14);
  expect_ray(pick_ray(plain, {1, -1}), {2, 0, 2}, {1, -2, -1}, 1e-14);
  const glm::dmat4 zero_to_one = glm::perspectiveRH_ZO(right_angle, 2.0, 1.0, 10.0) * view;
  expect_ray(pick_ray(zero_to_one, {-0.5, 0.5}, ClipDepth::zero_to_one), {2, 3, 3.5}, {1, 1, 0.5}, 1e-14);
  const glm::dmat4 reversed = glm::perspectiveRH_ZO(right_angle, 2.0, 10.0, 1.0) * view;
  expect_ray(pick_ray(reversed, {-0.5, 0.5}, ClipDepth::one_to_zero), {2, 3, 3.5}, {1, 1, 0.5}, 1e-14);
  expect_ray(pick_ray(glm::mat4(plain), {1, -1}), {2, 0, 2}, {1, -2, -1}, 1e-6);
}

TEST(Pick, ARayNeedsNoFarPlaneAndNoPerspective) {
  const glm::dmat4 endless = glm::infinitePerspectiveRH(right_angle, 2.0, 1.0) * view;
  expect_ray(pick_ray(endless, {1, -1}), {2, 0, 2}, {1, -2, -1}, 1e-14);
  const glm::dmat4 parallel = glm::orthoRH_NO(-2.0, 2.0, -1.0, 1.0, 1.0, 10.0) * view;
  expect_ray(pick_ray(parallel, {1, -1}), {2, 0, 2}, {1, 0, 0}, 1e-14);
  EXPECT_EQ(pick_ray(Mat<4, float>(1), {0.5F, 0.25F}).origin, (Vec<3, float>(0.5F, 0.25F, -1)));
}

TEST(Pick, InThePlaneThePointItselfIsFound) {
  Mat<3, double> camera(1);  // twice as large, and (3, 4) in the middle
  camera[0][0] = camera[1][1] = 2;
  camera[2][0] = -6;
  camera[2][1] = -8;
  EXPECT_EQ(pick_point(camera, {0, 0}), V2(3, 4));
  EXPECT_EQ(pick_point(camera, {1, -0.5}), V2(3.5, 3.75));
}

TEST(Pick, RefusesNonsense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of([&] {
              pick_ray(Mat<4, double>(nan), {0, 0});
            }),
            "pick_ray: the matrix has a number that is not finite");
  EXPECT_EQ(message_of([&] {
              pick_ray(Mat<4, double>(1), {0, nan});
            }),
            "pick_ray: the point has a coordinate that is not finite");
  EXPECT_EQ(message_of([&] { pick_ray(Mat<4, double>(0), {0, 0}); }), "pick_ray: the matrix is not that of a camera");
  EXPECT_EQ(message_of([&] {
              pick_point(Mat<3, double>(0), {0, 0});
            }),
            "pick_point: the matrix is not that of a camera");
  EXPECT_EQ(message_of([&] {
              pick_point(Mat<3, double>(1), {nan, 0});
            }),
            "pick_point: the point has a coordinate that is not finite");
}

// All points of the ray project to the picked position, with increasing depth.
RC_GTEST_PROP(Pick, ARayIsSeenAsThePointThatWasPicked, ()) {
  const auto coordinate = [] { return *rc::gen::inRange(-1000, 1000) / 100.0; };
  const glm::dvec3 eye(coordinate(), coordinate(), coordinate());
  const glm::dvec3 towards(coordinate(), coordinate(), coordinate());
  RC_PRE(glm::length(towards) > 0.1 && std::hypot(towards.x, towards.y) > 0.1);
  const bool has_perspective = *rc::gen::arbitrary<bool>();
  const glm::dmat4 projection = has_perspective
                                    ? glm::perspectiveRH_ZO(*rc::gen::element(0.5, 1.0, 2.0), 1.5, 0.5, 20.0)
                                    : glm::orthoRH_ZO(-3.0, 2.0, -1.0, 4.0, 0.5, 20.0);
  const glm::dmat4 matrix = projection * glm::lookAtRH(eye, eye + towards, glm::dvec3(0, 0, 1));
  const V2 device(*rc::gen::inRange(-100, 100) / 99.0, *rc::gen::inRange(-100, 100) / 99.0);
  const Ray<3, double> ray = pick_ray(matrix, device, ClipDepth::zero_to_one);
  double depth = -1e-9;
  for (const double t : {0.0, 0.5, 3.0, 15.0}) {
    const glm::dvec4 clip = matrix * glm::dvec4(ray.origin + ray.direction * t, 1);
    RC_ASSERT(std::fabs(clip.x / clip.w - device.x) < 1e-9);
    RC_ASSERT(std::fabs(clip.y / clip.w - device.y) < 1e-9);
    RC_ASSERT(t > 0 || std::fabs(clip.z) < 1e-9);
    RC_ASSERT(clip.z / clip.w > depth);
    depth = clip.z / clip.w;
  }
}

}  // namespace
}  // namespace graze::pick_test
