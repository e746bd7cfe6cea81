// SPDX-License-Identifier: MIT
#include "drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <emscripten/bind.h>

#include <graze/query/convex/growing_hull.hpp>
#include <graze/query/outline.hpp>
#include <graze/query/union_outline.hpp>

#include "arguments.hpp"
#include "bridge.hpp"
#include "hull_surface.hpp"

namespace graze::wasm {
namespace {

using std::numbers::pi;

/// The corners of an outline, with arcs as polylines.
std::vector<Vec<2, double>> corners_of(const Outline& outline, int circle) {
  std::vector<Vec<2, double>> corners;
  const std::size_t count = outline.core.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec<2, double>& corner = outline.core[i];
    if (outline.radius == 0) {
      corners.push_back(corner);
      continue;
    }
    const Vec<2, double> in = corner - outline.core[(i + count - 1) % count];
    const Vec<2, double> out = outline.core[(i + 1) % count] - corner;
    const double first = count == 1 ? 0 : std::atan2(-in.x, in.y);  // angle of the outward normal (y, -x)
    double last = count == 1 ? 2 * pi : std::atan2(-out.x, out.y);
    if (last < first) last += 2 * pi;
    const int steps = std::max(1, static_cast<int>(std::ceil((last - first) / (2 * pi) * circle)));
    for (int k = 0; k < steps + (count == 1 ? 0 : 1); ++k) {
      const double angle = first + (last - first) * k / steps;
      corners.push_back(corner + Vec<2, double>(std::cos(angle), std::sin(angle)) * outline.radius);
    }
  }
  return corners;
}

/// Adds consecutive corners and returns the index of the first.
std::uint32_t add_corners(Drawing<2>& drawing, std::span<const Vec<2, double>> corners) {
  const auto first = static_cast<std::uint32_t>(drawing.corners.size());
  for (const Vec<2, double>& corner : corners) drawing.add(corner);
  return first;
}

/// Adds the area of a convex polygon whose corners are stored from `first` on.
void add_area(Drawing<2>& drawing, std::uint32_t first, std::size_t count) {
  for (std::uint32_t i = 2; i < count; ++i) {
    drawing.triangles.insert(drawing.triangles.end(), {first, first + i - 1, first + i});
  }
}

/// Adds the lines between consecutive corners and back to the first; for two corners one line.
void add_ring(Drawing<2>& drawing, std::uint32_t first, std::size_t corners) {
  const auto count = static_cast<std::uint32_t>(corners);
  const std::uint32_t lines = count < 3 ? count / 2 : count;
  for (std::uint32_t i = 0; i < lines; ++i) {
    drawing.lines.insert(drawing.lines.end(), {first + i, first + (i + 1) % count});
  }
}

/// Adds an outline as one convex polygon.
void add_outline(Drawing<2>& drawing, const Outline& outline, int circle) {
  const std::vector<Vec<2, double>> corners = corners_of(outline, circle);
  const std::uint32_t first = add_corners(drawing, corners);
  add_area(drawing, first, corners.size());
  add_ring(drawing, first, corners.size());
}

/// Adds the union of convex shapes: all areas, and the outline of the union.
void add_joined(Drawing<2>& drawing, std::span<const Outline> outlines, int circle) {
  std::vector<std::vector<Vec<2, double>>> polygons;
  for (const Outline& outline : outlines) {
    std::vector<Vec<2, double>> corners = corners_of(outline, circle);
    const std::uint32_t first = add_corners(drawing, corners);
    add_area(drawing, first, corners.size());
    if (corners.size() < 3) add_ring(drawing, first, corners.size());
    polygons.push_back(std::move(corners));
  }
  for (const std::vector<Vec<2, double>>& way : union_outline(polygons)) {
    add_ring(drawing, add_corners(drawing, way), way.size());
  }
}

/// Adds a sphere whose upper and lower halves are moved apart along `axis` from `a` to `b`: a capsule, or a sphere if
/// both points are equal.
void add_round(Drawing<3>& drawing, const Capsule<3, double>& capsule, int circle) {
  const Vec<3, double> along = capsule.b - capsule.a;
  detail::Frame<3> frame;
  if (!frame.add(along, 0)) frame.add(unit_axis<3>(2), 0);
  const Vec<3, double> right = frame.across();
  frame.add(right, 0);
  const Vec<3, double> up = frame.across();  // at right angles to both, up to its sign
  const Vec<3, double> axis = cross(right, up);
  const bool forward = dot(axis, along) >= 0;
  const int half_rings = std::max(2, circle / 4);
  const int rings = 2 * half_rings + 2;
  const auto first = static_cast<std::uint32_t>(drawing.corners.size());
  for (int ring = 0; ring < rings; ++ring) {
    const bool is_upper = ring > half_rings;
    const double latitude = ((is_upper ? ring - 1 : ring) - half_rings) * pi / 2 / half_rings;
    const Vec<3, double>& center = is_upper == forward ? capsule.b : capsule.a;
    for (int k = 0; k < circle; ++k) {
      const double longitude = 2 * pi * k / circle;
      const Vec<3, double> out = (right * std::cos(longitude) + up * std::sin(longitude)) * std::cos(latitude);
      drawing.add(center + (out + axis * std::sin(latitude)) * capsule.radius);
    }
  }
  for (int ring = 0; ring + 1 < rings; ++ring) {
    for (int k = 0; k < circle; ++k) {
      const auto at = [&](int r, int c) { return first + static_cast<std::uint32_t>(r * circle + c % circle); };
      // The first and the last ring are the poles.
      if (ring > 0) drawing.triangles.insert(drawing.triangles.end(), {at(ring, k), at(ring, k + 1), at(ring + 1, k)});
      if (ring + 2 < rings) {
        drawing.triangles.insert(drawing.triangles.end(), {at(ring, k + 1), at(ring + 1, k + 1), at(ring + 1, k)});
      }
    }
  }
}

/// Adds shapes of one dimension to a drawing.
template <Dim N>
class Brush {
 public:
  Brush(Drawing<N>& drawing, const DrawingOptions<N>& options) : drawing_(drawing), options_(options) {}

