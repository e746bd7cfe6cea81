// SPDX-License-Identifier: MIT
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <graze/io/svg/style.hpp>

#include "io/svg_picture.hpp"

namespace graze::io::svg::svg_style_test {
namespace {

TEST(SvgStyle, shows_less_of_each_object_the_more_there_are) {
  EXPECT_TRUE(detail_for(5000).labels);
  EXPECT_FALSE(detail_for(5001).labels);
  EXPECT_TRUE(detail_for(5000).titles);
  EXPECT_TRUE(detail_for(5000).patterns);
  EXPECT_FALSE(detail_for(5001).titles);
  EXPECT_FALSE(detail_for(5001).patterns);
  EXPECT_TRUE(detail_for(10000).faces);
  EXPECT_FALSE(detail_for(10001).faces);
  EXPECT_GT(detail_for(400).stroke, detail_for(401).stroke);
  EXPECT_GT(detail_for(401).stroke, detail_for(5001).stroke);
}

TEST(SvgStyle, says_what_it_leaves_out) {
  EXPECT_EQ(omission(detail_for(5000), 5000), "");
  EXPECT_EQ(omission(detail_for(6000), 6000),
            "6000 objects: names, titles and patterns are left out above 5000, in 3D the faces of boxes above 10000");
}

/// The ids in "url(#...)".
std::set<std::string> referenced(const std::string& css) {
  std::set<std::string> ids;
  for (std::size_t at = css.find("url(#"); at != std::string::npos; at = css.find("url(#", at + 1)) {
    ids.insert(css.substr(at + 5, css.find(')', at) - at - 5));
  }
  return ids;
}

TEST(SvgStyle, defines_every_pattern_and_gradient_it_refers_to_and_no_other) {
  for (const auto& [detail, dimension] : {std::pair(Detail{}, 2), std::pair(Detail{}, 3),
                                          std::pair(detail_for(6000), 2), std::pair(detail_for(6000), 3)}) {
    const SvgPicture picture = parsed_fragment(style_sheet(detail, dimension));
    std::set<std::string> defined;
    for (const pugi::xml_node& definition : picture.root().child("defs").children()) {
      defined.insert(definition.attribute("id").value());
    }
    EXPECT_EQ(referenced(picture.root().child("style").child_value()), defined) << dimension << "D";
    EXPECT_FALSE(defined.empty());
  }
}

TEST(SvgStyle, tells_touching_from_overlapping_by_colour_and_by_pattern_dashes_or_width) {
  const std::string rich = style_sheet(detail_for(10), 2);
  EXPECT_NE(rich.find(".touching{stroke:#0f7568;stroke-width:1.69}"), std::string::npos);
  EXPECT_NE(rich.find(".overlapping{stroke:#d55e00;stroke-width:2.47}"), std::string::npos);
  EXPECT_NE(rich.find(".touching{fill:url(#touching)"), std::string::npos);
  EXPECT_NE(rich.find(".overlapping{fill:url(#overlapping)"), std::string::npos);
  EXPECT_NE(rich.find(".touching{stroke-dasharray"), std::string::npos);
  const std::string plain = style_sheet(detail_for(100'000), 2);
  EXPECT_NE(plain.find(".touching{stroke:#0f7568;stroke-width:0.52}"), std::string::npos);
  EXPECT_NE(plain.find(".overlapping{stroke:#d55e00;stroke-width:0.76}"), std::string::npos);
  EXPECT_NE(plain.find(".overlapping{fill:#d55e00"), std::string::npos);
}

TEST(SvgStyle, has_a_colour_for_every_shade) {
  const std::string css = style_sheet(Detail{}, 3);
  for (int shade = 0; shade < shades; ++shade) {
    EXPECT_NE(css.find(".l" + std::to_string(shade) + "{fill:#"), std::string::npos);
    EXPECT_NE(css.find(".touching .l" + std::to_string(shade) + "{fill:#"), std::string::npos);
    EXPECT_NE(css.find(".overlapping .l" + std::to_string(shade) + "{fill:#"), std::string::npos);
  }
}

TEST(SvgStyle, keeps_lines_as_wide_as_they_are_when_the_picture_is_enlarged) {
  EXPECT_NE(style_sheet(Detail{}, 2).find("vector-effect:non-scaling-stroke"), std::string::npos);
}

}  // namespace
}  // namespace graze::io::svg::svg_style_test
