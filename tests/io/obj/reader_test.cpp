// SPDX-License-Identifier: MIT
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/obj/reader.hpp>

#include "io/mesh_text.hpp"
#include "io/scene_text.hpp"

namespace graze::io::obj_reader_test {
namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

MeshFile read(const std::string& text) { return read_obj(text, "a.obj"); }

std::string refusal(const std::string& text) {
  return error_of([&text] { read(text); });
}

TEST(ObjReader, IndicesCountFromOneOrBackFromTheLast) {
  for (const std::string face : {"f 1 2 3 4", "f 1/9 2/8 3/7 4", "f 1//1 2//1 3//1 4//1", "f 1/1/1 2/2/2 3/3/3 4/4/4",
                                 "f -4 -3 -2 -1", "f -4/1 2 -2//7 4", "f 1 2 \\\n3 4", "fo 1 2 3 4"}) {
    const MeshFile file = read(square + face);
    ASSERT_EQ(file.parts.size(), 1U) << face;
    EXPECT_EQ(points_of(file.parts[0].mesh), (MeshPoints{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(faces_of(file.parts[0].mesh), (MeshFaces{{0, 1, 2}, {0, 2, 3}})) << face;
    EXPECT_EQ(file.format, "obj");
  }
  EXPECT_EQ(read("f 1 2 3\n" + square).parts[0].mesh.faces().size(), 1U);  // vertices may follow
}

TEST(ObjReader, VerticesAreNotWeldedAndUnusedOnesAreDropped) {
  const MeshFile file = read("v 0 0 0 1.0\nv 9 9 9\nv 0 0 0 0.1 0.2 0.3\nv 1 0 0\nf 1 3 4");
  EXPECT_EQ(points_of(file.parts[0].mesh), (MeshPoints{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}));
}

TEST(ObjReader, ObjectsAreParts) {
  const MeshFile file = read(square + "o a b\nf 1 2 3\ng left\nf 2 3 4\no c\nusemtl x\no a b\nf 3 4 1\no d\nf 1 3 4");
  ASSERT_EQ(file.parts.size(), 3U);  // "c" has no faces
  EXPECT_EQ(file.parts[0].name, "a b");
  EXPECT_EQ(file.parts[0].mesh.faces().size(), 2U);
  EXPECT_EQ(file.parts[1].name, "a b");
  EXPECT_EQ(file.parts[2].name, "d");
  EXPECT_EQ(points_of(file.parts[2].mesh), (MeshPoints{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
}

TEST(ObjReader, GroupsArePartsOfFilesWithoutObjects) {
  const MeshFile file = read(square + "f 1 2 3\ng right\nf 2 3 4\ng\nf 1 2 4\ng right\nf 1 2 3\n");
  ASSERT_EQ(file.parts.size(), 2U);
  EXPECT_EQ(file.parts[0].name, "");
  EXPECT_EQ(file.parts[0].mesh.faces().size(), 2U);
  EXPECT_EQ(file.parts[1].name, "right");
}

TEST(ObjReader, NamesMayBeAnyText) {
  for (const std::string name : {"\\", "C:\\parts\\", "a \\", "#3", "o", "f 1 2 3"}) {
    for (const std::string keyword : {"o ", "g "}) {
      const MeshFile file = read(square + keyword + name + "\nf 1 2 3\n" + keyword + "next\nf 1 3 4\n");
      ASSERT_EQ(file.parts.size(), 2U) << name;
      EXPECT_EQ(file.parts[0].name, name);
      EXPECT_EQ(faces_of(file.parts[0].mesh), (MeshFaces{{0, 1, 2}})) << name;
    }
  }
  EXPECT_EQ(read(square + "o a\ng \\\nf 1 2 3").parts.at(0).name, "a");  // groups of objects do not matter
}

TEST(ObjReader, WhatHasNoFacesIsCounted) {
  const MeshFile file =
      read("# only lines\nmtllib a.mtl\n" + square + "vn 0 0 1\nl 1 2 3\nl 3 4\np 1\nsurf 0 1 0 1 1\ntwist 3\n");
  EXPECT_TRUE(file.parts.empty());
  ASSERT_EQ(file.omissions.size(), 4U);
  EXPECT_EQ(omission_text(file.omissions[0]), "2 x line (a.obj, line 8)");
  EXPECT_EQ(file.omissions[1].what, "points");
  EXPECT_EQ(file.omissions[2].what, "free-form surface");
  EXPECT_EQ(omission_text(file.omissions[3]), "1 x unknown statement \"twist\" (a.obj, line 12)");
  EXPECT_EQ(omission_text(read(square).omissions.at(0)), "4 x point of no face (a.obj: a mesh consists of its faces)");
}

TEST(ObjReader, FaultsAreRefusedWithTheirPlace) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"v 1 2\n", "line 1, column 6: z is missing; a number must follow here"},
      {"v 1 2 3.1+e2", "line 1, column 7: z is \"3.1+e2\", which is not a number"},
      {"v 1 2 nan", "line 1, column 7: z is \"nan\"; it must be a finite number"},
      {square + "f 1 2", "line 5, column 1: a face has 2 corners; it must have 3 to 10000"},
      {square + "f", "line 5, column 1: a face has 0 corners; it must have 3 to 10000"},
      {square + "f 1 2 0", "line 5, column 7: a face has vertex 0; vertices are numbered from 1"},
      {square + "f 1 2 5", "line 5, column 1: a face has vertex 5, but there are 4 vertices, numbered from 1"},
      {square + "f 1 2 -5", "line 5, column 7: a face has vertex -5, but there are 4 vertices before it"},
      {square + "f 1 2 99999999999",
       "line 5, column 7: a face has vertex 99999999999, but there are 4 vertices, numbered "
       "from 1"},
      {square + "f 1 2 x/1", "line 5, column 7: the index of a vertex is \"x\", which is not a whole number"},
      {square + "f 1 2 /1", "line 5, column 7: the index of a vertex is missing; a whole number must follow here"}};
  for (const auto& [text, expected] : table) EXPECT_EQ(refusal(text), "a.obj: " + expected);
}

}  // namespace
}  // namespace graze::io::obj_reader_test
