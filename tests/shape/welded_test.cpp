// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <graze/shape/mesh_report.hpp>
#include <graze/shape/welded.hpp>

#include "meshes.hpp"

namespace graze::welded_test {
namespace {

using Faces = std::vector<std::array<std::uint32_t, 3>>;

TEST(Welded, VerticesAtOnePlaceBecomeOne) {
  const Mesh<3, float> box = test::box_mesh(Aabb<3, float>{});
  std::vector<Vec<3, float>> corners = {{5, 5, 5}};  // of no face
  Faces faces;
  for (std::size_t face = 0; face < box.faces().size(); ++face) {
    const auto first = static_cast<std::uint32_t>(corners.size());
    for (const Vec<3, float>& corner : box.triangle(face).vertices()) corners.push_back(corner);
    faces.push_back({first, first + 1, first + 2});
  }
  const Mesh<3, float> soup = mesh_of<3, float>(corners, faces, MeshKind::solid);
  EXPECT_EQ(report(soup).open_edges, 36U);
  const Mesh<3, float> joined = welded(soup);
  EXPECT_EQ(joined.vertices().size(), 8U);
  EXPECT_EQ(joined.kind(), MeshKind::solid);
  EXPECT_TRUE(report(joined).is_closed);
  EXPECT_EQ(report(joined).unused_vertices, 0U);
  for (std::size_t face = 0; face < faces.size(); ++face) {
    EXPECT_EQ(joined.triangle(face).vertices(), soup.triangle(face).vertices());
  }
}

TEST(Welded, KeepsTheOrderAndCountsZeroAsZero) {
  const std::array<Vec<2, double>, 4> vertices = {{{1, 0}, {0.0, -0.0}, {1, 1}, {-0.0, 0.0}}};
  const Mesh<2, double> joined = welded(mesh_of<2, double>(vertices, Faces{{0, 2, 3}, {1, 0, 2}}));
  ASSERT_EQ(joined.vertices().size(), 3U);
  EXPECT_EQ(joined.vertices()[0].x, 1);
  EXPECT_EQ(joined.vertices()[2].y, 1);
  EXPECT_EQ(joined.faces()[0], (std::array<std::uint32_t, 3>{0, 2, 1}));
  EXPECT_EQ(joined.faces()[1], (std::array<std::uint32_t, 3>{1, 0, 2}));
}

}  // namespace
}  // namespace graze::welded_test
