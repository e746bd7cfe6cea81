// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <graze/io/json/shape_fields.hpp>
#include <graze/shape/any_shape.hpp>

#include "io/scene_text.hpp"

namespace graze::io::shape_fields_test {
namespace {

using Names = std::vector<std::string>;

Names sorted(Names names) {
  std::sort(names.begin(), names.end());
  return names;
}

Names fields_of(std::size_t type_index, Dim dimension) {
  const auto fields = shape_fields(type_index, dimension);
  return sorted(Names(fields.begin(), fields.end()));
}

Names keys_of(const nlohmann::json& object) {
  Names names;
  for (const auto& entry : object.items()) names.push_back(entry.key());
  return sorted(names);
}

TEST(ShapeFields, EveryTypeIsFoundUnderItsName) {
  for (std::size_t i = 0; i < shape_type_names.size(); ++i) EXPECT_EQ(shape_type_index(shape_type_names[i]), i);
  EXPECT_EQ(shape_type_index("Sphere"), std::nullopt);
  EXPECT_EQ(shape_type_index(""), std::nullopt);
}

TEST(ShapeFields, ForeignNamesLeadToTypesThatExist) {
  EXPECT_EQ(our_shape_name("circle"), "sphere");
  EXPECT_EQ(our_shape_name("box"), "aabb");
  EXPECT_EQ(our_shape_name("polygon"), "polytope");
  EXPECT_EQ(our_shape_name("sphere"), std::nullopt);
  EXPECT_TRUE(shape_type_index(*our_shape_name("line")).has_value());
}

TEST(ShapeFields, OnlyTheObbDiffersByDimension) {
  for (std::size_t i = 0; i < shape_type_names.size(); ++i) {
    EXPECT_EQ(fields_of(i, 2) == fields_of(i, 3), shape_type_names[i] != "obb") << shape_type_names[i];
  }
  const std::size_t obb = *shape_type_index("obb");
  EXPECT_EQ(fields_of(obb, 2), (Names{"angle", "axes", "center", "half_extents"}));
  EXPECT_EQ(fields_of(obb, 3), (Names{"axes", "center", "half_extents", "rotation"}));
}

TEST(ShapeFields, TheJsonSchemaHasTheSameTypesAndFields) {
  const auto schema = nlohmann::json::parse(text_of(project_file("data/scene.schema.json")));
  const auto& definitions = schema.at("$defs");
  for (const Dim dimension : {2, 3}) {
    const std::string suffix = "_" + std::to_string(dimension) + "d";
    EXPECT_EQ(definitions.at("shape" + suffix).at("oneOf").size(), shape_type_names.size());
    for (std::size_t i = 0; i < shape_type_names.size(); ++i) {
      const std::string name = std::string(shape_type_names[i]) + suffix;
      const auto& properties = definitions.at(name).at("properties");
      EXPECT_EQ(properties.at("type").at("const"), shape_type_names[i]);
      Names expected = fields_of(i, dimension);
      expected.emplace_back("type");
      EXPECT_EQ(keys_of(properties), sorted(expected)) << name;
      EXPECT_EQ(definitions.at("shape" + suffix).at("oneOf")[i].at("$ref"), "#/$defs/" + name);
    }
  }
}

TEST(ShapeFields, TheDocumentationNamesEveryFieldInItsTypesRow) {
  const std::string page = text_of(project_file("docs/scene_format.md"));
  for (std::size_t i = 0; i < shape_type_names.size(); ++i) {
    const std::size_t begin = page.find("\n| `" + std::string(shape_type_names[i]) + "` |");
    ASSERT_NE(begin, std::string::npos) << shape_type_names[i];
    const std::string row = page.substr(begin + 1, page.find('\n', begin + 1) - begin - 1);
    for (const Dim dimension : {2, 3}) {
      for (const std::string_view field : shape_fields(i, dimension)) {
        EXPECT_NE(row.find('`' + std::string(field) + '`'), std::string::npos) << field << " is missing in: " << row;
      }
    }
  }
}

}  // namespace
}  // namespace graze::io::shape_fields_test
