// SPDX-License-Identifier: MIT
#include <cstddef>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <graze/io/log/logged_call.hpp>
#include <graze/io/log/query_log.hpp>
#include <graze/io/output_error.hpp>

#include "io/scene_text.hpp"

namespace graze::io::logged_call_test {
namespace {

using Call = LoggedCall<2>;
using Ball = Sphere<2, double>;

constexpr ObjectId third{3, 1, logged_scene};

TEST(LoggedCall, IsALineOfJson) {
  EXPECT_EQ(call_line(Call{.kind = CallKind::update}), R"({"call": "update"})");
  EXPECT_EQ(call_line(Call{.kind = CallKind::remove, .ids = {third}}), R"({"call": "remove", "id": [3, 1]})");
  EXPECT_EQ(call_line(Call{.kind = CallKind::layer, .name = "a \"b\"\n"}), R"({"call": "layer", "name": "a \"b\"\n"})");
  EXPECT_EQ(call_line(Call{.kind = CallKind::candidates, .margin = 0.1}), R"({"call": "candidates", "margin": 0.1})");
  EXPECT_EQ(call_line(Call{.kind = CallKind::plan_ids, .ids = {third}, .vacant_ids = {}}),
            R"({"call": "plan_ids", "ids": [[3, 1]], "vacant_ids": []})");
}

TEST(LoggedCall, WritesOfOptionsWhatIsNotTheDefault) {
  const AnyShape<2, double> sphere = Ball{{0, -0.0}, 1};
  EXPECT_EQ(call_line(Call{.kind = CallKind::add, .shapes = {sphere}}),
            R"({"call": "add", "shape": {"type": "sphere", "center": [0, -0.0], "radius": 1}})");
  EXPECT_EQ(call_line(Call{.kind = CallKind::add, .shapes = {sphere}, .options = {"b", 2, 5, 7, Mobility::fixed}}),
            R"({"call": "add", "name": "b", "layer": 2, "mask": 5, "user": 7, "fixed": true, )"
            R"("shape": {"type": "sphere", "center": [0, -0.0], "radius": 1}})");
}

TEST(LoggedCall, WritesOfAQuestionWhatIsNotTheDefault) {
  Call ray{.kind = CallKind::ray_cast, .shapes = {Ray<2, double>{{0, 0}, {1, 0}}}};
  const std::string shape = R"("shape": {"type": "ray", "origin": [0, 0], "direction": [1, 0]})";
  EXPECT_EQ(call_line(ray), R"({"call": "ray_cast", )" + shape + "}");
  ray.t_max = 2.5;
  ray.layers = 3;
  EXPECT_EQ(call_line(ray), R"({"call": "ray_cast", )" + shape + R"(, "t_max": 2.5, "layers": 3})");
  EXPECT_EQ(call_line(Call{.kind = CallKind::nearest, .shapes = {Vec<2, double>(1, 2)}, .count = 4}),
            R"({"call": "nearest", "shape": {"type": "point", "position": [1, 2]}, "count": 4})");
  EXPECT_EQ(call_line(Call{.kind = CallKind::cull_frustum, .corners = {{0, 0}, {1, 0}}}),
            R"({"call": "cull_frustum", "corners": [[0, 0], [1, 0]]})");
}

TEST(LoggedCall, WritesTheMotionOfAShape) {
  const std::string shape = R"("shape": {"type": "point", "position": [1, 2]})";
  Call cast{.kind = CallKind::shape_cast, .shapes = {Vec<2, double>(1, 2)}, .motion = {{3, 0.5}, 7, {1, 0}}};
  EXPECT_EQ(call_line(cast), R"({"call": "shape_cast", )" + shape + R"(, "motion": [3, 0.5]})");
  cast.kind = CallKind::time_of_impact;
  cast.except = {third};
  EXPECT_EQ(call_line(cast), R"({"call": "time_of_impact", )" + shape +
                                 R"(, "motion": [3, 0.5], "angular": 7, "center": [1, 0], "except": [[3, 1]]})");
  const LoggedCall<3> in_3d{
      .kind = CallKind::time_of_impact, .shapes = {Vec<3, double>(1, 2, 3)}, .motion = {{}, {1, 2, 3}, {}}};
  EXPECT_NE(call_line(in_3d).find(R"("angular": [1, 2, 3])"), std::string::npos);
  EXPECT_EQ(call_line(Call{.kind = CallKind::closest_pairs, .within = 0.5}),
            R"({"call": "closest_pairs", "within": 0.5})");
  EXPECT_EQ(call_line(Call{.kind = CallKind::except, .ids = {third, {0, 1, logged_scene}}}),
            R"({"call": "except", "ids": [[3, 1], [0, 1]]})");
}

TEST(LoggedCall, OfAFaultSaysNothingElse) {
  EXPECT_EQ(call_line(Call{.kind = CallKind::move, .fault = "a sphere has a negative radius"}),
            R"({"call": "move", "fault": "a sphere has a negative radius"})");
}

TEST(LoggedCall, RefusesTextThatIsNotUtf8) {
  EXPECT_THROW(call_line(Call{.kind = CallKind::layer, .name = "b\xff"}), OutputError);
  EXPECT_THROW(call_line(Call{.kind = CallKind::add, .shapes = {Ball{}}, .options = {.name = "b\xff"}}), OutputError);
}

using Names = std::set<std::string>;

Names keys_of(const nlohmann::json& object) {
  Names keys;
  for (const auto& entry : object.items()) keys.insert(entry.key());
  return keys;
}

Names fields_of(const Call& call) { return keys_of(nlohmann::json::parse(call_line(call))); }

/// With a shape that every kind of call accepts except rays and points, which have types of their own.
Call plain_call(CallKind kind) {
  AnyShape<2, double> shape = Ball{{0, 0}, 1};
  if (kind == CallKind::nearest) shape = Vec<2, double>(0, 0);
  if (kind == CallKind::ray_cast || kind == CallKind::ray_cast_all) shape = Ray<2, double>{};
  return {.kind = kind, .ids = {third}, .shapes = {shape}};
}

TEST(LoggedCall, TheJsonSchemaHasTheCallsAndTheirFields) {
  const auto schema = nlohmann::json::parse(text_of(project_file("data/log.schema.json")));
  const auto& definitions = schema.at("$defs");
  Names lines;
  for (const auto& line : schema.at("oneOf")) lines.insert(line.at("$ref"));
  Names expected_lines{"#/$defs/head", "#/$defs/call_with_fault", "#/$defs/answer", "#/$defs/digest",
                       "#/$defs/refusal"};
  for (std::size_t i = 0; i < call_kinds; ++i) {
    const std::string name(call_forms[i].name);
    expected_lines.insert("#/$defs/call_" + name);
    const auto& definition = definitions.at("call_" + name);
    EXPECT_EQ(definition.at("properties").at("call").at("const"), name);
    EXPECT_EQ(definitions.at("call_with_fault").at("properties").at("call").at("enum").at(i), name);
    EXPECT_EQ(definition.at("additionalProperties"), false) << name;
    Call call = plain_call(static_cast<CallKind>(i));
    EXPECT_EQ(Names(definition.at("required").begin(), definition.at("required").end()), fields_of(call)) << name;
    call.options = {"b", 2, 5, 7, Mobility::fixed};
    call.t_max = 1;
    call.layers = 3;
    call.except = {third};
    call.ignore_initial_touch = true;
    EXPECT_EQ(keys_of(definition.at("properties")), fields_of(call)) << name;
  }
  EXPECT_EQ(lines, expected_lines);
  EXPECT_EQ(definitions.at("head").at("properties").at("schema").at("const"), query_log_schema);
}

}  // namespace
}  // namespace graze::io::logged_call_test
