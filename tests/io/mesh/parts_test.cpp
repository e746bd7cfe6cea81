// SPDX-License-Identifier: MIT
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/mesh/parts.hpp>

#include "io/mesh_text.hpp"

namespace graze::io::mesh_parts_test {
namespace {

const MeshPoints points = {{0, 0, 0}, {1, 0, 0}, {2, 2, 0}, {0, 1, 0}, {9, 9, 9}};

TEST(MeshParts, PolygonsOfEachPartAreCut) {
  MeshPolygons polygons;
  for (const std::uint32_t corner : {0U, 1U, 2U, 3U}) polygons.add_corner(corner);
  EXPECT_EQ(polygons.open_corners(), 4U);
  polygons.end_polygon(1, 10);
  for (const std::uint32_t corner : {0U, 1U, 3U}) polygons.add_corner(corner);
  polygons.end_polygon(0, 20);
  const auto faces = polygons.triangles(points, 2);
  EXPECT_EQ(faces[0], (MeshFaces{{0, 1, 3}}));
  EXPECT_EQ(faces[1], (MeshFaces{{0, 1, 2}, {0, 2, 3}}));
  std::vector<std::pair<std::uint32_t, std::size_t>> visited;
  polygons.for_each_corner([&](std::uint32_t corner, std::size_t offset) { visited.emplace_back(corner, offset); });
  EXPECT_EQ(visited.size(), 7U);
  EXPECT_EQ(visited.back(), (std::pair<std::uint32_t, std::size_t>(3, 20)));
}

TEST(MeshParts, OnlyUsedVerticesAreKeptInTheirOrder) {
  std::vector<std::uint32_t> place(points.size(), 0);
  const Mesh<3, double> mesh = mesh_of_used(points, {{3, 1, 4}, {1, 3, 3}}, place);
  EXPECT_EQ(points_of(mesh), (MeshPoints{{1, 0, 0}, {0, 1, 0}, {9, 9, 9}}));
  EXPECT_EQ(faces_of(mesh), (MeshFaces{{1, 0, 2}, {0, 1, 1}}));
  EXPECT_EQ(place, std::vector<std::uint32_t>(points.size(), 0));
}

TEST(MeshParts, OmissionsAreCountedByName) {
  std::vector<Omission> omissions;
  count_omission(omissions, "line", Loss::shape, "line 1");
  count_omission(omissions, "skin", Loss::precision);
  count_omission(omissions, "line", Loss::shape, "line 2");
  ASSERT_EQ(omissions.size(), 2U);
  EXPECT_EQ(omission_text(omissions[0]), "2 x line (line 1)");
}

TEST(MeshParts, PointsOfNoFaceAreNotedIfThereAreNoFaces) {
  MeshFile file{{}, "a.ply", "ply"};
  note_points(file, 5, 1);
  note_points(file, 0, 0);
  EXPECT_TRUE(file.omissions.empty());
  note_points(file, 5, 0);
  EXPECT_EQ(file.omissions.at(0).count, 5U);
}

}  // namespace
}  // namespace graze::io::mesh_parts_test