  void draw(const AnyShape<N, double>& shape) const {
    std::visit([this](const auto& held) { (*this)(held); }, shape);
  }

  void operator()(const Compound<N, double>& compound) const {
    if constexpr (N == 2) {
      std::vector<Outline> outlines;
      gather(compound, outlines);
      add_joined(drawing_, outlines, options_.circle);
    } else {
      for (const Part<N, double>& part : compound.parts) draw(part.shape);
    }
  }

  void operator()(const Mesh<N, double>& mesh) const {
    std::vector<Outline> outlines;
    for (std::size_t face = 0; face < mesh.faces().size(); ++face) {
      if constexpr (N == 2) {
        outlines.push_back(outline(mesh.triangle(face)));
      } else {
        draw_solid(mesh.triangle(face));
      }
    }
    if constexpr (N == 2) add_joined(drawing_, outlines, options_.circle);
  }

  template <class S>
  void operator()(const S& shape) const {
    if constexpr (is_unbounded<S>) {
      if (options_.within) draw_within(shape, *options_.within);
    } else if constexpr (N == 2) {
      add_outline(drawing_, outline(shape), options_.circle);
    } else {
      draw_solid(shape);
    }
  }

 private:
  template <class S>
  static constexpr bool is_unbounded = std::is_same_v<S, Ray<N, double>> || std::is_same_v<S, Plane<N, double>> ||
                                       std::is_same_v<S, HalfSpace<N, double>>;

  /// Collects the outlines of the bounded parts at all nesting levels; draws the others.
  void gather(const Compound<N, double>& compound, std::vector<Outline>& outlines) const {
    for (const Part<N, double>& part : compound.parts) {
      std::visit(
          [&](const auto& held) {
            using S = std::decay_t<decltype(held)>;
            if constexpr (std::is_same_v<S, Compound<N, double>>) {
              gather(held, outlines);
            } else if constexpr (std::is_same_v<S, Mesh<N, double>>) {
              for (std::size_t face = 0; face < held.faces().size(); ++face) {
                outlines.push_back(outline(held.triangle(face)));
              }
            } else if constexpr (is_unbounded<S>) {
              (*this)(held);
            } else {
              outlines.push_back(outline(held));
            }
          },
          part.shape);
    }
  }

