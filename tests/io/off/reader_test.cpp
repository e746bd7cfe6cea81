// SPDX-License-Identifier: MIT
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/off/header.hpp>
#include <graze/io/off/reader.hpp>

#include "io/mesh_text.hpp"
#include "io/scene_text.hpp"

namespace graze::io::off_reader_test {
namespace {

std::string refusal(const std::string& text) {
  return error_of([&text] { read_off(text, "a.off"); });
}

TEST(OffReader, HeadersAreRecognised) {
  for (const std::string word : {"OFF", "COFF", "NOFF", "STOFF", "CNOFF", "STCNOFF"}) {
    ASSERT_TRUE(off_header_of(word + "\n1")) << word;
    EXPECT_EQ(off_header_of(word + " 1")->word, word);
    EXPECT_FALSE(off_header_of(word)->is_4d);
  }
  EXPECT_TRUE(off_header_of("4OFF")->is_4d);
  EXPECT_TRUE(off_header_of("nOFF")->is_4d);
  for (const std::string word : {"", "off", "OFFS", "XOFF", "NCOFF", "ST"}) EXPECT_FALSE(off_header_of(word)) << word;
}

TEST(OffReader, ColoursAndCommentsDoNotMatter) {
  const std::string vertices = "0 0 0 0.5 0.5\n1 0 0 # a corner\n1 1 0 255 0 0 255\n\n0 1 0\n";
  for (const std::string head : {"OFF\n4 2 0\n", "# made by hand\nCOFF # head\n4 2\n", "OFF 4 2 9\n"}) {
    const MeshFile file = read_off(head + vertices + "4 0 1 2 3 1 0 0\n3 0 1 3", "a.off");
    ASSERT_EQ(file.parts.size(), 1U);
    EXPECT_EQ(file.parts[0].name, "");
    EXPECT_EQ(points_of(file.parts[0].mesh), (MeshPoints{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(faces_of(file.parts[0].mesh), (MeshFaces{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}}));
  }
}

TEST(OffReader, FacesWithoutAnAreaAreCounted) {
  const MeshFile file = read_off("OFF\n2 2 0\n0 0 0\n1 0 0\n2 0 1\n1 0\n", "a.off");
  ASSERT_EQ(file.omissions.size(), 3U);
  EXPECT_EQ(file.omissions[0].what, "line");
  EXPECT_EQ(file.omissions[1].what, "point");
  EXPECT_EQ(file.omissions[2].what, "point of no face");
}

TEST(OffReader, FaultsAreRefusedWithTheirPlace) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"4OFF\n0 0 0\n",
       "line 1, column 1: the vertices of 4OFF do not have three coordinates; write OFF with x, y and z"},
      {"OFF BINARY\n", "line 1, column 5: binary OFF is not read; write it as text, or as binary PLY"},
      {"OFF\n", "line 1, column 4: the number of vertices is missing; a whole number must follow here"},
      {"OFF\n4000000000 1 0\n0 0 0\n",
       "line 2, column 1: the number of vertices is 4000000000, but only 11 bytes follow; is the file cut off?"},
      {"OFF\n-1 1 0\n",
       "line 2, column 1: the number of vertices is -1, but only 5 bytes follow; is the file cut off?"},
      {"OFF\n1 1 0\n0 0\n", "line 3, column 4: z is missing; a number must follow here"},
      {"OFF\n1 1 0\n0 0 0\n3 0 0 1",
       "line 4, column 7: face 0 has vertex 1, but there are 1 vertices, numbered from 0"},
      {"OFF\n1 1 0\n0 0 0\n3 0 0 -1",
       "line 4, column 7: face 0 has vertex -1, but there are 1 vertices, numbered from 0"},
      {"OFF\n1 1 0\n0 0 0\n3 0 0", "line 4, column 6: a vertex of a face is missing; a whole number must follow here"},
      {"OFF\n1 1 0\n0 0 0\n99999 0", "line 4, column 1: face 0 has 99999 corners; at most 10000 are allowed"}};
  for (const auto& [text, expected] : table) EXPECT_EQ(refusal(text), "a.off: " + expected);
}

}  // namespace
}  // namespace graze::io::off_reader_test
