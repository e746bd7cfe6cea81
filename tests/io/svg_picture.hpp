// SPDX-License-Identifier: MIT
// Parses a picture, for tests of its content.
#pragma once

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <graze/io/scene_file.hpp>
#include <graze/io/svg.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/scene.hpp>

namespace graze::io {

struct SvgPicture {
  pugi::xml_document document;

  pugi::xml_node root() const { return document.child("svg"); }
  pugi::xml_node by_id(const char* id) const { return root().find_child_by_attribute("id", id); }
  std::string legend(const char* id) const {
    return by_id("legend")
        .find_node([id](const pugi::xml_node& node) { return std::string(node.attribute("id").value()) == id; })
        .child_value();
  }
};

inline SvgPicture parsed_picture(const std::string& text) {
  SvgPicture picture;
  const pugi::xml_parse_result result = picture.document.load_buffer(text.data(), text.size());
  EXPECT_TRUE(result) << result.description() << " at byte " << result.offset;
  return picture;
}

/// The elements of a fragment, as children of one element.
inline SvgPicture parsed_fragment(const std::string& text) { return parsed_picture("<svg>" + text + "</svg>"); }

template <Dim N>
std::string svg_text(Scene<N, double> scene, const std::vector<ObjectPair>& touching, YAxis y_axis = YAxis::up) {
  const SceneFile file{std::move(scene), "scenes/test.json", "graze.scene/1", y_axis, {}};
  std::ostringstream out;
  write_svg(out, file, touching);
  return out.str();
}

/// The numbers in a list such as a path's data; letters separate them.
inline std::vector<double> numbers_in(const std::string& text) {
  std::string spaced;
  for (const char letter : text)
    spaced += (letter >= '0' && letter <= '9') || letter == '.' || letter == '-' ? letter : ' ';
  std::istringstream in(spaced);
  std::vector<double> numbers;
  for (double number = 0; in >> number;) numbers.push_back(number);
  return numbers;
}

}  // namespace graze::io
