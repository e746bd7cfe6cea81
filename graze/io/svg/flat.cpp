// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <type_traits>
#include <variant>
#include <vector>

#include <graze/io/svg/flat.hpp>
#include <graze/io/svg/object.hpp>
#include <graze/io/svg/pen.hpp>
#include <graze/query/union_outline.hpp>

namespace graze::io::svg {
namespace {

/// Draws one part.
struct FlatBrush {
  const Stage<2>& stage;
  Pen& pen;

  void operator()(const Aabb<2, double>& box) const {
    pen.rectangle({seen(box.min, stage.view), seen(box.max, stage.view)});
  }

  void operator()(const Ray<2, double>& ray) const {
    const auto piece = cut(ray, stage.box);
    if (piece) pen.arrow(seen(piece->start, stage.view), seen(piece->end, stage.view));
  }

  void operator()(const HalfSpace<2, double>& solid) const {
    pen.outline(outline_on(stage, solid), "ground");
    const std::vector<Vec<2, double>> edge = cut(boundary(solid), stage.box);
    if (edge.size() == 2) pen.line(seen(edge[0], stage.view), seen(edge[1], stage.view));
  }

  void operator()(const auto& part) const { pen.outline(outline_on(stage, part)); }
};

template <class S>
inline constexpr bool is_polygon = std::is_same_v<S, Aabb<2, double>> || std::is_same_v<S, Obb<2, double>> ||
                                   std::is_same_v<S, Triangle<2, double>> || std::is_same_v<S, Polytope<2, double>>;

/// Draws a shape. The polygons of a compound or a mesh are drawn as their union, so that a concave polygon shows no
/// cuts.
void draw(const AnyShape<2, double>& shape, const FlatBrush& brush) {
  const bool has_parts =
      std::holds_alternative<Compound<2, double>>(shape) || std::holds_alternative<Mesh<2, double>>(shape);
  if (!has_parts) return for_each_part<2>(shape, brush);
  std::vector<std::vector<Vec<2, double>>> polygons;
  for_each_part<2>(shape, [&]<class S>(const S& part) {
    if constexpr (is_polygon<S>) {
      Outline outline = outline_on(brush.stage, part);
      if (outline.core.size() > 2) polygons.push_back(std::move(outline.core));
    }
  });
  brush.pen.area(union_outline(polygons));
  for_each_part<2>(shape, [&]<class S>(const S& part) {
    if constexpr (is_polygon<S>) {
      if (outline_on(brush.stage, part).core.size() > 2) return;
    }
    brush(part);
  });
}

/// The area of a shape's box; infinite for an unbounded shape. An empty compound counts as unbounded; it is invisible.
double size(const Object<2, double>& object) {
  const Vec<2, double> extent = object.box.max - object.box.min;
  const bool unbounded = !(max_abs(extent) <= std::numeric_limits<double>::max());
  return unbounded ? std::numeric_limits<double>::infinity() : extent.x * extent.y;
}

std::vector<std::size_t> from_large_to_small(const Subject<2>& subject, std::vector<std::size_t> positions) {
  std::vector<double> sizes(subject.objects.size());
  for (const std::size_t position : positions) sizes[position] = size(*subject.objects[position]);
  std::stable_sort(positions.begin(), positions.end(),
                   [&sizes](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  return positions;
}

}  // namespace

std::string paint_flat(const Subject<2>& subject, const Stage<2>& stage, const Detail& detail) {
  Pen pen(stage.frame, detail.mark_size);
  std::string svg;
  for (const std::size_t position : from_large_to_small(subject, stage.drawn)) {
    draw(subject.objects[position]->shape, FlatBrush{stage, pen});
    svg += object_element(subject, position, detail, pen);
  }
  return svg;
}

}  // namespace graze::io::svg
