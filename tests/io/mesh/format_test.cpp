// SPDX-License-Identifier: MIT
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/mesh/bytes.hpp>
#include <graze/io/mesh/format.hpp>

namespace graze::io::mesh_format_test {
namespace {

/// A binary STL with one triangle, whose header is `header`.
std::string binary_stl(std::string header) {
  header.resize(80, '\0');
  append_number(header, std::uint32_t{1});
  for (const float number : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) append_number(header, number);
  append_number(header, std::uint16_t{0});
  return header;
}

TEST(MeshFormat, IsToldByContent) {
  const std::vector<std::pair<std::string, MeshFormat>> table = {
      {"glTF\2", MeshFormat::glb},
      {std::string("glTF\1\0\0\0", 8), MeshFormat::glb},
      {"ply\nformat", MeshFormat::ply},
      {"ply\r\nformat", MeshFormat::ply},
      {"OFF\n3 1 0\n", MeshFormat::off},
      {"# a comment\n\nOFF\n3 1 0\n", MeshFormat::off},
      {"STCN4nOFF 3", MeshFormat::off},
      {"COFF", MeshFormat::off},
      {"solid a\nfacet normal 0 0 1\n", MeshFormat::stl_text},
      {" \nsolid\nendsolid\n", MeshFormat::stl_text},
      {"\xEF\xBB\xBFsolid a\nendsolid a", MeshFormat::stl_text},
      {"v 0 0 0\n", MeshFormat::obj},
      {"v\t-.5 0 0\n", MeshFormat::obj},
      {"# Blender\r\n#\r\nmtllib a.mtl\r\n", MeshFormat::obj},
      {"o Cube\n", MeshFormat::obj},
      {"g\nv 1 2 3", MeshFormat::obj}};
  for (const auto& [bytes, format] : table) EXPECT_EQ(mesh_format_of(bytes), format) << bytes;
}

TEST(MeshFormat, BinaryStlIsRecognisedWhateverItsHeaderSays) {
  for (const std::string header :
       {"", "solid", "solid facet normal", "ply\n", "OFF", "v 0 0 0", "glTF", "glTF part", "{\"a\": 1}"}) {
    EXPECT_EQ(mesh_format_of(binary_stl(header)), MeshFormat::stl_binary) << header;
  }
  const std::string whole = binary_stl("made by hand");
  EXPECT_EQ(mesh_format_of(whole + "more"), MeshFormat::stl_binary);
  std::string empty = whole.substr(0, 84);
  empty[80] = 0;
  EXPECT_EQ(mesh_format_of(empty), MeshFormat::stl_binary);
  std::string cut_off = whole;
  cut_off[80] = 9;
  EXPECT_EQ(mesh_format_of(cut_off), MeshFormat::stl_binary);
}

TEST(MeshFormat, WhatIsNoMeshHasNone) {
  for (const std::string bytes : {"", " ", "{\"asset\": {}}", "x,y,radius\n0,0,1\n", "<map/>", "solid,x,y\n",
                                  "solid state of matter", "OFFSET 1", "v x y\n", "vertex 1 2 3", "plywood", "o",
                                  "hello world", "# only a comment", "f(x) = 1", "\xff\xfe{", "of 1"}) {
    EXPECT_EQ(mesh_format_of(bytes), std::nullopt) << bytes;
  }
}

}  // namespace
}  // namespace graze::io::mesh_format_test
