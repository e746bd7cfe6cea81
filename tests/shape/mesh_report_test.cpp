// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <graze/shape/mesh_report.hpp>

#include "meshes.hpp"

namespace graze::mesh_report_test {
namespace {

using Faces = std::vector<std::array<std::uint32_t, 3>>;

MeshReport report_of(const Faces& faces, std::size_t vertices = 6) {
  std::vector<Vec<3, double>> points;
  for (std::size_t i = 0; i < vertices; ++i) {
    const auto x = static_cast<double>(i);
    points.push_back({x, x * x, x * x * x});  // no four of them in a plane
  }
  return report(mesh_of<3, double>(points, faces));
}

TEST(MeshReport, OfAClosedMeshHasNothingToSay) {
  MeshReport whole;
  whole.components = 1;
  EXPECT_EQ(report(test::box_mesh(Aabb<3, float>{})), whole);
  EXPECT_EQ(report(test::ring_mesh<double>(9, 5)), whole);
  whole.components = 0;
  EXPECT_EQ(report(Mesh<3, float>()), whole);
}

TEST(MeshReport, CountsEachFault) {
  MeshReport expected;
  expected.open_edges = 3;
  expected.components = 1;
  expected.is_closed = false;
  EXPECT_EQ(report_of({{0, 1, 2}}, 3), expected);
  expected.unused_vertices = 3;
  EXPECT_EQ(report_of({{0, 1, 2}}), expected);
  expected.unused_vertices = 2;
  expected.open_edges = 4;
  EXPECT_EQ(report_of({{0, 1, 2}, {2, 1, 3}}), expected);
  expected.flipped_edges = 1;
  EXPECT_EQ(report_of({{0, 1, 2}, {1, 2, 3}}), expected);
  expected.flipped_edges = 0;
  expected.open_edges = 6;
  expected.non_manifold_edges = 1;
  expected.unused_vertices = 1;
  EXPECT_EQ(report_of({{0, 1, 2}, {2, 1, 3}, {1, 2, 4}}), expected);
  expected = {};
  expected.components = 2;
  expected.open_edges = 6;
  expected.is_closed = false;
  EXPECT_EQ(report_of({{0, 1, 2}, {3, 4, 5}}), expected);
}

TEST(MeshReport, CountsFacesWithoutAreaAndFacesThatComeTwice) {
  EXPECT_EQ(report_of({{0, 1, 1}}).degenerate_faces, 1U);
  EXPECT_EQ(report_of({{0, 1, 1}}).open_edges, 0U) << "both sides of the edge are used";
  EXPECT_TRUE(report_of({{0, 1, 1}}).is_closed);
  EXPECT_EQ(report_of({{2, 2, 2}}).degenerate_faces, 1U);
  const std::array<Vec<3, float>, 3> line = {{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}}};
  EXPECT_EQ((report(mesh_of<3, float>(line, Faces{{0, 1, 2}})).degenerate_faces), 1U);
  EXPECT_EQ(report_of({{0, 1, 2}, {2, 1, 0}, {1, 2, 0}, {1, 2, 3}}).duplicate_faces, 2U);
  EXPECT_TRUE(report_of({{0, 1, 2}, {2, 1, 0}}).is_closed);
}

}  // namespace
}  // namespace graze::mesh_report_test
