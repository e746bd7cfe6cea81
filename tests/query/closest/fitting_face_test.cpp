// SPDX-License-Identifier: MIT
// The fitting face contains the nearest point, even if distances cannot tell it.
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/closest/fitting_face.hpp>
#include <graze/query/convex/simplex.hpp>

namespace graze::detail::fitting_face_test {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;

template <Dim N>
FittingFace<N> fitting(const std::vector<Vec<N, double>>& points) {
  Simplex<N> simplex;
  for (const Vec<N, double>& point : points) simplex.push(point);
  return FittingFaceSearch<N>(simplex).run();
}

template <Dim N>
struct Row {
  std::vector<Vec<N, double>> points;
  Vec<N, double> nearest;
  std::size_t face;  ///< The number of corners of the face that contains it.
};

template <Dim N>
void expect_rows(const std::vector<Row<N>>& rows) {
  for (const Row<N>& row : rows) {
    const FittingFace<N> found = fitting<N>(row.points);
    EXPECT_LE(max_abs(found.nearest.point - row.nearest), 1e-15);
    EXPECT_LE(max_abs(found.toward - row.nearest), 1e-15);
    EXPECT_EQ(found.nearest.face.size, row.face);
    EXPECT_LE(found.misfit, 1e-15);
  }
}

TEST(FittingFace, In2DIsACornerOrAnEdge) {
  expect_rows<2>({{{{3, 4}}, {3, 4}, 1},
                  {{{1, -1}, {1, 5}}, {1, 0}, 2},
                  {{{1, 5}, {1, 1}}, {1, 1}, 1},
                  {{{4, -2}, {5, 5}, {-2, 4}}, {1, 1}, 2}});
}

TEST(FittingFace, In3DIsACornerAnEdgeOrATriangle) {
  expect_rows<3>({{{{1, 2, 2}}, {1, 2, 2}, 1},
                  {{{1, 1, -3}, {1, 1, 5}}, {1, 1, 0}, 2},
                  {{{-1, -1, 2}, {3, -1, 2}, {-1, 3, 2}}, {0, 0, 2}, 3},
                  {{{-1, -1, 3}, {-1, -1, 1}, {3, -1, 1}, {-1, 3, 1}}, {0, 0, 1}, 3},
                  {{{4, 1, 6}, {5, 1, 1}, {1, -1, 1}, {1, 3, 1}}, {1, 0, 1}, 2}});
}

TEST(FittingFace, OfPointsThatCoincideIsOneOfThem) {
  expect_rows<3>({{{{1, 2, 2}, {1, 2, 2}, {1, 2, 2}}, {1, 2, 2}, 1}});
}

// A square folded slightly along a diagonal, which passes the projection of the origin so closely that the triangles on
// both sides are equally far away, to the last bit.
TEST(FittingFace, OfASquareThatIsFoldedByLittleIsOnTheSideOfTheFoot) {
  for (const double height : {1.0, 1e-3, 1e-6}) {
    for (const double fold : {1e-6, 1e-8, 1e-10, 1e-12}) {
      const double aside = 1e-9 + height * fold / 2;  // the second is the horizontal offset of the projection
      const V3 shift(-aside, -aside, height);
      const V3 near_corner = V3(1, 1, fold) + shift;
      const FittingFace<3> found =
          fitting<3>({V3(-1, -1, fold) + shift, V3(1, -1, 0) + shift, V3(-1, 1, 0) + shift, near_corner});
      EXPECT_LE(found.misfit, 1e-15) << height << ", " << fold;
      ASSERT_EQ(found.nearest.face.size, 3U) << height << ", " << fold;
      EXPECT_EQ(found.nearest.face.points[2], near_corner);
      const double distance = (height + aside * fold) / std::sqrt(1 + fold * fold / 2);
      EXPECT_NEAR(std::sqrt(found.nearest.distance_squared), distance, 2e-15);
      EXPECT_NEAR(found.toward.x / found.toward.z, -fold / 2, 1e-15);
    }
  }
}

// A projection slightly outside does not increase the distance, but is outside.
TEST(FittingFace, SaysHowFarTheFootIsOutside) {
  const FittingFace<3> found = fitting<3>({{1e-9, -1, 1}, {1e-9, 1, 1}, {1, 0, 1}});
  EXPECT_EQ(found.nearest.face.size, 3U) << "the edge does not have the last corner";
  EXPECT_NEAR(found.misfit, 1e-9, 1e-15);
  EXPECT_EQ(found.nearest.point, V3(1e-9, 0, 1));
  EXPECT_EQ(found.nearest.distance_squared, 1);
}

/// Whatever fits exactly is what a search by distances finds.
TEST(FittingFace, IsTheNearestFaceOfRandomSimplices) {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto point = [&] { return V3(number(engine), number(engine), number(engine)); };
  std::size_t compared = 0;
  for (int i = 0; i < 10'000; ++i) {
    const V3 middle = point() * 2.0;
    std::vector<V3> corners;
    for (int k = 0; k < 4; ++k) corners.push_back(middle + point());
    Simplex<3> simplex;
    for (const V3& corner : corners) simplex.push(corner);
    const NearestOnSimplex<3> right = nearest_to_origin(simplex);
    const FittingFace<3> found = fitting<3>(corners);
    if (found.misfit > 1e-14) continue;  // the nearest face does not have the last corner
    ++compared;
    EXPECT_NEAR(std::sqrt(found.nearest.distance_squared), std::sqrt(right.distance_squared), 1e-14);
    EXPECT_EQ(found.nearest.face.size, right.face.size);
  }
  EXPECT_GT(compared, 4000U);
}

}  // namespace
}  // namespace graze::detail::fitting_face_test