  template <class S>
  void draw_within(const S& shape, const Aabb<N, double>& box) const {
    if constexpr (N == 2) {
      add_outline(drawing_, outline(shape, View<2>(), box), options_.circle);
    } else if constexpr (std::is_same_v<S, Ray<3, double>>) {
      if (const auto piece = cut(shape, box)) draw_solid(*piece);
    } else if constexpr (std::is_same_v<S, Plane<3, double>>) {
      add_flat_hull(drawing_, cut(shape, box), shape.normal);
    } else {
      const Plane<3, double> sheet = boundary(shape);
      add_flat_hull(drawing_, cut(sheet, box), sheet.normal);
    }
  }

  void draw_solid(const Vec<3, double>& point) const { drawing_.add(point); }
  void draw_solid(const Segment<3, double>& s) const { add_hull(drawing_, std::array{s.start, s.end}); }
  void draw_solid(const Triangle<3, double>& t) const { add_hull(drawing_, t_corners(t)); }
  void draw_solid(const Polytope<3, double>& p) const { add_hull(drawing_, p.vertices()); }
  void draw_solid(const Sphere<3, double>& s) const { draw_solid(Capsule<3, double>{s.center, s.center, s.radius}); }
  void draw_solid(const Capsule<3, double>& c) const { add_round(drawing_, c, options_.circle); }
  void draw_solid(const Aabb<3, double>& box) const { draw_box(box); }
  void draw_solid(const Obb<3, double>& box) const { draw_box(box); }

  /// For any other shape the hull of support points in all directions, up to two thousand.
  template <Convex S>
  void draw_solid(const S& shape) const {
    const int circle = std::min(options_.circle, 64);
    std::vector<Vec<3, double>> points;
    for (int ring = 0; 2 * ring <= circle; ++ring) {
      const double polar = 2 * pi * ring / circle;
      const double across = std::sin(polar);
      for (int k = 0; k < circle; ++k) {
        const double angle = 2 * pi * k / circle;
        points.push_back(support(shape, {across * std::cos(angle), across * std::sin(angle), std::cos(polar)}));
      }
    }
    add_hull(drawing_, points);
  }

  template <class Box>
  void draw_box(const Box& box) const {
    std::array<Vec<3, double>, 8> corners;
    for (std::uint32_t i = 0; i < 8; ++i) corners[i] = detail::box_corner(box, i);
    add_hull(drawing_, corners);
  }

  static std::array<Vec<3, double>, 3> t_corners(const Triangle<3, double>& t) { return {t.a, t.b, t.c}; }

  Drawing<N>& drawing_;
  const DrawingOptions<N>& options_;
};

template <Dim N>
Drawing<N> drawn(const AnyShape<N, double>& shape, const DrawingOptions<N>& options) {
  Drawing<N> drawing;
  Brush<N>(drawing, options).draw(shape);
  return drawing;
}

/// The numbers of corners, of triangle corners and of line ends, then all of them. The arguments are the shape and, if
/// it is to be cut off, the box that limits it.
void drawing_answer(int dimension, std::size_t place, bool is_cut, int circle) {
  in_dimension(dimension, [&](auto n) {
    Arguments in(place);
    const AnyShape<n, double> shape = in.shape<n>();
    DrawingOptions<n> options;
    if (is_cut) options.within = std::get<Aabb<n, double>>(in.shape<n>());
    if (circle < 3 || circle > 4096) throw std::invalid_argument("corners: a circle has 3 to 4096 corners");
    options.circle = circle;
    const Drawing<n> drawing = drawing_of(shape, options);
    for (const std::size_t size : {drawing.corners.size(), drawing.triangles.size(), drawing.lines.size()}) {
      answer().push_back(static_cast<double>(size));
    }
    for (const Vec<n, double>& corner : drawing.corners) put<n>(corner);
    answer().insert(answer().end(), drawing.triangles.begin(), drawing.triangles.end());
    answer().insert(answer().end(), drawing.lines.begin(), drawing.lines.end());
  });
}

}  // namespace

Drawing<2> drawing_of(const AnyShape<2, double>& shape, const DrawingOptions<2>& options) {
  return drawn(shape, options);
}
Drawing<3> drawing_of(const AnyShape<3, double>& shape, const DrawingOptions<3>& options) {
  return drawn(shape, options);
}

EMSCRIPTEN_BINDINGS(graze_drawing) { emscripten::function("drawing", &Guarded<&drawing_answer>::call); }

}  // namespace graze::wasm
