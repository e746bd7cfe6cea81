// SPDX-License-Identifier: MIT
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/mesh/bytes.hpp>
#include <graze/io/stl/reader.hpp>

#include "io/mesh_text.hpp"
#include "io/scene_text.hpp"

namespace graze::io::stl_reader_test {
namespace {

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return " facet normal 0 0 1\n  outer loop\n   vertex " + a + "\n   vertex " + b + "\n   vertex " + c +
         "\n  endloop\n endfacet\n";
}

/// A header and triangles of nine coordinates each, all of which are `number`, 0 or 1.
std::string binary(const std::string& header, std::uint32_t promised, std::uint32_t triangles, float number = 2) {
  std::string bytes = header;
  bytes.resize(80, '\0');
  append_number(bytes, promised);
  for (std::uint32_t i = 0; i < triangles; ++i) {
    for (const float value : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, number, 0.F, 0.F, 0.F, 1.F, 0.F})
      append_number(bytes, value);
    append_number(bytes, std::uint16_t{7});
  }
  return bytes;
}

std::string refusal(const std::string& text) {
  return error_of([&text] { read_stl_text(text, "a.stl"); });
}

TEST(StlReader, TextIsReadInAnyCaseAndLayoutAndEqualCornersAreWelded) {
  const std::string text = "solid a part\r\n" + facet("0 0 0", "1 0 0", "0 1 0") +
                           "FACET Normal nan 0 0 outer LOOP vertex " +
                           "1 0 0 vertex 1 1 0 vertex 0 1.0e0 0 endloop endfacet\nendsolid a part\n";
  const MeshFile file = read_stl_text(text, "a.stl");
  EXPECT_EQ(file.format, "stl");
  EXPECT_EQ(file.up, UpAxis::unknown);
  ASSERT_EQ(file.parts.size(), 1U);
  EXPECT_EQ(file.parts[0].name, "a part");
  EXPECT_EQ(file.parts[0].mesh.kind(), MeshKind::surface);
  EXPECT_EQ(points_of(file.parts[0].mesh), (MeshPoints{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(faces_of(file.parts[0].mesh), (MeshFaces{{0, 1, 2}, {1, 3, 2}}));
}

TEST(StlReader, EachSolidIsAPart) {
  const std::string one = facet("0 0 0", "1 0 0", "0 1 0");
  const MeshFile file =
      read_stl_text("solid\n" + one + "endsolid\nsolid b\nendsolid b\nsolid c\n" + one + "endsolid", "");
  ASSERT_EQ(file.parts.size(), 3U);
  EXPECT_EQ(file.parts[0].name, "");
  EXPECT_TRUE(file.parts[1].mesh.faces().empty());
  EXPECT_EQ(file.parts[2].name, "c");
}

TEST(StlReader, FaultyTextIsRefusedWithItsPlace) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0\n vertex",
       "line 5, column 2: z is \"vertex\", which is not a number"},
      {"solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 inf",
       "line 4, column 15: z is \"inf\"; it must be a finite number"},
      {"solid a\n facets", "line 2, column 2: \"facets\" stands where \"facet\" or \"endsolid\" must follow"},
      {"solid a\n", "line 1, column 8: the file ends here, where \"facet\" must follow; is it cut off?"},
      {"solid a\n facet normal 0 0 1 outer loop vertex 1 2 3 endloop",
       "line 2, column 45: \"endloop\" stands where \"vertex\" must follow"},
      {"solid a\nendsolid a\nrest", "line 3, column 1: \"rest\" stands where \"solid\" must follow"}};
  for (const auto& [text, expected] : table) EXPECT_EQ(refusal(text), "a.stl: " + expected);
}

TEST(StlReader, BinaryFilesAreReadWithTheirName) {
  const MeshFile file = read_stl_binary(binary("solid by accident ", 2, 2), "a.stl");
  ASSERT_EQ(file.parts.size(), 1U);
  EXPECT_EQ(file.parts[0].name, "solid by accident");
  EXPECT_EQ(points_of(file.parts[0].mesh), (MeshPoints{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(faces_of(file.parts[0].mesh), (MeshFaces{{0, 1, 2}, {0, 1, 2}}));
  EXPECT_TRUE(file.warnings.empty());
  EXPECT_EQ(read_stl_binary(binary("\x01\x02", 0, 0), "a.stl").parts[0].name, "");
}

TEST(StlReader, BinaryFilesOfAnotherLengthAreRefusedOrWarnedOf) {
  EXPECT_EQ(
      error_of([] { read_stl_binary(binary("", 4294967295U, 1), "a.stl"); }),
      "a.stl: byte 80: the header promises 4294967295 triangles, for which the file needs 214748364834 bytes, but "
      "it has 134; is it cut off?");
  const MeshFile longer = read_stl_binary(binary("", 1, 2), "a.stl");
  EXPECT_EQ(longer.parts[0].mesh.faces().size(), 1U);
  EXPECT_EQ(longer.warnings,
            (std::vector<std::string>{
                "a.stl: 50 bytes follow the 1 triangles that the header promises; they were not read"}));
}

TEST(StlReader, BinaryCoordinatesAreFinite) {
  EXPECT_EQ(error_of([] { read_stl_binary(binary("", 2, 2, std::numeric_limits<float>::infinity()), "a.stl"); }),
            "a.stl: byte 108: triangle 0: x of corner 1 is inf; it must be a finite number");
}

}  // namespace
}  // namespace graze::io::stl_reader_test
