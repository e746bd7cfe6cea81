// SPDX-License-Identifier: MIT
#include "hull_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <graze/query/convex/growing_hull.hpp>
#include <graze/query/outline.hpp>

namespace graze::wasm {
namespace {

using Point = Vec<3, double>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// The common edge of two triangles is not drawn if the angle between their normals is below a tenth of a degree, so
/// that its cosine is larger than this.
constexpr double flat_cosine = 1 - 1.5e-6;

/// Hulls thinner than this fraction of their size are drawn flat.
constexpr double flat_share = 1e-9;

struct Face {
  std::array<std::uint32_t, 3> corners;
  Point normal;  // of length 1, outward
};

/// An incremental convex hull: the faces that a new point sees are replaced by a cone of faces from their border.
class HullSurface {
 public:
  explicit HullSurface(std::span<const Point> points) : points_(points) {
    const auto start = tetrahedron();
    if (!start) return;
    const auto& [a, b, c, d] = *start;
    for (const auto& face : {std::array{a, b, c}, std::array{a, c, d}, std::array{a, d, b}, std::array{b, d, c}}) {
      add_face(face[0], face[1], face[2]);
    }
    for (std::uint32_t i = 0; i < points_.size(); ++i) grow(i);
  }

  /// None if the points are coplanar.
  const std::vector<Face>& faces() const { return faces_; }

  /// The normal of coplanar points; zero if they are collinear.
  const Point& flat_normal() const { return flat_normal_; }

 private:
  /// The point with the largest value of a measure.
  template <class Measure>
  std::uint32_t farthest(const Measure& measure) const {
    const auto less = [&](const Point& p, const Point& q) { return measure(p) < measure(q); };
    return static_cast<std::uint32_t>(std::max_element(points_.begin(), points_.end(), less) - points_.begin());
  }

  /// Four points far from each other; the last is behind the triangle of the first three.
  std::optional<std::array<std::uint32_t, 4>> tetrahedron() {
    const std::uint32_t a = 0;
    const auto from_a = [&](const Point& p) { return p - points_[a]; };
    const std::uint32_t b = farthest([&](const Point& p) { return dot(from_a(p), from_a(p)); });
    const Point edge = from_a(points_[b]);
    const double size = std::sqrt(dot(edge, edge));
    const auto beside = [&](const Point& p) { return cross(edge, from_a(p)); };
    const std::uint32_t c = farthest([&](const Point& p) { return dot(beside(p), beside(p)); });
    const Point normal = beside(points_[c]);
    const double area = std::sqrt(dot(normal, normal));
    if (!(area > flat_share * size * size)) return std::nullopt;
    flat_normal_ = normal / area;
    const auto height = [&](const Point& p) { return dot(flat_normal_, from_a(p)); };
    const std::uint32_t d = farthest([&](const Point& p) { return std::fabs(height(p)); });
    if (!(std::fabs(height(points_[d])) > flat_share * size)) return std::nullopt;
    return height(points_[d]) < 0 ? std::array{a, b, c, d} : std::array{a, c, b, d};
  }

  void add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Point normal = cross(points_[b] - points_[a], points_[c] - points_[a]);
    const double size = std::sqrt(dot(normal, normal));
    faces_.push_back({{a, b, c}, size > 0 ? normal / size : Point(0.0)});
  }

  void grow(std::uint32_t added) {
    const auto is_hidden = [&](const Face& face) {
      return !(dot(face.normal, points_[added] - points_[face.corners[0]]) > 0) || holds(face, added);
    };
    const auto seen = std::stable_partition(faces_.begin(), faces_.end(), is_hidden);
    std::vector<Edge> edges;
    for (auto face = seen; face != faces_.end(); ++face) {
      for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(face->corners[i], face->corners[(i + 1) % 3]);
    }
    faces_.erase(seen, faces_.end());
    for (const auto& [from, to] : edges) {
      const bool is_inner = std::find(edges.begin(), edges.end(), Edge{to, from}) != edges.end();
      if (!is_inner) add_face(from, to, added);
    }
  }

  static bool holds(const Face& face, std::uint32_t corner) {
    return std::find(face.corners.begin(), face.corners.end(), corner) != face.corners.end();
  }

  std::span<const Point> points_;
  std::vector<Face> faces_;
  Point flat_normal_ = Point(0.0);
};

/// Draws the edges at which the surface bends, each once.
void add_edges(Drawing<3>& drawing, const std::vector<Face>& faces, const std::vector<std::uint32_t>& places) {
  std::map<Edge, Point> normals;
  for (const Face& face : faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      normals.emplace(Edge{face.corners[i], face.corners[(i + 1) % 3]}, face.normal);
    }
  }
  for (const auto& [edge, normal] : normals) {
    const auto other = normals.find({edge.second, edge.first});
    if (edge.first > edge.second || other == normals.end()) continue;
    if (dot(normal, other->second) > flat_cosine) continue;
    drawing.lines.insert(drawing.lines.end(), {places[edge.first], places[edge.second]});
  }
}

}  // namespace

void add_flat_hull(Drawing<3>& drawing, std::span<const Point> points, const Point& normal) {
  if (points.empty()) return;
  const Point up = normal / std::sqrt(dot(normal, normal));
  detail::Frame<3> frame;
  frame.add(up, 0);
  View<3> view;
  view.right = frame.across();
  view.up = cross(up, view.right);
  std::vector<Point> around(points.begin(), points.end());
  for (Point& point : around) point -= points.front();  // so that the plane contains the origin
  const Outline polygon = outline_of_hull<3>(around, view);
  std::vector<std::uint32_t> places;
  for (const Vec<2, double>& corner : polygon.core) {
    places.push_back(drawing.add(points.front() + view.right * corner.x + view.up * corner.y));
  }
  for (std::size_t i = 0; i < places.size() && places.size() > 1; ++i) {
    if (i > 1) drawing.triangles.insert(drawing.triangles.end(), {places[0], places[i - 1], places[i]});
    if (i + 1 == places.size() && i == 1) continue;  // the return path of a single line
    drawing.lines.insert(drawing.lines.end(), {places[i], places[(i + 1) % places.size()]});
  }
}

void add_hull(Drawing<3>& drawing, std::span<const Point> points) {
  const HullSurface hull(points);
  if (hull.faces().empty()) {
    const Point& normal = hull.flat_normal();
    if (dot(normal, normal) > 0) return add_flat_hull(drawing, points, normal);
    const auto [first, last] =
        std::minmax_element(points.begin(), points.end(), detail::lexicographically_less<3, double>);
    const std::uint32_t from = drawing.add(*first);
    if (*first != *last) drawing.lines.insert(drawing.lines.end(), {from, drawing.add(*last)});
    return;
  }
  std::vector<std::uint32_t> places;
  for (const Point& point : points) places.push_back(drawing.add(point));
  for (const Face& face : hull.faces()) {
    for (const std::uint32_t corner : face.corners) drawing.triangles.push_back(places[corner]);
  }
  add_edges(drawing, hull.faces(), places);
}

}  // namespace graze::wasm
