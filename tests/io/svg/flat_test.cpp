// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/svg/flat.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/convex_parts.hpp>

#include "io/svg_picture.hpp"

namespace graze::io::svg::svg_flat_test {
namespace {

/// The elements that a shape is drawn with, in a scene framed by a box of 1080 x 540: one pixel per unit, the origin at
/// (60, 648). Each as its element's name, its class and its numbers or path.
std::vector<std::string> pieces(const AnyShape<2, double>& shape, YAxis y_axis = YAxis::up) {
  Scene<2, double> scene;
  scene.add(Aabb<2, double>{{0, 0}, {1080, 540}}, {.name = "frame"});
  scene.add(shape, {.name = "it"});
  const Subject<2> subject = subject_of<2>(scene, {});
  const Stage<2> stage = stage_for(subject, y_axis);
  const SvgPicture picture = parsed_fragment(paint_flat(subject, stage, Detail{}));
  std::vector<std::string> result;
  for (const pugi::xml_node& group : picture.root().children("g")) {
    if (!std::string(group.child("title").child_value()).starts_with("it ")) continue;
    for (pugi::xml_node piece = group.child("title").next_sibling(); piece; piece = piece.next_sibling()) {
      std::string text = piece.name();
      for (const pugi::xml_attribute& attribute : piece.attributes()) text += std::string(" ") + attribute.value();
      result.push_back(text);
    }
  }
  return result;
}

using Pieces = std::vector<std::string>;

TEST(SvgFlat, draws_every_type_of_shape) {
  EXPECT_EQ(pieces(Vec<2, double>(10, 10)), Pieces{"path mark M65.5 638h9M70 633.5v9"});
  EXPECT_EQ(pieces(Segment<2, double>{{0, 0}, {10, 10}}), Pieces{"path line M60 648L70 638"});
  EXPECT_EQ(pieces(Sphere<2, double>{{100, 100}, 50}), Pieces{"circle 160 548 50"});
  EXPECT_EQ(pieces(Aabb<2, double>{{100, 100}, {300, 150}}), Pieces{"rect 160 498 200 50"});
  EXPECT_EQ(pieces(Obb<2, double>{{100, 100}, {20, 10}, rotation_matrix(90)}),
            Pieces{"path M150 568L170 568L170 528L150 528Z"});
  EXPECT_EQ(pieces(Triangle<2, double>{{0, 0}, {10, 0}, {0, 10}}), Pieces{"path M60 648L70 648L60 638Z"});
  EXPECT_EQ(pieces(Capsule<2, double>{{10, 10}, {20, 10}, 2}),
            Pieces{"path M70 640L80 640A2 2 0 0 0 80 636L70 636A2 2 0 0 0 70 640Z"});
  const std::vector<Vec<2, double>> corners = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {5, 5}};
  EXPECT_EQ(pieces(convex_hull<2, double>(corners)), Pieces{"path M60 648L70 648L70 638L60 638Z"});
}

TEST(SvgFlat, draws_unbounded_shapes_to_the_edge_of_the_card) {
  EXPECT_EQ(pieces(Ray<2, double>{{0, 100}, {5, 0}}),
            Pieces{"path line M60 548L1180 548M1169 552.5L1180 548L1169 543.5"});
  EXPECT_EQ(pieces(Plane<2, double>{{0, 1}, 100}), Pieces{"path line M20 548L1180 548"});
  EXPECT_EQ(pieces(HalfSpace<2, double>{{0, 1}, 100}),
            (Pieces{"path ground M20 688L1180 688L1180 548L20 548Z", "path line M20 548L1180 548"}));
}

TEST(SvgFlat, draws_the_polygons_of_a_compound_as_one_and_its_other_parts_as_they_are) {
  const auto inner = compound_of<2, double>({Sphere<2, double>{{100, 100}, 50}, Segment<2, double>{{0, 0}, {10, 10}}});
  EXPECT_EQ(pieces(compound_of<2, double>(
                {Aabb<2, double>{{100, 100}, {300, 150}}, inner, Aabb<2, double>{{100, 150}, {200, 250}}})),
            (Pieces{"path M160 548L360 548L360 498L260 498L260 398L160 398L160 498Z", "circle 160 548 50",
                    "path line M60 648L70 638"}));
  EXPECT_EQ(pieces(Compound<2, double>{}), Pieces{});
}

TEST(SvgFlat, draws_a_concave_polygon_without_the_cuts_into_convex_parts) {
  const std::vector<Vec<2, double>> star = {{50, 0},   {60, 40}, {100, 50}, {60, 60},
                                            {50, 100}, {40, 60}, {0, 50},   {40, 40}};
  const auto parts = convex_parts<double>(star);
  ASSERT_TRUE(parts);
  std::vector<AnyShape<2, double>> shapes;
  for (const auto& part : *parts) shapes.emplace_back(convex_hull<2, double>(part));
  const Pieces found = pieces(compound_of<2, double>(std::move(shapes)));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(std::count(found[0].begin(), found[0].end(), 'M'), 1);
  EXPECT_EQ(std::count(found[0].begin(), found[0].end(), 'L'), 7);
}

TEST(SvgFlat, draws_y_downwards_when_the_file_says_so) {
  EXPECT_EQ(pieces(Sphere<2, double>{{100, 100}, 50}, YAxis::down), Pieces{"circle 160 208 50"});
  EXPECT_EQ(pieces(Aabb<2, double>{{0, 0}, {10, 20}}, YAxis::down), Pieces{"rect 60 108 10 20"});
  EXPECT_EQ(pieces(Plane<2, double>{{0, 1}, 100}, YAxis::down), Pieces{"path line M20 208L1180 208"});
}

TEST(SvgFlat, paints_unbounded_shapes_first_and_small_ones_last) {
  Scene<2, double> scene;
  scene.add(Sphere<2, double>{{0, 0}, 1}, {.name = "small"});
  scene.add(Sphere<2, double>{{0, 0}, 3}, {.name = "large"});
  scene.add(Segment<2, double>{{0, 0}, {9, 0}}, {.name = "thin"});
  scene.add(HalfSpace<2, double>{{0, 1}, 0}, {.name = "ground"});
  const Subject<2> subject = subject_of<2>(scene, {});
  const SvgPicture picture = parsed_fragment(paint_flat(subject, stage_for(subject, YAxis::up), Detail{}));
  std::vector<std::string> titles;
  for (const pugi::xml_node& group : picture.root().children()) titles.push_back(group.child("title").child_value());
  EXPECT_EQ(titles,
            (std::vector<std::string>{"ground (half_space)", "large (sphere)", "small (sphere)", "thin (segment)"}));
}

}  // namespace
}  // namespace graze::io::svg::svg_flat_test
