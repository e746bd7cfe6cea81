// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <graze/io/tiled/shapes.hpp>
#include <graze/math/pose.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/filled_parts.hpp>
#include <graze/query/transformed.hpp>

namespace graze::io {
namespace {

using Point = Vec<2, double>;
using Shape = AnyShape<2, double>;

/// The object's box before it is rotated about its anchor, which is the origin here. A tile's drawing offset scales
/// with its image.
Aabb<2, double> upright_box(const TiledResolvedObject& resolved, const TiledAlignment& usual_alignment) {
  const TiledObject& object = resolved.object;
  const Point size(object.width.value_or(0), object.height.value_or(0));
  if (!resolved.tile) return {Point(0.0), size};
  const TiledTileset& tileset = *resolved.tile->tileset;
  const Point picture = tiled_picture_size(*resolved.tile);
  Point offset = tileset.drawing_offset;
  if (picture.x > 0) offset.x *= size.x / picture.x;
  if (picture.y > 0) offset.y *= size.y / picture.y;
  const Point min = offset - tileset.alignment.value_or(usual_alignment).fraction * size;
  return {min, min + size};
}

bool is_along_axes(const Mat<2, double>& linear) {
  return (linear[0].y == 0 && linear[1].x == 0) || (linear[0].x == 0 && linear[1].y == 0);
}

bool is_mirrored(const Mat<2, double>& linear) { return linear[0].x * linear[1].y - linear[0].y * linear[1].x < 0; }

/// The convex polygon of these corners; a segment or point if they span no area.
Shape convex_shape(const std::vector<Point>& corners) {
  const auto flat = detail::ends_of_2d<double>(corners);
  if (!flat) return convex_hull<2, double>(corners);
  if (flat->size() == 1) return flat->front();
  return Segment<2, double>{flat->front(), flat->back()};
}

Shape rectangle(const Aabb<2, double>& box, const TiledFrame& frame) {
  if (box.min == box.max) return frame.at(box.min);
  if (is_along_axes(frame.linear)) return Aabb<2, double>::from_corners(frame.at(box.min), frame.at(box.max));
  if (frame.scale == 1.0 && !is_mirrored(frame.linear)) {
    return transformed(box, Pose<2, double>{frame.linear, frame.origin});
  }
  const Point size = box.max - box.min;
  return convex_shape({frame.at(box.min), frame.at(box.min + Point(size.x, 0.0)), frame.at(box.max),
                       frame.at(box.min + Point(0.0, size.y))});
}

/// A polygon with corners on the outline of a box with round ends: `reach` is the vector from the center to the centers
/// of the ends, `radii` are those of the ends.
Shape rounded(const Point& center, const Point& reach, const Point& radii, const TiledFrame& frame) {
  std::vector<Point> rim;
  rim.reserve(std::size_t{2} * tiled_ellipse_corners);
  for (int i = 0; i < tiled_ellipse_corners; ++i) {
    const Point direction = cosine_sine_of_degrees(360.0 * i / tiled_ellipse_corners);
    rim.push_back(frame.at(center + reach + direction * radii));
    if (reach != Point(0.0)) rim.push_back(frame.at(center - reach + direction * radii));
  }
  return convex_hull<2, double>(rim);
}

/// A disc, a polygon with corners on the ellipse, or a segment if the area is zero.
TiledShape ellipse(const Aabb<2, double>& box, const TiledFrame& frame) {
  const Point size = box.max - box.min;
  if (size.x == 0 || size.y == 0) return {Segment<2, double>{frame.at(box.min), frame.at(box.max)}};
  if (size.x == size.y && frame.scale) {
    return {Sphere<2, double>{frame.at(box.center()), size.x / 2 * *frame.scale}};
  }
  return {rounded(box.center(), Point(0.0), box.half_extents(), frame), tiled_omission::ellipse};
}

/// The capsule that fills the box: its round ends touch the short sides.
TiledShape capsule(const Aabb<2, double>& box, const TiledFrame& frame) {
  const Point size = box.max - box.min;
  const double radius = std::min(size.x, size.y) / 2;
  const Point center = box.center();
  const Point reach(size.x / 2 - radius, size.y / 2 - radius);
  if (!frame.scale && radius > 0) return {rounded(center, reach, Point(radius), frame), tiled_omission::capsule};
  if (!frame.scale) return {Segment<2, double>{frame.at(box.min), frame.at(box.max)}};
  if (size.x == size.y) return {Sphere<2, double>{frame.at(center), radius * *frame.scale}};
  return {Capsule<2, double>{frame.at(Point(center - reach)), frame.at(Point(center + reach)), radius * *frame.scale}};
}

Shape polyline(const std::vector<Point>& points, const TiledFrame& frame) {
  std::vector<Shape> edges;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i] == points[i - 1]) continue;
    edges.emplace_back(Segment<2, double>{frame.at(points[i - 1]), frame.at(points[i])});
  }
  if (edges.empty()) return frame.at(points.front());
  if (edges.size() == 1) return edges.front();
  return compound_of<2, double>(std::move(edges));
}

