// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/tiled/shapes.hpp>
#include <graze/query/bounds.hpp>

namespace graze::io::tiled_shapes_test {
namespace {

using Point = Vec<2, double>;
using Box = Aabb<2, double>;

TiledObject object_at(double x, double y, double width, double height, double rotation = 0) {
  TiledObject object;
  object.x = x;
  object.y = y;
  object.width = width;
  object.height = height;
  object.rotation = rotation;
  return object;
}

const TiledProjection& orthogonal() {
  static const TiledProjection projection{TiledGrid{}};
  return projection;
}

/// Ten by ten cells of 64 x 32: pixel (x, y) is drawn at (x - y + 320, (x + y) / 2).
const TiledProjection& isometric() {
  static const TiledProjection projection = [] {
    TiledGrid grid;
    grid.orientation = "isometric";
    grid.height = 10;
    grid.tile_width = 64;
    grid.tile_height = 32;
    return TiledProjection(grid);
  }();
  return projection;
}

TiledShape shape_of(const TiledObject& object, const Point& shift = {0.0, 0.0}) {
  return tiled_shape({object, std::nullopt}, {orthogonal(), shift, {}});
}

TiledShape outlined(TiledOutline outline, TiledObject object) {
  object.outline = outline;
  return shape_of(object);
}

TiledShape with_points(TiledOutline outline, std::vector<Point> points, double rotation = 0) {
  TiledObject object = object_at(100, 200, 0, 0, rotation);
  object.outline = outline;
  object.points = std::move(points);
  return shape_of(object);
}

/// The shape, which must have this type.
template <class Shape>
Shape as(const TiledShape& read) {
  EXPECT_TRUE(read.shape && std::holds_alternative<Shape>(*read.shape))
      << "another type, or none: " << read.omission.what;
  return read.shape && std::holds_alternative<Shape>(*read.shape) ? std::get<Shape>(*read.shape) : Shape{};
}

/// The box of an object that shows a tile, 4 wide and 2 high, anchored at (10, 20).
Box tile_box(std::optional<std::string> alignment, double rotation, const char* usual = "bottomleft") {
  TiledTileset tileset;
  if (alignment) tileset.alignment = tiled_alignment(*alignment);
  return as<Box>(tiled_shape({object_at(10, 20, 4, 2, rotation), TiledTileUse{&tileset, nullptr}},
                             {orthogonal(), {0.0, 0.0}, *tiled_alignment(usual)}));
}

TEST(TiledShapes, AnchorsARectangleAtItsTopLeft) {
  EXPECT_EQ(as<Box>(shape_of(object_at(10, 20, 4, 2))), (Box{{10, 20}, {14, 22}}));
  EXPECT_EQ(as<Box>(shape_of(object_at(10, 20, 4, 2), {-3, 0.5})), (Box{{7, 20.5}, {11, 22.5}}));
}

TEST(TiledShapes, TurnsARectangleClockwiseAboutItsAnchor) {
  EXPECT_EQ(as<Box>(shape_of(object_at(10, 20, 4, 2, 90))), (Box{{8, 20}, {10, 24}}));
  EXPECT_EQ(as<Box>(shape_of(object_at(10, 20, 4, 2, 180))), (Box{{6, 18}, {10, 20}}));
  EXPECT_EQ(as<Box>(shape_of(object_at(10, 20, 4, 2, -90))), (Box{{10, 16}, {12, 20}}));
  EXPECT_EQ(as<Box>(shape_of(object_at(10, 20, 4, 2, -270))), (Box{{8, 20}, {10, 24}}));
  EXPECT_EQ(as<Box>(shape_of(object_at(10, 20, 4, 2, 720))), (Box{{10, 20}, {14, 22}}));
}

TEST(TiledShapes, KeepsTheCoordinatesOfAQuarterTurnExact) {
  const Box box = as<Box>(shape_of(object_at(0, 0, 0.1, 0.7, 90)));
  EXPECT_EQ(box, (Box{{-0.7, 0}, {0, 0.1}}));
}

TEST(TiledShapes, MakesAnObliqueRectangleAnOrientedBox) {
  const auto box = as<Obb<2, double>>(shape_of(object_at(10, 20, 4, 2, 30)));
  const double c = std::sqrt(3.0) / 2;
  EXPECT_NEAR(box.center.x, 10 + 2 * c - 1 * 0.5, 1e-14);
  EXPECT_NEAR(box.center.y, 20 + 2 * 0.5 + 1 * c, 1e-14);
  EXPECT_EQ(box.half_extents, Point(2, 1));
  EXPECT_NEAR(box.axes[0].x, c, 1e-15);
  EXPECT_NEAR(box.axes[0].y, 0.5, 1e-15) << "clockwise as one sees it: down when y points down";
}

TEST(TiledShapes, AnchorsATileAtItsBottomLeftUnlessTheTilesetSaysOtherwise) {
  EXPECT_EQ(tile_box(std::nullopt, 0), (Box{{10, 18}, {14, 20}}));
  EXPECT_EQ(tile_box(std::nullopt, 0, "bottom"), (Box{{8, 18}, {12, 20}})) << "isometric maps";
  EXPECT_EQ(tile_box("topleft", 0), (Box{{10, 20}, {14, 22}}));
  EXPECT_EQ(tile_box("top", 0), (Box{{8, 20}, {12, 22}}));
  EXPECT_EQ(tile_box("topright", 0), (Box{{6, 20}, {10, 22}}));
  EXPECT_EQ(tile_box("left", 0), (Box{{10, 19}, {14, 21}}));
  EXPECT_EQ(tile_box("center", 0), (Box{{8, 19}, {12, 21}}));
  EXPECT_EQ(tile_box("right", 0), (Box{{6, 19}, {10, 21}}));
  EXPECT_EQ(tile_box("bottomleft", 0, "bottom"), (Box{{10, 18}, {14, 20}}));
  EXPECT_EQ(tile_box("bottom", 0), (Box{{8, 18}, {12, 20}}));
  EXPECT_EQ(tile_box("bottomright", 0), (Box{{6, 18}, {10, 20}}));
}

TEST(TiledShapes, TurnsATileAboutItsAnchor) {
  EXPECT_EQ(tile_box(std::nullopt, 90), (Box{{10, 20}, {12, 24}}));
  EXPECT_EQ(tile_box(std::nullopt, -90), (Box{{8, 16}, {10, 20}}));
  EXPECT_EQ(tile_box("center", 90), (Box{{9, 18}, {11, 22}}));
  EXPECT_EQ(tile_box("topright", 180), (Box{{10, 18}, {14, 20}}));
}

TEST(TiledShapes, TakesARectangleWithoutSizeForAPoint) {
  EXPECT_EQ(as<Point>(shape_of(object_at(10, 20, 0, 0, 33))), Point(10, 20));
  EXPECT_EQ(as<Point>(shape_of({}, {3, 4})), Point(3, 4));
  EXPECT_EQ(as<Box>(shape_of(object_at(10, 20, 0, 5))), (Box{{10, 20}, {10, 25}})) << "flat, but not a point";
}

TEST(TiledShapes, ReadsPointsWhereTheyStand) {
  EXPECT_EQ(as<Point>(outlined(TiledOutline::point, object_at(10, 20, 8, 8, 45))), Point(10, 20));
}

TEST(TiledShapes, MakesARoundEllipseADisc) {
  const auto disc = as<Sphere<2, double>>(outlined(TiledOutline::ellipse, object_at(10, 20, 6, 6, 90)));
  EXPECT_EQ(disc.center, Point(7, 23));
  EXPECT_EQ(disc.radius, 3.0);
}

TEST(TiledShapes, InscribesA64GonInALongEllipse) {
  const TiledShape read = outlined(TiledOutline::ellipse, object_at(10, 20, 8, 4, 90));
  EXPECT_EQ(read.omission.what, "ellipse drawn as a 64-gon");
  const auto polygon = as<Polytope<2, double>>(read);
  EXPECT_EQ(polygon.vertices().size(), 64U);
  EXPECT_EQ(bounds(polygon), (Box{{6, 20}, {10, 28}})) << "the ends of both axes are corners";
  for (const Point& corner : polygon.vertices()) {
    const Point unit((corner.x - 8) / 2, (corner.y - 24) / 4);
    EXPECT_NEAR(dot(unit, unit), 1, 1e-14);
  }
}

TEST(TiledShapes, FlattensAnEllipseWithoutAreaExactly) {
  const auto edge = as<Segment<2, double>>(outlined(TiledOutline::ellipse, object_at(10, 20, 8, 0)));
  EXPECT_EQ(edge.start, Point(10, 20));
  EXPECT_EQ(edge.end, Point(18, 20));
  EXPECT_EQ(as<Point>(outlined(TiledOutline::ellipse, object_at(10, 20, 0, 0))), Point(10, 20));
}

TEST(TiledShapes, FitsACapsuleIntoItsBox) {
  const auto lying = as<Capsule<2, double>>(outlined(TiledOutline::capsule, object_at(10, 20, 10, 4)));
  EXPECT_EQ(lying.a, Point(12, 22));
  EXPECT_EQ(lying.b, Point(18, 22));
  EXPECT_EQ(lying.radius, 2.0);
  const auto turned = as<Capsule<2, double>>(outlined(TiledOutline::capsule, object_at(10, 20, 10, 4, 90)));
  EXPECT_EQ(bounds(turned), (Box{{6, 20}, {10, 30}}));
  const auto standing = as<Capsule<2, double>>(outlined(TiledOutline::capsule, object_at(0, 0, 4, 10)));
  EXPECT_EQ(standing.a, Point(2, 2));
  EXPECT_EQ(standing.b, Point(2, 8));
  const auto round = as<Sphere<2, double>>(outlined(TiledOutline::capsule, object_at(0, 0, 4, 4)));
  EXPECT_EQ(round.center, Point(2, 2));
  EXPECT_EQ(round.radius, 2.0);
  EXPECT_EQ(as<Point>(outlined(TiledOutline::capsule, object_at(5, 6, 0, 0))), Point(5, 6));
}

TEST(TiledShapes, KeepsAConvexPolygonWhole) {
  const auto polygon =
      as<Polytope<2, double>>(with_points(TiledOutline::polygon, {{0, 0}, {0, 8}, {8, 8}, {8, 0}}, 90));
  EXPECT_EQ(polygon.vertices().size(), 4U);
  EXPECT_EQ(bounds(polygon), (Box{{92, 200}, {100, 208}}));
}

TEST(TiledShapes, CutsAConcavePolygonIntoConvexParts) {
  const auto l =
      as<Compound<2, double>>(with_points(TiledOutline::polygon, {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}));
  ASSERT_EQ(l.parts.size(), 2U);
  for (const auto& part : l.parts) EXPECT_TRUE((std::holds_alternative<Polytope<2, double>>(part.shape)));
  EXPECT_EQ(bounds(l), (Box{{100, 200}, {104, 204}}));
}

TEST(TiledShapes, FillsAPolygonThatCrossesItself) {
  const TiledShape read = with_points(TiledOutline::polygon, {{0, 0}, {4, 4}, {4, 0}, {0, 4}});
  EXPECT_EQ(read.omission.what, "");
  EXPECT_EQ((as<Compound<2, double>>(read).parts.size()), 2U);
  EXPECT_EQ(bounds(*read.shape), (Box{{100, 200}, {104, 204}}));
}

TEST(TiledShapes, DrawsATileBesideItsPlaceAsTheTilesetSays) {
  TiledTileset tileset;
  tileset.drawing_offset = {3, -1};
  EXPECT_EQ(as<Box>(tiled_shape({object_at(10, 20, 4, 2), TiledTileUse{&tileset, nullptr}}, {orthogonal()})),
            (Box{{13, 17}, {17, 19}}));
  tileset.tile_width = 8;
  tileset.tile_height = 1;
  EXPECT_EQ(as<Box>(tiled_shape({object_at(10, 20, 4, 2), TiledTileUse{&tileset, nullptr}}, {orthogonal()})),
            (Box{{11.5, 16}, {15.5, 18}}))
      << "half as wide as the picture and twice as high";
}

TEST(TiledShapes, StandsTilesUprightOnIsometricMaps) {
  const TiledTileset tileset;
  const TiledPlacing placing{isometric(), {0.0, 0.0}, *tiled_alignment("bottom")};
  const auto box_at = [&](double x, double y, double turn) {
    return as<Box>(tiled_shape({object_at(x, y, 64, 64, turn), TiledTileUse{&tileset, nullptr}}, placing));
  };
  EXPECT_EQ(box_at(100, 100, 0), (Box{{288, 36}, {352, 100}}));
  EXPECT_EQ(box_at(150, 50, 0), (Box{{388, 36}, {452, 100}}));
  EXPECT_EQ(box_at(170, 120, 0), (Box{{338, 81}, {402, 145}}));
  EXPECT_EQ(box_at(100, 100, 90), (Box{{320, 68}, {384, 132}})) << "turned on the screen, about its place";
}

TEST(TiledShapes, ProjectsOtherObjectsOfIsometricMaps) {
  const auto shape_at = [](TiledObject object, std::optional<TiledOutline> outline) {
    object.outline = outline;
    object.points = {{0, 0}, {32, 0}, {32, 32}};
    return tiled_shape({object, std::nullopt}, {isometric(), {1000.0, 0.0}});
  };
  const auto diamond = as<Polytope<2, double>>(shape_at(object_at(32, 0, 32, 32), std::nullopt));
  EXPECT_EQ(diamond.vertices().size(), 4U);
  EXPECT_EQ(bounds(diamond), (Box{{1320, 16}, {1384, 48}})) << "a cell is 64 x 32 on the screen";
  const auto turned = as<Polytope<2, double>>(shape_at(object_at(32, 0, 32, 32, 90), std::nullopt));
  EXPECT_EQ(bounds(turned), (Box{{1320, -16}, {1352, 48}})) << "about (1352, 16), where its place is drawn";
  const auto triangle = as<Polytope<2, double>>(shape_at(object_at(0, 0, 0, 0), TiledOutline::polygon));
  EXPECT_EQ(bounds(triangle), (Box{{1320, 0}, {1352, 32}}));
  EXPECT_EQ(as<Point>(shape_at(object_at(32, 32, 0, 0), TiledOutline::point)), Point(1320, 32));
  const TiledShape disc = shape_at(object_at(0, 0, 32, 32), TiledOutline::ellipse);
  EXPECT_EQ(disc.omission.what, "ellipse drawn as a 64-gon");
  const Box rim = bounds(as<Polytope<2, double>>(disc));
  EXPECT_NEAR(rim.min.x, 1320 - 16 * std::sqrt(2.0), 0.1);
  EXPECT_NEAR(rim.max.y, 16 + 8 * std::sqrt(2.0), 0.1);
  const TiledShape pill = shape_at(object_at(0, 0, 64, 32), TiledOutline::capsule);
  EXPECT_EQ(pill.omission.what, "capsule drawn as a polygon");
  EXPECT_EQ((as<Segment<2, double>>(shape_at(object_at(0, 0, 64, 0), TiledOutline::capsule)).end), Point(1384, 32));
}

TEST(TiledShapes, LeavesOutAPolygonOfTooManyCorners) {
  std::vector<Point> points(max_tiled_polygon_corners + 1, Point(1, 1));
  const TiledShape read = with_points(TiledOutline::polygon, points);
  EXPECT_FALSE(read.shape);
  EXPECT_EQ(read.omission.what, "polygon of more than 10000 corners");
}

TEST(TiledShapes, ReducesAFlatPolygonToASegmentOrPoint) {
  const auto edge = as<Segment<2, double>>(with_points(TiledOutline::polygon, {{0, 0}, {4, 0}}));
  EXPECT_EQ(edge.start, Point(100, 200));
  EXPECT_EQ(edge.end, Point(104, 200));
  EXPECT_EQ(as<Point>(with_points(TiledOutline::polygon, {{1, 1}, {1, 1}, {1, 1}})), Point(101, 201));
}

TEST(TiledShapes, MakesAPolylineItsSegments) {
  const auto edge = as<Segment<2, double>>(with_points(TiledOutline::polyline, {{0, 0}, {0, 0}, {3, 4}}, 90));
  EXPECT_EQ(edge.start, Point(100, 200));
  EXPECT_EQ(edge.end, Point(96, 203));
  const auto path = as<Compound<2, double>>(with_points(TiledOutline::polyline, {{0, 0}, {3, 4}, {6, 0}, {0, 0}}));
  EXPECT_EQ(path.parts.size(), 3U);
  EXPECT_EQ(as<Point>(with_points(TiledOutline::polyline, {{1, 1}, {1, 1}})), Point(101, 201));
}

TEST(TiledShapes, LeavesOutText) {
  const TiledShape read = outlined(TiledOutline::text, object_at(0, 0, 8, 8));
  EXPECT_FALSE(read.shape);
  EXPECT_EQ(read.omission.what, "text object");
}

}  // namespace
}  // namespace graze::io::tiled_shapes_test
