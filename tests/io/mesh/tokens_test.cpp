// SPDX-License-Identifier: MIT
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/mesh/tokens.hpp>

#include "io/scene_text.hpp"

namespace graze::io::mesh_tokens_test {
namespace {

/// The words, with a bar at the end of each line.
std::string words(const std::string& text, MeshSyntax syntax) {
  const std::string source = "a.obj";
  MeshTokens tokens(text, source, syntax);
  std::string result;
  do {
    for (MeshToken token = tokens.next_in_line(); !token.text.empty(); token = tokens.next_in_line()) {
      result += std::string(token.text) + ' ';
    }
    result += '|';
  } while (tokens.next_line());
  return result;
}

TEST(MeshTokens, LinesEndWithAnyLineBreak) {
  EXPECT_EQ(words("a\tb\nc\r\n\n d \re", MeshSyntax::plain), "a b |c ||d |e |");
  EXPECT_EQ(words("", MeshSyntax::plain), "|");
}

TEST(MeshTokens, CommentsAndContinuedLinesBelongToSomeFormats) {
  EXPECT_EQ(words("a # b\nc#d", MeshSyntax::plain), "a # b |c#d |");
  EXPECT_EQ(words("a # b\nc#d", MeshSyntax::comments), "a |c#d |");
  EXPECT_EQ(words("f 1 \\\n 2\\\n3", MeshSyntax::comments), "f 1 \\ |2\\ |3 |");
  EXPECT_EQ(words("f 1 \\\n 2 \\\r\n3\ng", MeshSyntax::obj), "f 1 2 3 |g |");
  EXPECT_EQ(words("f 1 2\\\n3\\\r\n4\\5\\", MeshSyntax::obj), "f 1 2 3 4\\5\\ |");
  EXPECT_EQ(words("# C:\\\nv 1", MeshSyntax::obj), "|v 1 |");
}

TEST(MeshTokens, SkippingAContinuedLineSkipsItsContinuation) {
  const std::string source = "a.obj";
  MeshTokens tokens("vn 1 \\\n 2 3\nv", source, MeshSyntax::obj);
  EXPECT_EQ(tokens.next_in_line().text, "vn");
  EXPECT_TRUE(tokens.next_line());
  EXPECT_EQ(tokens.next_in_line().text, "v");
}

TEST(MeshTokens, TheRestOfALineHasNoBlanksAroundIt) {
  const std::string source = "a.stl";
  MeshTokens tokens("solid  a part \t\r\nnext", source, MeshSyntax::plain);
  tokens.next();
  EXPECT_EQ(tokens.rest_of_line(), "a part");
  EXPECT_EQ(tokens.next().text, "next");
  EXPECT_EQ(tokens.next().text, "");
}

TEST(MeshTokens, TheRestOfALineMayLookLikeACommentOrAContinuedLine) {
  const std::string source = "a.obj";
  MeshTokens tokens("o \\\no #3 \ng", source, MeshSyntax::obj);
  tokens.next_in_line();
  EXPECT_EQ(tokens.rest_of_line(), "\\");
  EXPECT_TRUE(tokens.next_line());
  tokens.next_in_line();
  EXPECT_EQ(tokens.rest_of_line(), "#3");
  EXPECT_TRUE(tokens.next_line());
  EXPECT_EQ(tokens.next_in_line().text, "g");
}

TEST(MeshTokens, FaultyNumbersAreNamedWithTheirPlace) {
  const std::string source = "a.obj";
  const std::string text = "v\n 1,5 x 7 99999999999999999999 -3";
  MeshTokens tokens(text, source, MeshSyntax::plain);
  tokens.next();
  const MeshToken comma = tokens.next();
  EXPECT_EQ(error_of([&] { tokens.number(comma, "x"); }),
            "a.obj: line 2, column 2: x is \"1,5\", which is not a number; write decimals with a point");
  const MeshToken letter = tokens.next();
  EXPECT_EQ(error_of([&] { tokens.whole(letter, "an index"); }),
            "a.obj: line 2, column 6: an index is \"x\", which is not a whole number");
  EXPECT_EQ(tokens.number(tokens.next(), "x"), 7);
  const MeshToken large = tokens.next();
  EXPECT_EQ(error_of([&] { tokens.whole(large, "an index"); }),
            "a.obj: line 2, column 10: an index is \"99999999999999999999\", which is not a whole number below 2^63");
  EXPECT_EQ(tokens.whole(tokens.next(), "an index"), -3);
  const MeshToken none = tokens.next();
  EXPECT_EQ(error_of([&] { tokens.number(none, "y"); }),
            "a.obj: line 2, column 33: y is missing; a number must follow here");
}

}  // namespace
}  // namespace graze::io::mesh_tokens_test
