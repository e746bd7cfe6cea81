// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/svg/solid.hpp>
#include <graze/query/bounds.hpp>

#include "io/svg_picture.hpp"

namespace graze::io::svg::svg_solid_test {
namespace {

struct Painted {
  std::vector<std::string> titles;               ///< In the order of painting.
  std::vector<std::vector<std::string>> pieces;  ///< Of each object: element and class.
  /// Of each element: the number of coordinate pairs of its path or disc.
  std::vector<std::vector<std::size_t>> corners;
};

Painted painted(const Scene<3, double>& scene, const std::vector<ObjectPair>& touching = {},
                const Detail& detail = {}) {
  const Subject<3> subject = subject_of<3>(scene, touching);
  const SvgPicture picture = parsed_fragment(paint_solid(subject, stage_for(subject, YAxis::up), detail));
  Painted result;
  for (const pugi::xml_node& group : picture.root().children("g")) {
    const std::string title = group.child("title").child_value();
    result.titles.push_back(title.substr(0, title.find(' ')));
    result.pieces.emplace_back();
    result.corners.emplace_back();
    for (pugi::xml_node piece = group.child("title").next_sibling(); piece; piece = piece.next_sibling()) {
      result.pieces.back().push_back(std::string(piece.name()) + " " + piece.attribute("class").value());
      result.corners.back().push_back(numbers_in(piece.attribute("d").value()).size() / 2);
    }
  }
  return result;
}

using Pieces = std::vector<std::string>;

Pieces pieces(const AnyShape<3, double>& shape) {
  Scene<3, double> scene;
  scene.add(shape, {.name = "it"});
  return painted(scene).pieces.at(0);
}

TEST(SvgSolid, draws_every_type_of_shape) {
  EXPECT_EQ(pieces(Vec<3, double>(1, 2, 3)), Pieces{"path mark"});
  EXPECT_EQ(pieces(Segment<3, double>{{0, 0, 0}, {1, 2, 3}}), Pieces{"path line"});
  EXPECT_EQ(pieces(Ray<3, double>{{0, 0, 0}, {1, 2, 3}}), Pieces{"path line"});
  EXPECT_EQ(pieces(Sphere<3, double>{{0, 0, 0}, 1}), Pieces{"circle sphere"});
  EXPECT_EQ(pieces(Capsule<3, double>{{0, 0, 0}, {1, 2, 3}, 1}), Pieces{"path "});
  const std::vector<Vec<3, double>> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(pieces(convex_hull<3, double>(corners)), Pieces{"path "});
  EXPECT_EQ(pieces(Triangle<3, double>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), Pieces{"path l4"});
  EXPECT_EQ(pieces(Triangle<3, double>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}), Pieces{"path l4"});  // from either side
}

TEST(SvgSolid, draws_three_faces_of_a_box_the_upper_one_brightest) {
  const Pieces faces = {"path l1", "path l3", "path l4"};  // perpendicular to x, against y, perpendicular to z
  EXPECT_EQ(pieces(Aabb<3, double>{{0, 0, 0}, {1, 1, 1}}), faces);
  const Obb<3, double> quarter_turn{{0, 0, 0}, {1, 1, 1}, rotation_matrix(Vec<3, double>(0, 0, 1), 90)};
  EXPECT_EQ(pieces(quarter_turn), (Pieces{"path l3", "path l1", "path l4"}));
  Scene<3, double> scene;
  scene.add(Aabb<3, double>{{0, 0, 0}, {1, 1, 1}}, {.name = "it"});
  EXPECT_EQ(painted(scene).corners[0], (std::vector<std::size_t>{4, 4, 4}));
}

TEST(SvgSolid, draws_planes_as_sheets_with_a_grid_across_an_axis) {
  EXPECT_EQ(pieces(HalfSpace<3, double>{{0, 0, 1}, 0}), (Pieces{"path sheet", "path grid"}));
  EXPECT_EQ(pieces(Plane<3, double>{{0, -2, 0}, 5}), (Pieces{"path sheet", "path grid"}));
  EXPECT_EQ(pieces(Plane<3, double>{{1, 1, 1}, 5}), Pieces{"path sheet"});
}

TEST(SvgSolid, draws_the_parts_of_a_compound_from_back_to_front) {
  // The sphere is in front of the box.
  const auto lamp = compound_of<3, double>({Sphere<3, double>{{0, 0, 3}, 1}, Aabb<3, double>{{-1, -1, 0}, {1, 1, 2}}});
  EXPECT_EQ(pieces(lamp), (Pieces{"path l1", "path l3", "path l4", "circle sphere"}));
  EXPECT_EQ(pieces(Compound<3, double>{}), Pieces{});
}

TEST(SvgSolid, patterns_what_touches) {
  Scene<3, double> scene;
  const ObjectId a = scene.add(Sphere<3, double>{{0, 0, 0}, 1}, {.name = "a"});
  const ObjectId b = scene.add(Aabb<3, double>{{-1, -1, 1}, {1, 1, 2}}, {.name = "b"});
  const ObjectId c = scene.add(Segment<3, double>{{0, 0, 2}, {0, 0, 3}}, {.name = "c"});
  const std::vector<ObjectPair> pairs = {{a, b}, {b, c}};
  const Painted rich = painted(scene, pairs);
  EXPECT_EQ(rich.titles, (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(rich.pieces[0], (Pieces{"circle sphere", "circle pattern"}));
  EXPECT_EQ(rich.pieces[1], (Pieces{"path l1", "path l3", "path l4", "path pattern"}));
  EXPECT_EQ(rich.pieces[2], Pieces{"path line"});
  Detail plain;
  plain.patterns = false;
  plain.faces = false;
  EXPECT_EQ(painted(scene, pairs, plain).pieces[1], Pieces{"path l3"});
}

TEST(SvgSolid, paints_what_stands_on_the_ground_over_it) {
  Scene<3, double> scene;
  scene.add(Aabb<3, double>{{-9, 8, 0}, {-8, 9, 1}}, {.name = "crate"});
  scene.add(HalfSpace<3, double>{{0, 0, 1}, 0}, {.name = "ground"});
  scene.add(Aabb<3, double>{{8, -9, 0}, {9, -8, 1}}, {.name = "barrel"});
  EXPECT_EQ(painted(scene).titles, (std::vector<std::string>{"ground", "crate", "barrel"}));
}

}  // namespace
}  // namespace graze::io::svg::svg_solid_test
