// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <graze/io/svg/depth.hpp>
#include <graze/io/svg/object.hpp>
#include <graze/io/svg/pen.hpp>
#include <graze/io/svg/solid.hpp>
#include <graze/query/bounds.hpp>
#include <graze/shape/shape.hpp>

namespace graze::io::svg {
namespace {

/// The direction towards the light: above, from the viewer's left.
const Vec<3, double> light = normalize(Vec<3, double>(0.25, -0.62, 0.9));

/// The grid of a sheet has at least this many lines along its longer side, and at most two and a half times as many.
constexpr double least_grid_lines = 6;

/// The shade of a face; the normal has any length and points towards the viewer.
std::string shade(const Vec<3, double>& normal) {
  const double size = std::sqrt(dot(normal, normal));
  const double brightness = size > 0 ? std::max(0.0, dot(normal, light) / size) : 0.0;
  return fmt::format("l{}", std::min(shades - 1, static_cast<int>(brightness * shades)));
}

/// The axis that a plane is perpendicular to, if there is one.
std::optional<Dim> axis_of(const Plane<3, double>& plane) {
  std::optional<Dim> axis;
  for (Dim i = 0; i < 3; ++i) {
    if (plane.normal[i] == 0) continue;
    if (axis) return std::nullopt;
    axis = i;
  }
  return axis;
}

/// The ends of grid lines, at round distances, on the sheet where a plane perpendicular to `axis` crosses a box.
std::vector<Vec<3, double>> grid(const Plane<3, double>& plane, Dim axis, const Aabb<3, double>& box) {
  std::vector<Vec<3, double>> ends;
  const double height = plane.offset / plane.normal[axis];  // not zero: the plane is perpendicular to `axis`
  const double step = round_length(2 * max_abs(box.half_extents()) / least_grid_lines);
  for (const Dim across : {(axis + 1) % 3, (axis + 2) % 3}) {
    const double first = std::ceil(box.min[across] / step);
    const double count = std::floor(box.max[across] / step) - first;
    for (double i = 0; i <= std::min(count, 3 * least_grid_lines); ++i) {
      Vec<3, double> from = box.min;
      Vec<3, double> to = box.max;
      from[axis] = to[axis] = height;
      from[across] = to[across] = std::clamp((first + i) * step, box.min[across], box.max[across]);
      ends.insert(ends.end(), {from, to});
    }
  }
  return ends;
}

/// Draws one part.
struct SolidBrush {
  const Stage<3>& stage;
  const Detail& detail;
  bool patterned;  ///< In a pair, and drawn with that pair's pattern.
  Pen& pen;

  void operator()(const Ray<3, double>& ray) const {
    const auto piece = cut(ray, stage.box);
    if (piece) pen.arrow(seen(piece->start, stage.view), seen(piece->end, stage.view));
  }

  void operator()(const Vec<3, double>& point) const { pen.mark(seen(point, stage.view)); }
  void operator()(const Segment<3, double>& segment) const { pen.outline(outline(segment, stage.view)); }
  void operator()(const Sphere<3, double>& sphere) const { body(outline(sphere, stage.view), "sphere"); }
  void operator()(const Aabb<3, double>& box) const { (*this)(oriented(box)); }
  void operator()(const Plane<3, double>& plane) const { sheet(plane); }
  void operator()(const HalfSpace<3, double>& solid) const { sheet(boundary(solid)); }
  template <Convex S>
  void operator()(const S& shape) const {
    body(outline(shape, stage.view));
  }

  void operator()(const Triangle<3, double>& triangle) const {
    const Vec<3, double> normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const bool faces_viewer = dot(normal, to_viewer(stage.view)) >= 0;
    body(outline(triangle, stage.view), shade(faces_viewer ? normal : -normal));
  }

