// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/json/shape_fields.hpp>
#include <graze/io/json/shape_reader.hpp>
#include <graze/query/bounds.hpp>

#include "io/scene_text.hpp"
#include "io/shape_bits.hpp"

namespace graze::io::json_shape_reader_test {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;

template <Dim N>
AnyShape<N, double> read(const std::string& text) {
  const JsonDocument document(text, "a.json");
  const JsonPlace place{document, nullptr, "object", 3, "ball"};
  return read_json_shape<N>(document.root(), place, {});
}

/// The message of a rejection after file, position and object.
template <Dim N>
std::string refusal(const std::string& text) {
  const std::string message = error_of([&text] { read<N>(text); });
  const std::string marker = "object 3 \"ball\"";
  const std::size_t begin = message.find(marker);
  if (message.find("a.json: line 1, column ") != 0 || begin == std::string::npos) return "incomplete: " + message;
  return message.substr(begin + marker.size());
}

template <Dim N>
void expect_same(const std::string& text, const AnyShape<N, double>& expected) {
  EXPECT_EQ(bits_of<N>(read<N>(text)), bits_of<N>(expected)) << text;
}

TEST(JsonShapeReader, EveryTypeIsReadIn2d) {
  expect_same<2>(R"({"type": "point", "position": [1, 2]})", V2(1, 2));
  expect_same<2>(R"({"type": "segment", "start": [1, 2], "end": [3, 4]})", Segment<2, double>{{1, 2}, {3, 4}});
  expect_same<2>(R"({"type": "ray", "origin": [1, 2], "direction": [0, 9]})", Ray<2, double>{{1, 2}, {0, 9}});
  expect_same<2>(R"({"type": "sphere", "center": [1, 2], "radius": 0})", Sphere<2, double>{{1, 2}, 0});
  expect_same<2>(R"({"type": "aabb", "min": [1, 2], "max": [1, 4]})", Aabb<2, double>{{1, 2}, {1, 4}});
  expect_same<2>(R"({"type": "aabb", "center": [1, 2], "half_extents": [0.5, 1]})",
                 Aabb<2, double>{{0.5, 1}, {1.5, 3}});
  expect_same<2>(R"({"type": "plane", "normal": [0, 2], "offset": -3})", Plane<2, double>{{0, 2}, -3});
  expect_same<2>(R"({"type": "half_space", "normal": [0, 2], "offset": -3})", HalfSpace<2, double>{{0, 2}, -3});
  expect_same<2>(R"({"type": "triangle", "a": [0, 0], "b": [1, 0], "c": [0, 1]})",
                 Triangle<2, double>{{0, 0}, {1, 0}, {0, 1}});
  expect_same<2>(R"({"type": "capsule", "a": [0, 0], "b": [1, 0], "radius": 2})",
                 Capsule<2, double>{{0, 0}, {1, 0}, 2});
  const std::vector<V2> square = {{1, 1}, {0, 1}, {0, 0}, {1, 0}};
  expect_same<2>(R"({"type": "polytope", "points": [[1, 1], [0, 0], [0.5, 0.5], [0, 1], [1, 0]]})",
                 convex_hull_in_order<2, double>(square));
}

TEST(JsonShapeReader, EveryTypeIsReadIn3d) {
  expect_same<3>(R"({"type": "point", "position": [1, 2, 3]})", V3(1, 2, 3));
  expect_same<3>(R"({"type": "segment", "start": [1, 2, 3], "end": [3, 4, 5]})",
                 Segment<3, double>{{1, 2, 3}, {3, 4, 5}});
  expect_same<3>(R"({"type": "ray", "origin": [1, 2, 3], "direction": [0, 9, 0]})",
                 Ray<3, double>{{1, 2, 3}, {0, 9, 0}});
  expect_same<3>(R"({"type": "sphere", "center": [1, 2, 3], "radius": 4})", Sphere<3, double>{{1, 2, 3}, 4});
  expect_same<3>(R"({"type": "aabb", "min": [1, 2, 3], "max": [1, 4, 5]})", Aabb<3, double>{{1, 2, 3}, {1, 4, 5}});
  expect_same<3>(R"({"type": "plane", "normal": [0, 2, 0], "offset": -3})", Plane<3, double>{{0, 2, 0}, -3});
  expect_same<3>(R"({"type": "half_space", "normal": [0, 2, 0], "offset": 3})", HalfSpace<3, double>{{0, 2, 0}, 3});
  expect_same<3>(R"({"type": "triangle", "a": [0, 0, 1], "b": [1, 0, 0], "c": [0, 1, 0]})",
                 Triangle<3, double>{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}});
  expect_same<3>(R"({"type": "capsule", "a": [0, 0, 0], "b": [0, 0, 0], "radius": 2})",
                 Capsule<3, double>{{0, 0, 0}, {0, 0, 0}, 2});
  const std::vector<V3> points = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
  expect_same<3>(R"({"type": "polytope", "points": [[0, 0, 1], [1, 0, 0], [0, 1, 0], [0, 0, 0], [0, 0, 0]]})",
                 convex_hull_in_order<3, double>(points));
}

