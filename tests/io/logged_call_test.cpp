// SPDX-License-Identifier: MIT
#include <string>

#include <gtest/gtest.h>

#include <graze/io/logged_call.hpp>
#include <graze/io/output_error.hpp>

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
  const AnyShape<2, double> ball = Ball{{0, -0.0}, 1};
  EXPECT_EQ(call_line(Call{.kind = CallKind::add, .shapes = {ball}}),
            R"({"call": "add", "shape": {"type": "sphere", "center": [0, -0.0], "radius": 1}})");
  EXPECT_EQ(call_line(Call{.kind = CallKind::add, .shapes = {ball}, .options = {"b", 2, 5, 7, Mobility::fixed}}),
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

TEST(LoggedCall, OfAFaultSaysNothingElse) {
  EXPECT_EQ(call_line(Call{.kind = CallKind::move, .fault = "a sphere has a negative radius"}),
            R"({"call": "move", "fault": "a sphere has a negative radius"})");
}

TEST(LoggedCall, RefusesTextThatIsNotUtf8) {
  EXPECT_THROW(call_line(Call{.kind = CallKind::layer, .name = "b\xff"}), OutputError);
  EXPECT_THROW(call_line(Call{.kind = CallKind::add, .shapes = {Ball{}}, .options = {.name = "b\xff"}}), OutputError);
}

}  // namespace
}  // namespace graze::io::logged_call_test
