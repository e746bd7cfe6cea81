// SPDX-License-Identifier: MIT
#include <bit>
#include <cstddef>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/cores/surface_point_box.hpp>
#include <graze/query/fast_contact/obb/faces.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail::obb_faces_test {
namespace {

using V3 = Vec<3, double>;

const V3 up(0, 0, 1);

/// The upper side of a box, and the lower side of one above.
PairedBox paired(const V3& low, const V3& high) {
  const Obb<3, double> box = oriented(Aabb<3, double>{low, high});
  return paired_box(box, box.center);
}
BoxFace upper(const V3& low, const V3& high) { return face_of_box(paired(low, high), {2, true}); }
BoxFace lower(const V3& low, const V3& high) { return face_of_box(paired(low, high), {2, false}); }

const BoxFace table = upper({0, 0, -1}, {4, 4, 0});

Feature vertex(std::uint32_t index) { return {FeatureKind::vertex, index}; }
Feature edge(std::uint32_t index) { return {FeatureKind::edge, index}; }
Feature face(std::uint32_t index) { return {FeatureKind::face, index}; }

void expect_pair(const PairedPoints& pair, const V3& point, const Feature& reference, const Feature& incident) {
  EXPECT_EQ(plain(pair.point_b), point);
  EXPECT_EQ(pair.feature_a, reference);
  EXPECT_EQ(pair.feature_b, incident);
}

FaceOverFace on_table(const BoxFace& incident) {
  FaceOverFace over(incident, table, PairedVec(up), PairedVec(up), 1e-14, 0);
  EXPECT_TRUE(over.run());
  return over;
}

TEST(BoxFaceNumbers, AreThoseOfPatches) {
  for (const Dim axis : {0, 1, 2}) {
    for (const bool is_far : {false, true}) {
      const BoxFaceNumbers numbers{axis, is_far};
      const Patch<3> patch = patch_of_box(frame_of(Aabb<3, double>{{0, 0, 0}, {1, 1, 1}}), {axis, is_far, up});
      EXPECT_EQ(numbers.face(), patch.face);
      for (std::uint32_t i = 0; i < 4; ++i) {
        const V3 corner = patch.corners[i];
        EXPECT_EQ(numbers.vertex(i), static_cast<std::uint32_t>(corner.x + 2 * corner.y + 4 * corner.z));
        EXPECT_EQ(features_of_faces[numbers.face()][vertex_place + i], vertex(numbers.vertex(i)));
        EXPECT_EQ(features_of_faces[numbers.face()][edge_place + i], edge(numbers.edge(i)));
      }
    }
  }
}

TEST(FaceOverFace, ThatLiesOverTheOtherIsLeftWhole) {
  const FaceOverFace whole = on_table(lower({1, 1, -0.5}, {2, 2, 1}));
  ASSERT_EQ(whole.left(), 0b1111U);
  expect_pair(whole.pair(0), {1, 1, -0.5}, face(5), vertex(0));
  expect_pair(whole.pair(2), {2, 2, -0.5}, face(5), vertex(3));
  EXPECT_EQ(plain(whole.pair(2).point_a), V3(2, 2, 0));
  EXPECT_EQ(whole.depth(2), 0.5);
}

TEST(FaceOverFace, OverACornerNamesBothFeaturesOfEveryPoint) {
  const FaceOverFace cut = on_table(lower({3, 3, 0}, {5, 5, 1}));
  ASSERT_EQ(cut.left(), 0b110'1001U);
  expect_pair(cut.pair(0), {3, 3, 0}, face(5), vertex(0));
  expect_pair(cut.pair(5), {4, 3, 0}, edge(7), edge(0));
  expect_pair(cut.pair(6), {4, 4, 0}, vertex(7), face(4));
  expect_pair(cut.pair(3), {3, 4, 0}, edge(3), edge(4));
}

TEST(FaceOverFace, LargerThanTheOtherIsTheOther) {
  const FaceOverFace cut = on_table(lower({-9, -9, 0}, {9, 9, 1}));
  ASSERT_EQ(cut.left(), 0b1111'0000U);
  for (std::size_t i = 4; i < 8; ++i) {
    EXPECT_EQ(cut.pair(i).feature_b, face(4));
    EXPECT_EQ(cut.pair(i).feature_a.kind, FeatureKind::vertex);
  }
}

TEST(FaceOverFace, HasItsDeepestCornerBelowTheOther) {
  const Mat<3, double> tilt = rotation_matrix(V3(1, 1, 0), 10);  // down at +x, -y
  const Obb<3, double> box{{2, 2, 0.9}, {0.5, 0.5, 1}, tilt};
  FaceOverFace over(face_of_box(paired_box(box, box.center), {2, false}), table, PairedVec(up), PairedVec(up), 1e-14,
                    0);
  ASSERT_TRUE(over.run());
  for (unsigned rest = over.left(); rest != 0; rest &= rest - 1) {
    EXPECT_LE(over.depth(static_cast<std::size_t>(std::countr_zero(rest))), over.depth(over.deepest()));
  }
  EXPECT_GT(over.depth(over.deepest()), 0.1);
}

TEST(FaceOverFace, BesideOrAboveTheOtherIsNothing) {
  EXPECT_EQ(on_table(lower({5, 0, 0}, {6, 4, 1})).size(), 0U);
  EXPECT_EQ(on_table(lower({1, 1, 0.5}, {2, 2, 1})).size(), 0U);
}

TEST(FaceOverFace, IsNotKnownOfAFaceWithoutWidth) {
  FaceOverFace over(lower({1, 1, 0}, {2, 2, 1}), upper({0, 0, -1}, {4, 0, 0}), PairedVec(up), PairedVec(up), 1e-14, 0);
  EXPECT_FALSE(over.run());
}

}  // namespace
}  // namespace graze::detail::obb_faces_test

#endif