TEST(JsonShapeReader, OrientedBoxesAreReadFromAxesAngleOrRotation) {
  const Mat<2, double> quarter(V2(0, 1), V2(-1, 0));
  const std::string box_2d = R"({"type": "obb", "center": [1, 2], "half_extents": [3, 4])";
  expect_same<2>(box_2d + "}", Obb<2, double>{{1, 2}, {3, 4}, Mat<2, double>(1.0)});
  expect_same<2>(box_2d + R"(, "axes": [[0, 1], [-1, 0]]})", Obb<2, double>{{1, 2}, {3, 4}, quarter});
  const auto turned = std::get<Obb<2, double>>(read<2>(box_2d + R"(, "angle": -270})"));
  EXPECT_EQ(turned.axes, quarter);
  const auto tilted = std::get<Obb<2, double>>(read<2>(box_2d + R"(, "angle": 30})"));
  EXPECT_NEAR(tilted.axes[0].x, std::sqrt(0.75), 1e-15);
  EXPECT_NEAR(tilted.axes[0].y, 0.5, 1e-15);

  const std::string box_3d = R"({"type": "obb", "center": [1, 2, 3], "half_extents": [3, 4, 5])";
  const Mat<3, double> about_z(V3(0, 1, 0), V3(-1, 0, 0), V3(0, 0, 1));
  for (const std::string axis : {"[0, 0, 1]", "[0, 0, 1e300]", "[0, 0, 1e-300]"}) {
    const auto rotated_box =
        std::get<Obb<3, double>>(read<3>(box_3d + R"(, "rotation": {"axis": )" + axis + R"(, "angle": 90}})"));
    EXPECT_EQ(rotated_box.axes, about_z) << axis;
  }
  expect_same<3>(box_3d + R"(, "axes": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]})",
                 Obb<3, double>{{1, 2, 3}, {3, 4, 5}, Mat<3, double>(1.0)});
}

TEST(JsonShapeReader, CompoundsAreReadWithTheirParts) {
  const AnyShape<2, double> inner = compound_of<2, double>({V2(5, 6)});
  expect_same<2>(
      R"({"type": "compound", "parts": [{"type": "sphere", "center": [1, 2], "radius": 3},
          {"type": "compound", "parts": [{"type": "point", "position": [5, 6]}]}]})",
      compound_of<2, double>({Sphere<2, double>{{1, 2}, 3}, inner}));
  expect_same<3>(R"({"type": "compound", "parts": []})", Compound<3, double>{});
}

std::string nested_compound(std::size_t depth) {
  std::string text = R"({"type": "point", "position": [0, 0]})";
  for (std::size_t i = 0; i < depth; ++i) text = R"({"type": "compound", "parts": [)" + text + "]}";
  return text;
}

