// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/svg/stage.hpp>
#include <graze/query/bounds.hpp>

namespace graze::io::svg::svg_stage_test {
namespace {

template <Dim N>
Stage<N> stage_of(const Scene<N, double>& scene, YAxis y_axis = YAxis::up) {
  return stage_for(subject_of<N>(scene, {}), y_axis);
}

TEST(SvgStage, shows_bounded_shapes_whole) {
  Scene<2, double> scene;
  scene.add(Aabb<2, double>{{0, 0}, {4, 2}});
  scene.add(Sphere<2, double>{{9, 1}, 1});
  const Stage<2> stage = stage_of(scene);
  EXPECT_EQ(stage.frame.center, (Vec<2, double>(5, 1)));
  EXPECT_EQ(stage.frame.scale, 108);
  EXPECT_EQ(stage.drawn, (std::vector<std::size_t>{0, 1}));
}

TEST(SvgStage, turns_the_picture_over_when_y_points_down) {
  Scene<2, double> scene;
  scene.add(Aabb<2, double>{{0, 0}, {4, 2}});
  const Stage<2> stage = stage_of(scene, YAxis::down);
  EXPECT_EQ(stage.frame.center, (Vec<2, double>(2, -1)));
  EXPECT_GT(to_picture(stage.frame, seen({0, 2}, stage.view)).y, to_picture(stage.frame, seen({0, 0}, stage.view)).y);
}

TEST(SvgStage, cuts_unbounded_shapes_off_at_the_card) {
  Scene<2, double> scene;
  scene.add(Aabb<2, double>{{0, 0}, {1080, 540}});
  scene.add(HalfSpace<2, double>{{0, 1}, 0});
  const Stage<2> stage = stage_of(scene);
  EXPECT_EQ(stage.box.min, (Vec<2, double>(-40, -40)));
  EXPECT_EQ(stage.box.max, (Vec<2, double>(1120, 580)));
  const Aabb<2, double> ground = box_around(outline_on(stage, HalfSpace<2, double>{{0, 1}, 0}));
  EXPECT_EQ(ground.min, (Vec<2, double>(-40, -40)));
  EXPECT_EQ(ground.max, (Vec<2, double>(1120, 0)));
}

TEST(SvgStage, takes_in_planes_beside_the_scene_where_they_are_nearest) {
  Scene<2, double> scene;
  scene.add(Aabb<2, double>{{4, 4}, {6, 6}});
  scene.add(Plane<2, double>{{0, 2}, 40});
  scene.add(Ray<2, double>{{-5, 5}, {-1, 0}});
  const Stage<2> stage = stage_of(scene);
  // From the ray's origin (-5, 5) to the box (6, 6), and up to the plane y = 20 above the center of both.
  EXPECT_EQ(stage.frame.center, (Vec<2, double>(0.5, 12)));
}

TEST(SvgStage, leaves_out_what_is_too_far_away_to_be_calculated_with) {
  Scene<2, double> scene;
  scene.add(Sphere<2, double>{{1e101, 0}, 1});
  scene.add(Sphere<2, double>{{0, 0}, 1e300});
  scene.add(Sphere<2, double>{{1e308, 0}, 1.7e308});
  scene.add(Plane<2, double>{{1e-300, 0}, 1e300});
  scene.add(Ray<2, double>{{0, -1e200}, {0, 1}});
  scene.add(Sphere<2, double>{{1, 2}, 3});
  const Stage<2> stage = stage_of(scene);
  EXPECT_EQ(stage.drawn, (std::vector<std::size_t>{5}));
  EXPECT_EQ(stage.too_far, 5U);
}

TEST(SvgStage, is_there_for_an_empty_scene_too) {
  EXPECT_GT(stage_of(Scene<2, double>()).frame.scale, 0);
  EXPECT_GT(stage_of(Scene<3, double>()).frame.scale, 0);
  Scene<3, double> scene;
  scene.add(Compound<3, double>{});
  EXPECT_EQ(stage_of(scene).drawn.size(), 1U);
}

TEST(SvgStage, frames_space_by_what_is_seen_of_it) {
  Scene<3, double> scene;
  scene.add(Sphere<3, double>{{0, 0, 0}, 2});
  const Stage<3> stage = stage_of(scene);
  const Aabb<2, double> box = picture_box(stage, scene.object(scene.ids()[0]).shape);
  EXPECT_NEAR(box.max.y - box.min.y, stage.frame.card.max.y - stage.frame.card.min.y - 2 * card_padding, 1e-9);
}

TEST(SvgStage, draws_of_a_half_space_in_space_its_boundary_only) {
  Scene<3, double> scene;
  scene.add(Aabb<3, double>{{-1, -1, 0}, {1, 1, 2}});
  scene.add(HalfSpace<3, double>{{0, 0, 1}, 0});
  const Stage<3> stage = stage_of(scene);
  // The box extends 1 from its center; the sheet 1.15 times as far, that is sqrt(2) * 1.15 to each side.
  const Aabb<2, double> floor = box_around(outline_on(stage, HalfSpace<3, double>{{0, 0, 1}, 0}));
  EXPECT_NEAR(floor.max.x, std::sqrt(2.0) * 1.15, 1e-12);
  EXPECT_NEAR(floor.max.y, std::sqrt(2.0 / 3.0) * 1.15, 1e-12);
  EXPECT_NEAR(floor.min.y, -std::sqrt(2.0 / 3.0) * 1.15, 1e-12);
}

TEST(SvgStage, visits_the_parts_of_compounds_at_all_depths) {
  const auto inner = compound_of<2, double>({Vec<2, double>(1, 1), Sphere<2, double>{}});
  const AnyShape<2, double> outer = compound_of<2, double>({inner, Vec<2, double>(2, 2)});
  int parts = 0;
  for_each_part<2>(outer, [&parts](const auto&) { ++parts; });
  EXPECT_EQ(parts, 3);
}

}  // namespace
}  // namespace graze::io::svg::svg_stage_test
