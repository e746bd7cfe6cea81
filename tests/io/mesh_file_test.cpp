// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/io/mesh_file.hpp>
#include <graze/io/output_error.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/welded.hpp>

#include "io/mesh_text.hpp"
#include "io/scene_text.hpp"
#include "io/tiled_folder.hpp"

namespace graze::io::mesh_file_test {
namespace {

constexpr std::array all_formats = {MeshOutput::stl, MeshOutput::obj, MeshOutput::ply, MeshOutput::off,
                                    MeshOutput::glb};

std::string written(MeshOutput format, const std::vector<MeshPart>& parts) {
  std::ostringstream out;
  write_meshes(out, format, parts);
  return out.str();
}

MeshFile read(const std::string& bytes) { return parse_meshes(bytes, "a file", "no folder"); }

/// The corners of all faces, in order.
MeshPoints corners_of(const std::vector<MeshPart>& parts) {
  MeshPoints corners;
  for (const MeshPart& part : parts) {
    for (std::size_t face = 0; face < part.mesh.faces().size(); ++face) {
      for (const Vec<3, double>& corner : part.mesh.triangle(face).vertices()) corners.push_back(corner);
    }
  }
  return corners;
}

const void* triangles_of(const MeshPart& part) { return detail::placed(part.mesh).data().get(); }

RC_GTEST_PROP(MeshFile, EveryFormatGivesBackTheFacesThatFitInFloats, ()) {
  const std::vector<MeshPart> parts = random_parts<float>(4);
  for (const MeshOutput format : all_formats) {
    RC_ASSERT(corners_of(read(written(format, parts)).parts) == corners_of(parts));
  }
}

RC_GTEST_PROP(MeshFile, TextAndPlyGiveBackDoublesBitForBit, ()) {
  const std::vector<MeshPart> parts = random_parts<double>(3);
  const MeshFile obj = read(written(MeshOutput::obj, parts));
  RC_ASSERT(obj.parts.size() == parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    RC_ASSERT(obj.parts[i].name == parts[i].name);
    RC_ASSERT(points_of(obj.parts[i].mesh) == points_of(parts[i].mesh));
    RC_ASSERT(faces_of(obj.parts[i].mesh) == faces_of(parts[i].mesh));
  }
  for (const MeshOutput format : {MeshOutput::ply, MeshOutput::off}) {
    RC_ASSERT(corners_of(read(written(format, parts)).parts) == corners_of(parts));
  }
}

TEST(MeshFile, GltfKeepsNamesPlacesAndSharedTriangles) {
  const Mesh<3, double> cube = cube_mesh();
  const auto pose = Pose<3, double>::from_axis_angle({1, 2, 3}, {1, 1, 0}, 0.3);
  const std::vector<MeshPart> parts = {{"a", cube}, {"", transformed(cube, pose)}, {"empty", {}}};
  const MeshFile file = read(written(MeshOutput::glb, parts));
  ASSERT_EQ(file.parts.size(), 2U);  // glTF has no meshes without faces
  EXPECT_EQ(file.parts[0].name, "a");
  EXPECT_EQ(triangles_of(file.parts[0]), triangles_of(file.parts[1]));
  EXPECT_EQ(corners_of(file.parts), corners_of(parts));
  EXPECT_TRUE(read(written(MeshOutput::glb, {})).parts.empty());
}

TEST(MeshFile, FilesWithoutMeshesAreReadAgain) {
  for (const MeshOutput format : all_formats) EXPECT_TRUE(corners_of(read(written(format, {})).parts).empty());
}

TEST(MeshFile, StlKeepsTheNameOfASinglePart) {
  EXPECT_EQ(read(written(MeshOutput::stl, {{"wheel", cube_mesh()}})).parts.at(0).name, "wheel");
  EXPECT_EQ(read(written(MeshOutput::stl, {{"solid", cube_mesh()}})).parts.at(0).name, "");
  EXPECT_EQ(read(written(MeshOutput::stl, {{std::string(90, 'x'), cube_mesh()}})).parts.at(0).name, "");
  EXPECT_EQ(read(written(MeshOutput::stl, {{"cube", cube_mesh()}})).parts.at(0).mesh.vertices().size(), 8U);
}

TEST(MeshFile, NamesThatMeanSomethingInAFormatChangeNothing) {
  for (const std::string name : {"\\", "glTF", "solid", "ply", "OFF", "#1", "o", "v 1 2 3", "\n", "{", " "}) {
    const std::vector<MeshPart> parts = {{name, cube_mesh()}};
    for (const MeshOutput format : all_formats) {
      EXPECT_EQ(corners_of(read(written(format, parts)).parts), corners_of(parts)) << name;
    }
  }
}

TEST(MeshFile, CoordinatesBeyondFloatsAreRefusedWhereTheFormatHoldsFloats) {
  const MeshPoints points = {{0, 0, 0}, {1e39, 0, 0}, {0, 1, 0}};
  const std::vector<MeshPart> parts = {{"a", mesh_of<3, double>(points, MeshFaces{{0, 1, 2}})}};
  for (const auto& [format, name] : {std::pair{MeshOutput::stl, "STL"}, std::pair{MeshOutput::glb, "glTF"}}) {
    try {
      written(format, parts);
      FAIL();
    } catch (const OutputError& error) {
      EXPECT_EQ(error.what(), std::string(name) + " holds floats, up to 3.4e38, but a coordinate is 1e+39");
    }
  }
  EXPECT_EQ(corners_of(read(written(MeshOutput::ply, parts)).parts), corners_of(parts));
}

TEST(MeshFile, WhatIsNoMeshIsRefused) {
  EXPECT_EQ(error_of([] { read("hello"); }),
            "a file: this is no mesh; graze reads meshes from STL, OBJ, PLY, OFF and glTF 2.0 (.gltf, .glb)");
  EXPECT_EQ(error_of([] { read("Kaydara FBX Binary"); }),
            "a file: this is a mesh in FBX; export it as glTF (.glb), STL, OBJ, PLY or OFF");
  EXPECT_EQ(error_of([] { read(" \n"); }), "a file: this is empty; a mesh needs at least its header");
  EXPECT_EQ(
      error_of([] { read("{}"); }),
      "a file: this is JSON, but not glTF; graze reads meshes from STL, OBJ, PLY, OFF and glTF 2.0 (.gltf, .glb)");
}

TEST(MeshFile, ClosedPartsBecomeSolidsWhereverTheyAre) {
  const Mesh<3, double> cube = cube_mesh();
  MeshPoints corners;  // unwelded, as in glTF
  MeshFaces faces;
  for (std::uint32_t face = 0; face < 12; ++face) {
    for (const Vec<3, double>& corner : cube.triangle(face).vertices()) corners.push_back(corner);
    faces.push_back({3 * face, 3 * face + 1, 3 * face + 2});
  }
  const Mesh<3, double> loose = mesh_of<3, double>(corners, faces);
  const Pose<3, double> away{Mat<3, double>(1.0), {10, 0, 0}};
  MeshFaces open(faces.begin() + 1, faces.end());
  MeshFaces inside_out = faces;
  for (auto& face : inside_out) std::swap(face[0], face[1]);
  MeshFile file{{{"loose", loose},
                 {"moved", transformed(loose, away)},
                 {"open", mesh_of<3, double>(corners, open)},
                 {"turned", mesh_of<3, double>(corners, inside_out)},
                 {"empty", {}},
                 {"open", mesh_of<3, double>(corners, open)}},
                "a.glb",
                "gltf"};
  make_closed_parts_solid(file);
  EXPECT_EQ(file.parts[0].mesh.kind(), MeshKind::solid);
  EXPECT_TRUE(contains(file.parts[0].mesh, Vec<3, double>(0.5, 0.4, 0.3)));
  EXPECT_TRUE(contains(file.parts[1].mesh, Vec<3, double>(10.5, 0.4, 0.3)));
  EXPECT_EQ(triangles_of(file.parts[0]), triangles_of(file.parts[1]));
  for (std::size_t i = 2; i < 6; ++i) EXPECT_EQ(file.parts[i].mesh.kind(), MeshKind::surface);
  EXPECT_EQ(file.warnings, (std::vector<std::string>{
                               "a.glb: the mesh \"open\" is not closed, so it stays a surface",
                               "a.glb: the mesh \"turned\" encloses no volume, or is inside out, so it stays a surface",
                               "a.glb: the mesh \"empty\" has no faces, so it stays a surface"}));
}

TEST(MeshFile, PartsAreScaledAndTurnedExactly) {
  const Mesh<3, double> cube = cube_mesh();
  MeshFile file{
      {{"a", cube}, {"b", transformed(cube, {Mat<3, double>(1.0), {1, 2, 3}})}}, "a.glb", "gltf", UpAxis::y, 1.0};
  scale_parts(file, 0.5);
  EXPECT_EQ(file.metres_per_unit, 2.0);
  EXPECT_EQ(file.parts[0].mesh.vertices()[6], (Vec<3, double>(0.5, 0.5, 0.5)));
  EXPECT_EQ(file.parts[1].mesh.vertices()[6], (Vec<3, double>(1, 1.5, 2)));
  turn_parts(file, MeshTurn::y_up_to_z_up);
  EXPECT_EQ(file.up, UpAxis::z);
  EXPECT_EQ(file.parts[1].mesh.vertices()[6], (Vec<3, double>(1, -2, 1.5)));
  EXPECT_EQ(triangles_of(file.parts[0]), triangles_of(file.parts[1]));
  turn_parts(file, MeshTurn::z_up_to_y_up);
  EXPECT_EQ(file.up, UpAxis::y);
  EXPECT_EQ(file.parts[1].mesh.vertices()[6], (Vec<3, double>(1, 1.5, 2)));
  for (const double factor : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_THROW(scale_parts(file, factor), std::invalid_argument) << factor;
  }
}

TEST(MeshFile, TheLinksOfTheRobotArmAreRead) {
  const std::filesystem::path folder = shared_file("ur5");
  if (!std::filesystem::exists(folder)) {
    GTEST_SKIP() << "there is no " << folder << "; set GRAZE_SHARED_DATA to the shared data folder";
  }
  std::size_t faces = 0;
  for (const std::string name : {"base", "forearm", "shoulder", "upperarm", "wrist1", "wrist2", "wrist3"}) {
    const MeshFile file = read_meshes(folder / (name + ".stl"));
    ASSERT_EQ(file.parts.size(), 1U) << name;
    EXPECT_TRUE(file.warnings.empty()) << name;
    faces += file.parts[0].mesh.faces().size();
    EXPECT_LT(file.parts[0].mesh.vertices().size(), file.parts[0].mesh.faces().size()) << name;  // welded
  }
  EXPECT_EQ(faces, 5328U);
}

}  // namespace
}  // namespace graze::io::mesh_file_test
