// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/bounds.hpp>
#include <graze/query/contains.hpp>
#include <graze/shape/frustum.hpp>

#include "../cameras.hpp"
#include "../catalogue/nasty.hpp"

namespace graze::frustum_test {
namespace {

using V = Vec<3, double>;

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

/// The corners from depth 1 to depth 10, by hand.
const Frustum<3, double> by_hand{
    {{{2, 4, 2}, {2, 0, 2}, {2, 4, 4}, {2, 0, 4}, {11, 22, -7}, {11, -18, -7}, {11, 22, 13}, {11, -18, 13}}}};

template <class T>
void expect_corners(const Frustum<3, T>& seen, const Frustum<3, double>& expected, double error) {
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_LE(max_abs(V(seen.corners[k]) - expected.corners[k]), error) << k << " " << test::to_source(seen);
  }
}

TEST(Frustum, IsTheBoxFromMinusOneToOneByDefault) {
  EXPECT_EQ((bounds(Frustum<2>{})), (Aabb<2>{}));
  EXPECT_EQ((bounds(Frustum<3, double>{})), (Aabb<3, double>{}));
  EXPECT_EQ((Frustum<3>{}.corners[5]), (Vec<3, float>(1, -1, 1)));
}

TEST(Frustum, OfTheUnitMatrixIsThatBoxToo) {
  EXPECT_EQ(frustum_of(Mat<4, double>(1)).corners, (Frustum<3, double>{}.corners));
  EXPECT_EQ(frustum_of(Mat<3, float>(1)).corners, (Frustum<2, float>{}.corners));
}

TEST(Frustum, IsTheSameByEveryDepthConvention) {
  expect_corners(frustum_of(glm::perspectiveRH_NO(right_angle, 2.0, 1.0, 10.0) * view), by_hand, 1e-13);
  expect_corners(frustum_of(glm::perspectiveRH_ZO(right_angle, 2.0, 1.0, 10.0) * view, {ClipDepth::zero_to_one}),
                 by_hand, 1e-13);
  expect_corners(frustum_of(glm::perspectiveRH_ZO(right_angle, 2.0, 10.0, 1.0) * view, {ClipDepth::one_to_zero}),
                 by_hand, 1e-13);
  const glm::mat4 narrow(glm::perspectiveRH_NO(right_angle, 2.0, 1.0, 10.0) * view);
  expect_corners(frustum_of(narrow), by_hand, 1e-4);
}

TEST(Frustum, IsTheSameByALeftHandedProjection) {
  const glm::dmat4 left = glm::lookAtLH(glm::dvec3(1, 2, 3), glm::dvec3(2, 2, 3), glm::dvec3(0, 0, 1));
  Frustum<3, double> mirrored = by_hand;  // +y is to its right
  for (std::size_t k = 0; k < 8; k += 2) std::swap(mirrored.corners[k], mirrored.corners[k + 1]);
  expect_corners(frustum_of(glm::perspectiveLH_NO(right_angle, 2.0, 1.0, 10.0) * left), mirrored, 1e-13);
}

TEST(Frustum, WithoutPerspectiveIsABox) {
  const Frustum<3, double> seen = frustum_of(glm::orthoRH_NO(-2.0, 2.0, -1.0, 1.0, 1.0, 10.0) * view);
  expect_corners(seen, {{{{2, 4, 2}, {2, 0, 2}, {2, 4, 4}, {2, 0, 4}, {11, 4, 2}, {11, 0, 2}, {11, 4, 4}, {11, 0, 4}}}},
                 1e-13);
}

TEST(Frustum, EndsAtTheFarLimitIfThatIsNearer) {
  Frustum<3, double> shorter = by_hand;  // at depth 5
  shorter.corners[4] = V(6, 12, -2);
  shorter.corners[5] = V(6, -8, -2);
  shorter.corners[6] = V(6, 12, 8);
  shorter.corners[7] = V(6, -8, 8);
  const glm::dmat4 matrix = glm::perspectiveRH_NO(right_angle, 2.0, 1.0, 10.0) * view;
  expect_corners(frustum_of(matrix, {.far_limit = 5}), shorter, 1e-13);
  expect_corners(frustum_of(matrix * 3.0, {.far_limit = 5}), shorter, 1e-13);  // the same camera
  expect_corners(frustum_of(matrix, {.far_limit = 11}), by_hand, 1e-13);
}

TEST(Frustum, WithoutAFarPlaneNeedsAFarLimit) {
  glm::dmat4 reversed(0.0);  // z = 1, the near plane; w is the depth
  reversed[0][0] = 0.5;
  reversed[1][1] = 1;
  reversed[3][2] = 1;
  reversed[2][3] = -1;
  const char* const message =
      "frustum_of: the projection has no far plane; say in far_limit how far off things are seen";
  for (const auto& [projection, depth] :
       {std::pair(glm::infinitePerspectiveRH(right_angle, 2.0, 1.0), ClipDepth::minus_one_to_one),
        std::pair(glm::tweakedInfinitePerspective(right_angle, 2.0, 1.0), ClipDepth::minus_one_to_one),
        std::pair(reversed, ClipDepth::one_to_zero)}) {
    const glm::dmat4 matrix = projection * view;
    EXPECT_EQ(message_of([&, depth = depth] { frustum_of(matrix, {depth}); }), message);
    expect_corners(frustum_of(matrix, {depth, 10}), by_hand, 1e-13);
    const glm::mat4 narrow(matrix);
    EXPECT_EQ(message_of([&, depth = depth] { frustum_of(narrow, {depth}); }), message);
    expect_corners(frustum_of(narrow, {depth, 10}), by_hand, 1e-4);
  }
}

TEST(Frustum, RefusesWhatIsNoCamera) {
  EXPECT_EQ(message_of([] { frustum_of(Mat<4, double>(0)); }),
            "frustum_of: the projection has no far plane; say in far_limit how far off things are seen");
  const char* const blind = "frustum_of: the matrix is not that of a camera: it sees nothing, or what is behind it";
  EXPECT_EQ(message_of([] { frustum_of(Mat<4, double>(0), {.far_limit = 1}); }),
            "frustum_of: the projection has no far plane; say in far_limit how far off things are seen");
  EXPECT_EQ(message_of([] { frustum_of(Mat<3, double>(0)); }), blind);
  EXPECT_EQ(message_of([] { frustum_of(Mat<3, double>(-1)); }), blind);
  EXPECT_EQ(message_of([] { frustum_of(Mat<4, double>(1), {.far_limit = 0}); }),
            "frustum_of: far_limit is not above zero");
  EXPECT_EQ(message_of([] { frustum_of(Mat<4, float>(1e-39F)); }), "no error");  // the same camera as 1
  EXPECT_EQ(message_of([] { frustum_of(Mat<4, float>(std::numeric_limits<float>::quiet_NaN())); }),
            "frustum_of: the matrix has a number that is not finite");
  Mat<3, float> far_away(1);
  far_away[0][0] = 1e-39F;
  EXPECT_EQ(message_of([&] { frustum_of(far_away); }),
            "frustum_of: a corner is too far away for numbers of its type; give a far_limit");
}

TEST(Frustum, InThePlaneIsWhatFillsTheScreen) {
  Mat<3, double> camera(1);  // twice as large, and (3, 4) in the middle
  camera[0][0] = camera[1][1] = 2;
  camera[2][0] = -6;
  camera[2][1] = -8;
  EXPECT_EQ(frustum_of(camera).corners,
            (Frustum<2, double>{{{{2.5, 3.5}, {3.5, 3.5}, {2.5, 4.5}, {3.5, 4.5}}}}.corners));
}

TEST(Frustum, NamesItsDefect) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (std::size_t k = 0; k < 8; ++k) {
      Frustum<3, double> frustum;
      frustum.corners[k].y = bad;
      EXPECT_EQ(defect(frustum), "has a corner that is not finite");
    }
  }
  EXPECT_EQ(defect(Frustum<3, double>{}), "");
  EXPECT_TRUE(is_valid(Frustum<2>{{{{1, 1}, {1, 1}, {1, 1}, {1, 1}}}}));
}

