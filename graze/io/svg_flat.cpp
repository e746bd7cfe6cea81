// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <vector>

#include <graze/io/svg_flat.hpp>
#include <graze/io/svg_object.hpp>
#include <graze/io/svg_pen.hpp>

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

/// The area of a shape's box, infinite for an unbounded shape. An empty compound counts as unbounded; it shows nothing.
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
    for_each_part<2>(subject.objects[position]->shape, FlatBrush{stage, pen});
    svg += object_element(subject, position, detail, pen);
  }
  return svg;
}

}  // namespace graze::io::svg
