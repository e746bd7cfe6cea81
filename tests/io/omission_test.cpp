// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <graze/io/omission.hpp>

namespace graze::io::omission_test {
namespace {

const Omission curve{"curve", 3, Loss::shape, "a.tmx, line 4", "graze has no curves"};
const Omission picture{"\"big\" picture", 2, Loss::none, "a.tmx, line 5", "a picture has no shape"};

TEST(Omission, as_text_says_where_and_why_a_shape_is_missing) {
  EXPECT_EQ(omission_text(curve), "3 x curve (a.tmx, line 4: graze has no curves)");
  EXPECT_EQ(omission_text({"curve", 1, Loss::shape, "line 4"}), "1 x curve (line 4)");
  EXPECT_EQ(omission_text({"curve", 1, Loss::shape, "", "graze has none"}), "1 x curve (graze has none)");
  EXPECT_EQ(omission_text({"curve", 1, Loss::shape}), "1 x curve");
  EXPECT_EQ(omission_text(picture), "2 x \"big\" picture");
  EXPECT_EQ(omission_text({"ellipse", 2, Loss::precision, "line 4"}), "2 x ellipse");
}

TEST(Omission, as_json_has_every_field) {
  const std::vector<Omission> omissions{curve, {"ellipse", 1, Loss::precision}, {"\"x\"", 2}};
  const std::string text = omissions_json(omissions);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(text), nlohmann::json::parse(R"([
    {"what": "curve", "count": 3, "loss": "shape", "where": "a.tmx, line 4", "why": "graze has no curves"},
    {"what": "ellipse", "count": 1, "loss": "precision", "where": "", "why": ""},
    {"what": "\"x\"", "count": 2, "loss": "none", "where": "", "why": ""}])"));
  EXPECT_EQ(omissions_json({}), "[]");
}

TEST(Omission, counts_among_missing_shapes_by_its_loss) {
  const std::vector<Omission> missing =
      missing_shapes(std::vector<Omission>{picture, curve, {"e", 1, Loss::precision}});
  ASSERT_EQ(missing.size(), 1U);
  EXPECT_EQ(missing.front().what, "curve");
}

TEST(Omission, is_a_line_or_a_row_that_is_told_from_others) {
  EXPECT_EQ(nlohmann::json::parse(omission_ndjson(picture))["not_read"]["count"], 2);
  EXPECT_EQ(omission_csv(picture, "a,b,relation", "relation"), "\"2 x \"\"big\"\" picture\",,not_read\n");
  EXPECT_EQ(omission_csv(picture, "name,type,t", "type"), "\"2 x \"\"big\"\" picture\",not_read,\n");
}

}  // namespace
}  // namespace graze::io::omission_test
