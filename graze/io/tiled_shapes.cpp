// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <graze/io/tiled_shapes.hpp>
#include <graze/math/pose.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/convex_parts.hpp>
#include <graze/query/transformed.hpp>

namespace graze::io {
namespace {

using Point = Vec<2, double>;
using Shape = AnyShape<2, double>;

/// The object's box as it stands before it is turned about its anchor, which is the origin here.
Aabb<2, double> upright_box(const TiledResolvedObject& resolved, const TiledAlignment& usual_alignment) {
  const TiledObject& object = resolved.object;
  const Point size(object.width.value_or(0), object.height.value_or(0));
  if (!resolved.tile) return {Point(0.0), size};
  const Point min = -resolved.tile->tileset->alignment.value_or(usual_alignment).fraction * size;
  return {min, min + size};
}

/// True for turns by a multiple of 90 degrees: their matrices hold only 0, 1 and -1.
bool is_quarter_turn(const Mat<2, double>& rotation) { return rotation[0].x == 0 || rotation[0].y == 0; }

Shape rectangle(const Aabb<2, double>& box, const Pose<2, double>& pose) {
  if (box.min == box.max) return transformed(box.min, pose);
  if (!is_quarter_turn(pose.rotation)) return transformed(box, pose);
  return Aabb<2, double>::from_corners(transformed(box.min, pose), transformed(box.max, pose));
}

/// A disc, a polygon of corners on the rim, or a segment when there is no area.
TiledShape ellipse(const Aabb<2, double>& box, const Pose<2, double>& pose) {
  const Point size = box.max - box.min;
  if (size.x == 0 || size.y == 0)
    return {Segment<2, double>{transformed(box.min, pose), transformed(box.max, pose)}, ""};
  if (size.x == size.y) return {Sphere<2, double>{transformed(box.center(), pose), size.x / 2}, ""};
  std::vector<Point> rim;
  rim.reserve(tiled_ellipse_corners);
  for (int i = 0; i < tiled_ellipse_corners; ++i) {
    const Point direction = cosine_sine_of_degrees(360.0 * i / tiled_ellipse_corners);
    rim.push_back(transformed(box.center() + direction * box.half_extents(), pose));
  }
  static_assert(tiled_ellipse_corners == 64);
  return {convex_hull<2, double>(rim), "ellipse drawn as a 64-gon"};
}

/// The capsule that fills the box: its round ends touch the short sides.
Shape capsule(const Aabb<2, double>& box, const Pose<2, double>& pose) {
  const Point size = box.max - box.min;
  const double radius = std::min(size.x, size.y) / 2;
  const Point center = box.center();
  const Point reach(size.x / 2 - radius, size.y / 2 - radius);
  if (size.x == size.y) return Sphere<2, double>{transformed(center, pose), radius};
  return Capsule<2, double>{transformed(Point(center - reach), pose), transformed(Point(center + reach), pose), radius};
}

Shape polyline(const std::vector<Point>& points, const Pose<2, double>& pose) {
  std::vector<Shape> edges;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i] == points[i - 1]) continue;
    edges.emplace_back(Segment<2, double>{transformed(points[i - 1], pose), transformed(points[i], pose)});
  }
  if (edges.empty()) return transformed(points.front(), pose);
  if (edges.size() == 1) return edges.front();
  return compound_of<2, double>(std::move(edges));
}

/// A convex polygon; a point or segment when it has no more corners than that.
Shape convex_part(const std::vector<Point>& corners, const Pose<2, double>& pose) {
  if (corners.size() == 1) return transformed(corners[0], pose);
  if (corners.size() == 2) return Segment<2, double>{transformed(corners[0], pose), transformed(corners[1], pose)};
  std::vector<Point> moved;
  moved.reserve(corners.size());
  for (const Point& corner : corners) moved.push_back(transformed(corner, pose));
  return convex_hull<2, double>(moved);
}

TiledShape polygon(const std::vector<Point>& points, const Pose<2, double>& pose) {
  if (points.size() > max_tiled_polygon_corners) return {std::nullopt, "polygon of more than 10000 corners"};
  static_assert(max_tiled_polygon_corners == 10'000);
  const auto parts = convex_parts<double>(points);
  if (!parts) return {std::nullopt, "polygon that crosses or touches itself"};
  std::vector<Shape> shapes;
  for (const std::vector<Point>& part : *parts) shapes.push_back(convex_part(part, pose));
  if (shapes.size() == 1) return {std::move(shapes.front()), ""};
  return {compound_of<2, double>(std::move(shapes)), ""};
}

}  // namespace

TiledShape tiled_shape(const TiledResolvedObject& resolved, const Vec<2, double>& shift,
                       const TiledAlignment& alignment) {
  const TiledObject& object = resolved.object;
  const Point anchor(object.x.value_or(0) + shift.x, object.y.value_or(0) + shift.y);
  const Pose<2, double> pose{rotation_matrix(object.rotation.value_or(0)), anchor};
  const Aabb<2, double> box = upright_box(resolved, alignment);
  const bool empty = box.min == box.max;
  if (resolved.tile) return {rectangle(box, pose), ""};
  switch (object.outline.value_or(TiledOutline::rectangle)) {
    case TiledOutline::rectangle:
      return {rectangle(box, pose), ""};
    case TiledOutline::point:
      return {Shape(anchor), ""};
    case TiledOutline::ellipse:
      return empty ? TiledShape{Shape(anchor), ""} : ellipse(box, pose);
    case TiledOutline::capsule:
      return {empty ? Shape(anchor) : capsule(box, pose), ""};
    case TiledOutline::polygon:
      return polygon(object.points, pose);
    case TiledOutline::polyline:
      return {polyline(object.points, pose), ""};
    case TiledOutline::text:
      return {std::nullopt, "text object"};
  }
  return {std::nullopt, "unknown object"};
}

}  // namespace graze::io