TEST(Frustum, MovesItsCorners) {
  const Frustum<2, double> moved = transformed(Frustum<2, double>{}, {rotation_matrix(90), {10, 0}});
  EXPECT_EQ(moved.corners, (Frustum<2, double>{{{{11, -1}, {11, 1}, {9, -1}, {9, 1}}}}.corners));
}

/// Checks the farthest corner in every direction.
template <Dim N, class T>
void check_support() {
  const test::Source<N, T> from = test::draw_source<N, T>();
  const Frustum<N, T> frustum = test::any_odd_frustum<N, T>(from);
  const Vec<N, double> direction = wide<N, T>(*from.direction);
  RC_LOG() << test::to_source(frustum) << "\n";
  const Vec<N, double> found = support(frustum, direction);
  RC_ASSERT(std::count(frustum.corners.begin(), frustum.corners.end(), Vec<N, T>(found)) > 0);
  for (const Vec<N, T>& corner : frustum.corners)
    RC_ASSERT(dot(wide<N, T>(corner), direction) <= dot(found, direction));
}

RC_GTEST_PROP(Frustum, IsSupportedByItsFarthestCorner2f, ()) { check_support<2, float>(); }
RC_GTEST_PROP(Frustum, IsSupportedByItsFarthestCorner3d, ()) { check_support<3, double>(); }

// Whether a point is visible depends only on its clip coordinates.
RC_GTEST_PROP(Frustum, HoldsWhatTheMatrixPutsOnTheScreen, ()) {
  const auto coordinate = [] { return *rc::gen::inRange(-1000, 1000) / 100.0; };
  const glm::dvec3 eye(coordinate(), coordinate(), coordinate());
  const glm::dvec3 towards(coordinate(), coordinate(), coordinate());
  RC_PRE(glm::length(towards) > 0.1 && std::hypot(towards.x, towards.y) > 0.1);
  const glm::dmat4 matrix = glm::perspectiveRH_ZO(*rc::gen::element(0.5, 1.0, 2.0), 1.5, 0.5, 20.0) *
                            glm::lookAtRH(eye, eye + towards, glm::dvec3(0, 0, 1));
  const Frustum<3, double> frustum = frustum_of(matrix, {ClipDepth::zero_to_one});
  // Half of the points are near the corners, so that many are visible.
  V point(coordinate(), coordinate(), coordinate());
  if (*rc::gen::arbitrary<bool>()) {
    const auto& corners = frustum.corners;
    const double share = *rc::gen::inRange(0, 100) / 99.0;
    point = corners[*rc::gen::inRange<std::size_t>(0, 8)] * share +
            corners[*rc::gen::inRange<std::size_t>(0, 8)] * (1 - share);
    point += V(coordinate(), coordinate(), coordinate()) * 0.1;
  }
  const glm::dvec4 clip = matrix * glm::dvec4(point, 1);
  const double margin = std::min({clip.w - std::fabs(clip.x), clip.w - std::fabs(clip.y), clip.z, clip.w - clip.z});
  RC_LOG() << test::to_source(frustum) << " " << test::to_source(point) << "\n";
  RC_CLASSIFY(margin > 0, "seen");
  if (margin > 1e-9) RC_ASSERT(contains(frustum, point));
  if (margin < -1e-9) RC_ASSERT(!contains(frustum, point));
}

}  // namespace
}  // namespace graze::frustum_test