TEST(JsonShapeReader, CompoundsNestUpToALimit) {
  EXPECT_NO_THROW(read<2>(nested_compound(max_compound_depth)));
  const std::string message = refusal<2>(nested_compound(max_compound_depth + 1));
  EXPECT_NE(message.find("part 0: compounds are nested deeper than 32"), std::string::npos) << message;
}

TEST(JsonShapeReader, MeshesHaveVerticesFacesAndPerhapsAKind) {
  const std::vector<Vec<3, double>> vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<std::array<std::uint32_t, 3>> faces = {{0, 1, 2}, {3, 2, 2}};
  const std::string text =
      R"({"type": "mesh", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], "faces": [[0, 1, 2], [3, 2, 2]])";
  expect_same<3>(text + "}", mesh_of<3, double>(vertices, faces));
  expect_same<3>(text + R"(, "kind": "surface"})", mesh_of<3, double>(vertices, faces));
  expect_same<3>(text + R"(, "kind": "solid"})", mesh_of<3, double>(vertices, faces, MeshKind::solid));
  expect_same<2>(R"({"type": "mesh", "vertices": [], "faces": []})", Mesh<2, double>());
}

TEST(JsonShapeReader, UnknownTypesAreNamedWithTheNearestKnown) {
  EXPECT_EQ(refusal<2>(R"({"type": "circle"})"), R"(: unknown type "circle"; did you mean "sphere"?)");
  EXPECT_EQ(refusal<2>(R"({"type": "box"})"), R"(: unknown type "box"; did you mean "aabb"?)");
  EXPECT_EQ(refusal<2>(R"({"type": "spere"})"), R"(: unknown type "spere"; did you mean "sphere"?)");
  EXPECT_EQ(refusal<2>(R"({"type": "Half-Space"})"), R"(: unknown type "Half-Space"; did you mean "half_space"?)");
  EXPECT_EQ(refusal<2>(R"({"type": "torus"})").find(R"(: unknown type "torus"; known: "point", "segment", )"), 0U);
  EXPECT_EQ(refusal<2>(R"({"type": 7})"), R"(: "type" must be a string, not a number)");
  EXPECT_EQ(refusal<2>(R"({"radius": 7})"), R"(: a shape needs the field "type")");
  EXPECT_EQ(refusal<2>("7"), ": must be an object, not a number");
}