  void operator()(const Obb<3, double>& box) const {
    const Outline silhouette = outline(box, stage.view);
    if (!detail.faces) return pen.outline(silhouette, "l3");
    const Mat<3, double> edges = half_edges(box);
    for (Dim i = 0; i < 3; ++i) {
      const double facing = dot(box.axes[i], to_viewer(stage.view));
      if (facing == 0) continue;  // seen edge-on
      const double side = facing > 0 ? 1.0 : -1.0;
      const Vec<3, double> middle = box.center + edges[i] * side;
      const Vec<3, double> u = edges[(i + 1) % 3];
      const Vec<3, double> v = edges[(i + 2) % 3];
      const std::array corners = {middle - u - v, middle + u - v, middle + u + v, middle - u + v};
      pen.outline(outline_of_hull<3>(corners, stage.view), shade(box.axes[i] * side));
    }
    if (patterned) pen.outline(silhouette, "pattern");
  }

  void body(const Outline& silhouette, std::string_view style = {}) const {
    pen.outline(silhouette, style);
    const bool has_area = silhouette.core.size() > 2 || silhouette.radius > 0;
    if (patterned && has_area) pen.outline(silhouette, "pattern");
  }

  void sheet(const Plane<3, double>& plane) const {
    pen.outline(outline(plane, stage.view, stage.box), "sheet");
    const std::optional<Dim> axis = axis_of(plane);
    if (!axis) return;
    std::vector<Vec<2, double>> ends;
    for (const Vec<3, double>& end : grid(plane, *axis, stage.box)) ends.push_back(seen(end, stage.view));
    pen.lines(ends, "grid");
  }
};

/// What determines the painting order of a shape: for a ray its drawn part, for a compound with planes the first plane.
Layered layered(const AnyShape<3, double>& shape, const Stage<3>& stage) {
  Layered thing{Aabb<3, double>::nothing(), std::nullopt};
  for_each_part<3>(shape, [&]<class S>(const S& part) {
    std::vector<Vec<3, double>> corners;
    if constexpr (std::is_same_v<S, Ray<3, double>>) {
      if (const auto piece = cut(part, stage.box)) corners = {piece->start, piece->end};
    } else if constexpr (std::is_same_v<S, Plane<3, double>>) {
      corners = cut(part, stage.box);
      if (!thing.sheet) thing.sheet = part;
    } else if constexpr (std::is_same_v<S, HalfSpace<3, double>>) {
      corners = cut(boundary(part), stage.box);
      if (!thing.sheet) thing.sheet = boundary(part);
    } else {
      thing.box.grow(bounds(part));
    }
    for (const Vec<3, double>& corner : corners) thing.box.grow(corner);
  });
  if (!(thing.box.min.x <= thing.box.max.x)) thing.box = {stage.box.center(), stage.box.center()};
  return thing;
}

/// Draws the parts of a shape from back to front.
void draw(const AnyShape<3, double>& shape, const Stage<3>& stage, const SolidBrush& brush) {
  std::vector<AnyShape<3, double>> parts;
  std::vector<Layered> things;
  for_each_part<3>(shape, [&](const auto& part) {
    parts.emplace_back(part);
    things.push_back(layered(parts.back(), stage));
  });
  for (const std::size_t part : back_to_front(things, stage.view)) for_each_part<3>(parts[part], brush);
}

}  // namespace

std::string paint_solid(const Subject<3>& subject, const Stage<3>& stage, const Detail& detail) {
  std::vector<Layered> things;
  things.reserve(stage.drawn.size());
  for (const std::size_t position : stage.drawn) things.push_back(layered(subject.objects[position]->shape, stage));
  Pen pen(stage.frame, detail.mark_size);
  std::string svg;
  for (const std::size_t next : back_to_front(things, stage.view)) {
    const std::size_t position = stage.drawn[next];
    const bool patterned = detail.patterns && subject.touches[position].closest != Relation::apart;
    const SolidBrush brush{stage, detail, patterned, pen};
    draw(subject.objects[position]->shape, stage, brush);
    svg += object_element(subject, position, detail, pen);
  }
  return svg;
}

}  // namespace graze::io::svg