/// A convex polygon as returned by convex_parts; a point or segment if it has too few corners.
Shape convex_part(const std::vector<Point>& corners, const TiledFrame& frame) {
  if (corners.size() == 1) return frame.at(corners[0]);
  if (corners.size() == 2) return Segment<2, double>{frame.at(corners[0]), frame.at(corners[1])};
  std::vector<Point> moved;
  moved.reserve(corners.size());
  for (const Point& corner : corners) moved.push_back(frame.at(corner));
  return convex_hull<2, double>(moved);
}

TiledShape polygon(const std::vector<Point>& points, const TiledFrame& frame) {
  if (points.size() > max_tiled_polygon_corners) return {std::nullopt, tiled_omission::large_polygon};
  static_assert(max_tiled_polygon_corners == 10'000);
  const auto parts = filled_parts<double>(points);
  if (!parts) return {std::nullopt, tiled_omission::wild_polygon};
  std::vector<Shape> shapes;
  for (const std::vector<Point>& part : *parts) shapes.push_back(convex_part(part, frame));
  if (shapes.size() == 1) return {std::move(shapes.front())};
  return {compound_of<2, double>(std::move(shapes))};
}

/// The shape of an object in `box`, or of its points, relative to the position that `frame` maps from the origin.
TiledShape outlined(const TiledObject& object, const Aabb<2, double>& box, const TiledFrame& frame) {
  const bool is_empty = box.min == box.max;
  switch (object.outline.value_or(TiledOutline::rectangle)) {
    case TiledOutline::rectangle:
      return {rectangle(box, frame)};
    case TiledOutline::point:
      return {Shape(frame.origin)};
    case TiledOutline::ellipse:
      return is_empty ? TiledShape{Shape(frame.origin)} : ellipse(box, frame);
    case TiledOutline::capsule:
      return is_empty ? TiledShape{Shape(frame.origin)} : capsule(box, frame);
    case TiledOutline::polygon:
      return polygon(object.points, frame);
    case TiledOutline::polyline:
      return {polyline(object.points, frame)};
    case TiledOutline::text:
      return {std::nullopt, tiled_omission::text_object};
  }
  return {std::nullopt, tiled_omission::unknown_element};
}

/// An object's own frame: rotated about its screen position.
TiledFrame frame_of(const TiledObject& object, const TiledProjection& projection) {
  const Mat<2, double> turn = rotation_matrix(object.rotation.value_or(0));
  const Point place = projection.place({object.x.value_or(0), object.y.value_or(0)});
  if (projection.is_identity()) return {turn, place};
  return {turn * projection.linear(), place, std::nullopt};
}

}  // namespace

TiledFrame operator*(const TiledFrame& outer, const TiledFrame& inner) {
  TiledFrame result{outer.linear * inner.linear, outer.at(inner.origin), std::nullopt};
  if (outer.scale && inner.scale) result.scale = *outer.scale * *inner.scale;
  return result;
}

TiledShape tiled_shape(const TiledResolvedObject& resolved, const TiledPlacing& placing) {
  const TiledObject& object = resolved.object;
  TiledFrame frame = frame_of(object, placing.projection);
  frame.origin += placing.shift;
  const Aabb<2, double> box = upright_box(resolved, placing.alignment);
  if (!resolved.tile) return outlined(object, box, frame);
  return {rectangle(box, {rotation_matrix(object.rotation.value_or(0)), frame.origin})};
}

TiledShape tiled_shape(const TiledObject& object, const TiledProjection& projection, const TiledFrame& frame) {
  const Aabb<2, double> box{Point(0.0), Point(object.width.value_or(0), object.height.value_or(0))};
  return outlined(object, box, frame * frame_of(object, projection));
}

}  // namespace graze::io
