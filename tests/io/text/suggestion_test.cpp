// SPDX-License-Identifier: MIT
#include <array>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <graze/io/text/suggestion.hpp>

namespace graze::io::suggestion_test {
namespace {

constexpr std::array<std::string_view, 3> names = {"center", "radius", "half_extents"};

TEST(Suggestion, EditDistancesCountEachKindOfSlipOnce) {
  EXPECT_EQ(edit_distance("radius", "radius", 9), 0U);
  EXPECT_EQ(edit_distance("raduis", "radius", 9), 1U);   // swapped
  EXPECT_EQ(edit_distance("radus", "radius", 9), 1U);    // missing
  EXPECT_EQ(edit_distance("radiuss", "radius", 9), 1U);  // one letter too many
  EXPECT_EQ(edit_distance("redius", "radius", 9), 1U);   // a wrong letter
  EXPECT_EQ(edit_distance("RADIUS", "radius", 9), 0U);
  EXPECT_EQ(edit_distance("kitten", "sitting", 9), 3U);
  EXPECT_EQ(edit_distance("", "abc", 9), 3U);
}

TEST(Suggestion, DistancesAboveTheLimitAreNotCalculatedExactly) {
  EXPECT_EQ(edit_distance("kitten", "sitting", 2), 3U);
  EXPECT_EQ(edit_distance(std::string(1000000, 'x'), "abc", 2), 3U);
}

TEST(Suggestion, TheNearestNameIsFoundIfItIsNearEnough) {
  EXPECT_EQ(nearest_name("raduis", names), "radius");
  EXPECT_EQ(nearest_name("centre", names), "center");
  EXPECT_EQ(nearest_name("halfExtents", names), "half_extents");
  EXPECT_EQ(nearest_name("colour", names), std::nullopt);
  EXPECT_EQ(nearest_name("", names), std::nullopt);
  EXPECT_EQ(nearest_name("x", std::array<std::string_view, 2>{"a", "b"}), std::nullopt);
}

TEST(Suggestion, AMessageNamesTheNearestOrAll) {
  EXPECT_EQ(did_you_mean("raduis", names), R"(; did you mean "radius"?)");
  EXPECT_EQ(did_you_mean("colour", names), R"(; known: "center", "radius", "half_extents")");
  EXPECT_EQ(did_you_mean("colour", {}), "");
}

}  // namespace
}  // namespace graze::io::suggestion_test