TEST(JsonShapeReader, WrongValuesAreNamed) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {R"({"type": "sphere", "center": [0, 0], "radius": -1})", R"(: "radius" is -1; it must not be negative)"},
      {R"({"type": "mesh", "vertices": [[0, 0]], "faces": [[0, 0, 1]]})",
       ": face 0 has vertex 1, but there are 1 vertices, numbered from 0"},
      {R"({"type": "mesh", "vertices": [[0, 0]], "faces": [[0, 0]]})",
       ": face 0 must be three indices of vertices, not 2"},
      {R"({"type": "mesh", "vertices": [[0, 0]], "faces": [], "kind": "shell"})",
       R"(: "kind" is "shell"; a mesh is a "surface" or a "solid")"},
      {R"({"type": "capsule", "a": [0, 0], "b": [0, 0], "radius": -0.5})",
       R"(: "radius" is -0.5; it must not be negative)"},
      {R"({"type": "ray", "origin": [0, 0], "direction": [0, -0.0]})",
       R"(: "direction" is zero and so has no direction; any other length is allowed)"},
      {R"({"type": "plane", "normal": [0, 0], "offset": 1})",
       R"(: "normal" is zero and so has no direction; any other length is allowed)"},
      {R"({"type": "half_space", "normal": [0, 0], "offset": 1})",
       R"(: "normal" is zero and so has no direction; any other length is allowed)"},
      {R"({"type": "aabb", "min": [0, 5], "max": [1, 4]})", R"(: "min" is above "max" in coordinate 1: 5 > 4)"},
      {R"({"type": "aabb", "center": [0, 5], "half_extents": [1, -4]})",
       R"(: "half_extents" has -4 as coordinate 1; none may be negative)"},
      {R"({"type": "aabb", "center": [1e308, 0], "half_extents": [1e308, 0]})",
       R"(: "half_extents" is too large: the box exceeds the largest number, about 1.8e308)"},
      {R"({"type": "aabb", "min": [0, 0], "half_extents": [1, 1]})",
       R"(: an aabb needs either "min" and "max" or "center" and "half_extents")"},
      {R"({"type": "aabb"})", R"(: an aabb needs either "min" and "max" or "center" and "half_extents")"},
      {R"({"type": "aabb", "min": [0, 0]})", R"(: an aabb needs the field "max")"},
      {R"({"type": "obb", "center": [0, 0], "half_extents": [-1, 1]})",
       R"(: "half_extents" has -1 as coordinate 0; none may be negative)"},
      {R"({"type": "obb", "center": [0, 0], "half_extents": [1, 1], "axes": [[2, 0], [0, 1]]})",
       R"(: "axes" are not orthonormal: columns must have length 1 and be at right angles)"},
      {R"({"type": "obb", "center": [0, 0], "half_extents": [1, 1], "axes": [[1, 0]]})",
       R"(: "axes" must be 2 columns, not 1)"},
      {R"({"type": "obb", "center": [0, 0], "half_extents": [1, 1], "axes": [[1, 0], [0, 1, 0]]})",
       R"(: "axes"[1] has 3 numbers; this scene has dimension 2)"},
      {R"({"type": "obb", "center": [0, 0], "half_extents": [1, 1], "axes": [[1, 0], [0, 1]], "angle": 0})",
       R"(: "angle" and "axes" both give the rotation; give only one)"},
      {R"({"type": "obb", "center": [0, 0], "half_extents": [1, 1], "rotation": {}})",
       R"(: "rotation" belongs to dimension 3; in dimension 2 give "angle")"},
      {R"({"type": "polytope", "points": []})", R"(: "points" is empty; a polytope needs at least one point)"},
      {R"({"type": "polytope", "points": [[0, 0], [1, 2, 3]]})",
       R"(: "points"[1] has 3 numbers; this scene has dimension 2)"},
      {R"({"type": "polytope", "points": {}})", R"(: "points" must be an array, not an object)"},
      {R"({"type": "compound", "parts": [{"type": "point", "position": [0, 0]}, {"type": "point"}]})",
       R"(, part 1: a point needs the field "position")"},
      {R"({"type": "compound", "parts": [{"type": "point", "position": [0, 0], "name": "x"}]})",
       R"(, part 0: unknown field "name"; known: "type", "position")"},
  };
  for (const auto& [text, expected] : table) EXPECT_EQ(refusal<2>(text), expected) << text;
}

TEST(JsonShapeReader, WrongRotationsAreNamed) {
  const std::string begin = R"({"type": "obb", "center": [0, 0, 0], "half_extents": [1, 1, 1], )";
  EXPECT_EQ(refusal<3>(begin + R"("rotation": 90})"),
            R"(: "rotation" must be an object: {"axis": [x, y, z], "angle": degrees})");
  EXPECT_EQ(refusal<3>(begin + R"("rotation": {"axis": [0, 0, 1]}})"), R"(: a rotation needs the field "angle")");
  EXPECT_EQ(refusal<3>(begin + R"("rotation": {"axis": [0, 0, 0], "angle": 1}})"),
            R"(: "axis" is zero and so has no direction; any other length is allowed)");
  EXPECT_EQ(refusal<3>(begin + R"("rotation": {"axes": [0, 0, 1], "angle": 1}})"),
            R"(: unknown field "axes"; did you mean "axis"?)");
  EXPECT_EQ(refusal<3>(begin + R"("angle": 90})"),
            R"(: "angle" belongs to dimension 2; in dimension 3 give "rotation")");
}

}  // namespace
}  // namespace graze::io::json_shape_reader_test
