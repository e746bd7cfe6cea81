// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/mesh/bytes.hpp>
#include <graze/io/ply/header.hpp>
#include <graze/io/ply/reader.hpp>

#include "io/mesh_text.hpp"
#include "io/scene_text.hpp"

namespace graze::io::ply_reader_test {
namespace {

std::string head(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\ncomment hello\n" + elements + "end_header\n";
}

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string list = "property list uchar int vertex_indices\n";

std::string refusal(const std::string& bytes) {
  return error_of([&bytes] { read_ply(bytes, "a.ply"); });
}

template <class Number>
void append(std::string& out, Number number, bool is_big) {
  std::string bytes;
  append_number(bytes, number);
  if (is_big) std::reverse(bytes.begin(), bytes.end());
  out += bytes;
}

TEST(PlyReader, TextIsReadWithOtherProperties) {
  const std::string text =
      head("ascii", "obj_info x\nelement vertex 4\nproperty uchar red\nproperty list uchar int tags\n" + xyz +
                        "element edge 1\nproperty int a\nelement face 1\nproperty float area\n" + list) +
      "255 0 0 0 0\n7 2 1 1 1 0 0\n7 0 1 1 0\n7 0 0 1 0\n5\n0.5 4 0 1 2 3";
  const MeshFile file = read_ply(text, "a.ply");
  ASSERT_EQ(file.parts.size(), 1U);
  EXPECT_EQ(points_of(file.parts[0].mesh), (MeshPoints{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(faces_of(file.parts[0].mesh), (MeshFaces{{0, 1, 2}, {0, 2, 3}}));
  ASSERT_EQ(file.omissions.size(), 1U);
  EXPECT_EQ(omission_text(file.omissions[0]), "1 x element \"edge\"");
}

TEST(PlyReader, BothByteOrdersAndAllLineEndsAreRead) {
  for (const bool is_big : {false, true}) {
    for (const std::string line_end : {"\n", "\r\n", "\r"}) {
      std::string bytes;
      for (const char letter :
           head(is_big ? "binary_big_endian" : "binary_little_endian",
                "element face 1\nproperty list ushort uint vertex_index\nelement vertex 3\n"
                "property double x\nproperty short y\nproperty uchar skipped\nproperty float z\n")) {
        bytes += letter == '\n' ? line_end : std::string(1, letter);
      }
      append(bytes, std::uint16_t{3}, is_big);
      for (const std::uint32_t vertex : {2U, 1U, 0U}) append(bytes, vertex, is_big);
      for (int i = 0; i < 3; ++i) {
        append(bytes, 0.1 * i, is_big);
        append(bytes, static_cast<std::uint16_t>(-i), is_big);
        bytes += '\n';
        append(bytes, static_cast<float>(i), is_big);
      }
      const MeshFile file = read_ply(bytes, "a.ply");
      EXPECT_EQ(points_of(file.parts[0].mesh), (MeshPoints{{0, 0, 0}, {0.1, -1, 1}, {0.2, -2, 2}}));
      EXPECT_EQ(faces_of(file.parts[0].mesh), (MeshFaces{{2, 1, 0}}));
    }
  }
}

TEST(PlyReader, StripsAreTrianglesWithOneSideUp) {
  const std::string text = head("ascii", "element vertex 5\n" + xyz + "element tristrips 1\n" + list) +
                           "0 0 0 1 0 0 0 1 0 1 1 0 0 2 0\n9 0 1 2 3 4 -1 0 1 2";
  EXPECT_EQ(faces_of(read_ply(text, "a.ply").parts[0].mesh), (MeshFaces{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {0, 1, 2}}));
}

TEST(PlyReader, UnknownLinesOfTheHeaderAreWarnedOf) {
  const MeshFile file =
      read_ply("ply\nformat ascii 1.0\nCreated by me\nelement vertex 0\n" + xyz + "end_header", "a.ply");
  EXPECT_EQ(file.warnings,
            (std::vector<std::string>{
                "a.ply: line 3, column 1: the header has an unknown line \"Created\", which was skipped"}));
}

TEST(PlyReader, FaultyHeadersAreRefused) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"ply\nelement vertex 1\n", "line 3, column 1: the header ends without \"end_header\"; is the file cut off?"},
      {"ply\nend_header\n", "line 1, column 1: the header has no line \"format\""},
      {"ply\nformat text 1.0\n",
       "line 2, column 8: the format is \"text\"; it must be ascii, binary_little_endian or "
       "binary_big_endian"},
      {"ply\nelment vertex 1\n",
       "line 2, column 1: the header has an unknown line \"elment\"; did you mean \"element\"?"},
      {"ply\nproperty int x\n", "line 2, column 1: a property stands before the first element"},
      {"ply\nelement vertex\n",
       "line 2, column 15: the number of elements is missing; a whole number must follow here"},
      {"ply\nelement vertex -1\n", "line 2, column 16: the number of elements is -1"},
      {"ply\nelement vertex 1\nproperty flaot x\n",
       "line 3, column 10: there is no type \"flaot\"; did you mean \"float\"?"},
      {"ply\nelement a 1\nproperty list float int x\n",
       "line 3, column 15: the length of a list must be a whole number, such as uchar"},
      {"ply\nelement a 1\nproperty int\n", "line 3, column 13: a property needs a type and a name"},
      {"ply\nelement\n", "line 2, column 8: an element needs a name and a number"}};
  for (const auto& [text, expected] : table) EXPECT_EQ(refusal(text), "a.ply: " + expected);
}

TEST(PlyReader, FaultyContentIsRefused) {
  const std::string one = "element vertex 1\n" + xyz;
  const std::vector<std::pair<std::string, std::string>> table = {
      {head("ascii", "element vertex 1\nproperty float x\n") + "1",
       "line 4, column 1: the vertices have no number \"y\"; they need x, y and z"},
      {head("ascii", "element vertex 4000000000\n" + xyz) + "1 2 3",
       "line 4, column 1: the header promises 4000000000 elements \"vertex\", which take at least 6 bytes each, but "
       "only 5 "
       "bytes follow; is the file cut off?"},
      {head("ascii", one) + "1 2 x", "line 9, column 5: z is \"x\", which is not a number"},
      {head("ascii", one + "element face 1\nproperty int a\n") + "1 2 3 4",
       "line 8, column 1: the elements \"face\" have no list \"vertex_indices\" (or \"vertex_index\")"},
      {head("ascii", one + "element face 1\n" + list) + "1 2 3 3 0 0 1",
       "line 11, column 7: a face has vertex 1, but there are 1 vertices, numbered from 0"},
      {head("ascii", one + "element face 1\n" + list) + "1 2 3 3 0 0 -1",
       "line 11, column 13: a face has vertex -1, but there are 1 vertices, numbered from 0"},
      {head("ascii", one + "element face 1\n" + list) + "1 2 3 200 0 0",
       "line 11, column 7: a list has 200 elements, but only 4 bytes follow"},
      {head("ascii", one + one) + "1 2 3 1 2 3", "line 8, column 1: the vertices are listed twice"}};
  for (const auto& [text, expected] : table) EXPECT_EQ(refusal(text), "a.ply: " + expected);
}

TEST(PlyReader, FaultyBytesAreRefusedWithTheirPlace) {
  const std::string one = head("binary_little_endian", "element vertex 1\n" + xyz + "element face 1\n" + list);
  EXPECT_EQ(refusal(one + std::string(8, '\0') + std::string("\x00\x00\xc0\x7f\x00", 5)),
            "a.ply: byte " + std::to_string(one.size() + 8) + ": z is nan; it must be a finite number");
  EXPECT_EQ(refusal(one + std::string(12, '\0') + "\xff"),
            "a.ply: byte " + std::to_string(one.size() + 12) + ": a list has 255 elements, but only 0 bytes follow");
}

}  // namespace
}  // namespace graze::io::ply_reader_test
