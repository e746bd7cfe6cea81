// SPDX-License-Identifier: MIT
// The separating axes of a triangle and a segment, box or triangle, for triangle.hpp.
//
// The Minkowski difference of two such shapes is a polytope. In 2D its edges are those of the two; in 3D its faces are
// parallel to faces of either or to an edge of each. The shapes are apart if and only if the normal of one of these
// separates them, and their depth is the least depth along one (Akenine-Moeller, "Fast 3D Triangle-Box Overlap
// Testing", 2001, has the box). All shapes here are relative to a point near the pair; segments and boxes are centered
// at zero.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

// ---- Properties of a shape for the axes

/// A bound on the absolute coordinates of its points.
template <Dim N>
double extent_around_zero(const Vec<N, double>& point) {
  return max_abs(point);
}
template <Dim N>
double extent_around_zero(const Segment<N, double>& segment) {
  return std::max(max_abs(segment.start), max_abs(segment.end));
}
template <Dim N>
double extent_around_zero(const Aabb<N, double>& box) {
  return max_abs(box.max);
}
template <Dim N>
double extent_around_zero(const Obb<N, double>& box) {
  return sum_abs(box.half_extents);
}
template <Dim N>
double extent_around_zero(const Triangle<N, double>& triangle) {
  return std::max({max_abs(triangle.a), max_abs(triangle.b), max_abs(triangle.c)});
}

/// A vector along every edge; those of a triangle lead from corner to corner.
template <Dim N>
std::array<Vec<N, double>, 1> edges_of(const Segment<N, double>& segment) {
  return {segment.end};
}
template <Dim N>
std::array<Vec<N, double>, static_cast<std::size_t>(N)> edges_of(const Obb<N, double>& box) {
  std::array<Vec<N, double>, static_cast<std::size_t>(N)> edges;
  for (Dim i = 0; i < N; ++i) edges[static_cast<std::size_t>(i)] = box.axes[i];
  return edges;
}
template <Dim N>
std::array<Vec<N, double>, static_cast<std::size_t>(N)> edges_of(const Aabb<N, double>&) {
  return edges_of(Obb<N, double>());
}
template <Dim N>
std::array<Vec<N, double>, 3> edges_of(const Triangle<N, double>& triangle) {
  return {triangle.b - triangle.a, triangle.c - triangle.b, triangle.a - triangle.c};
}

/// The projection of a shape onto an axis, in units of the axis.
struct Projection {
  double low;
  double high;
};

inline Projection projection_around_zero(double reach) { return {-reach, reach}; }

template <Dim N>
Projection projection_on(const Vec<N, double>& axis, const Vec<N, double>& point) {
  const double place = dot(axis, point);
  return {place, place};
}
template <Dim N>
Projection projection_on(const Vec<N, double>& axis, const Segment<N, double>& segment) {
  return projection_around_zero(std::fabs(dot(axis, segment.end)));
}
template <Dim N>
Projection projection_on(const Vec<N, double>& axis, const Aabb<N, double>& box) {
  return projection_around_zero(dot(abs(axis), box.max));
}
template <Dim N>
Projection projection_on(const Vec<N, double>& axis, const Obb<N, double>& box) {
  double reach = 0;
  for (Dim i = 0; i < N; ++i) reach += std::fabs(dot(axis, box.axes[i])) * box.half_extents[i];
  return projection_around_zero(reach);
}
inline Projection projection_of(double x, double y, double z) {
  return {std::min(std::min(x, y), z), std::max(std::max(x, y), z)};
}
template <Dim N>
Projection projection_on(const Vec<N, double>& axis, const Triangle<N, double>& triangle) {
  return projection_of(dot(axis, triangle.a), dot(axis, triangle.b), dot(axis, triangle.c));
}

/// Between two projections; if negative, the length of their overlap.
inline double gap_between(const Projection& a, const Projection& b) { return std::max(a.low - b.high, b.low - a.high); }

// ---- The accurate test

/// The verdict of axes that are known to a few epsilon, each with an error of `slack` times its length. Overlapping and
/// apart are certain. Touching is the verdict if no axis separates the shapes, and one, or the lack of any, finds them
/// thin: they may still be apart, next to the tip of a needle, or in the plane of two flat shapes.
template <Dim N, class S>
class AccurateAxes {
 public:
  AccurateAxes(const S& other, const Triangle<N, double>& triangle, double slack)
      : other_(other), triangle_(triangle), slack_(slack) {}

  Relation verdict() {
    if (!project_normals(edges_of(other_), edges_of(triangle_))) return Relation::apart;
    return has_axis_ && is_deep_ ? Relation::overlapping : Relation::touching;
  }

 private:
  /// False if the axis proves the shapes apart.
  bool project(const Vec<N, double>& axis) {
    const double slack = slack_ * sum_abs(axis);
    if (slack == 0) return true;  // parallel edges span no face
    const double gap = gap_along(axis);
    has_axis_ = true;
    is_deep_ = is_deep_ && gap < -slack;
    return gap <= slack;
  }

  double gap_along(const Vec<N, double>& axis) const {
    return gap_between(projection_on(axis, other_), projection_on(axis, triangle_));
  }

  template <class Edges, class AxisOf>
  bool project_all(const Edges& edges, const AxisOf& axis_of) {
    return std::all_of(edges.begin(), edges.end(), [&](const Vec<N, double>& edge) { return project(axis_of(edge)); });
  }

  template <class EdgesA, class EdgesB>
  bool project_normals(const EdgesA& edges_a, const EdgesB& edges_b) {
    if constexpr (N == 2) {
      const auto normal = [](const Vec<2, double>& edge) { return perpendicular(edge); };
      return project_all(edges_a, normal) && project_all(edges_b, normal);
    } else {
      if (!project_faces(edges_a) || !project_faces(edges_b)) return false;
      for (const Vec<3, double>& first : edges_a) {
        if (!project_all(edges_b, [&](const Vec<3, double>& second) { return accurate_cross(first, second); })) {
          return false;
        }
      }
      return is_deep_ || !is_apart_in_plane(accurate_cross(edges_b[0], edges_b[1]), edges_a, edges_b);
    }
  }

  /// Flat shapes in one plane may be apart along it. This only saves the calculation of the distance, which would
  /// decide the same, hence the tolerance: the answer must not depend on which of two triangles has the normal.
  template <class EdgesA, class EdgesB>
  bool is_apart_in_plane(const Vec<3, double>& normal, const EdgesA& edges_a, const EdgesB& edges_b) const {
    const auto is_apart_beside = [&](const Vec<3, double>& edge) {
      const Vec<3, double> axis = cross(normal, edge);
      return gap_along(axis) > 4 * slack_ * sum_abs(axis);
    };
    return std::any_of(edges_a.begin(), edges_a.end(), is_apart_beside) ||
           std::any_of(edges_b.begin(), edges_b.end(), is_apart_beside);
  }

  /// Any two edges of a triangle or box span a face. Any two of a triangle span the same one, but rounding may hide
  /// from one pair that it is thin.
  template <std::size_t Count>
  bool project_faces(const std::array<Vec<3, double>, Count>& edges) {
    for (std::size_t i = 0; i < Count; ++i) {
      for (std::size_t j = i + 1; j < Count; ++j) {
        if (!project(accurate_cross(edges[i], edges[j]))) return false;
      }
    }
    return true;
  }

  S other_;
  Triangle<N, double> triangle_;
  double slack_;
  bool has_axis_ = false;
  bool is_deep_ = true;
};

// ---- The fast test, in 3D. The axis m = e x f of edges e from p, f from q is never calculated: its projections are a
// few dot products. Relative to the projection of p, q is at m . (q - p) = -(p x e) . f - (q x f) . e. If n is the
// normal of a triangle that e is an edge of, the third corner is at -n . f; if f is, at n . e. A box centered at zero,
// f its axis k, extends h_i |e . (f x axis i)| + h_j |e . (f x axis j)| to both sides of its center.

/// The axes of an axis-aligned box: nothing to calculate.
struct AlignedAxes {
  explicit AlignedAxes(const Aabb<3, double>&) {}
  double along(const Vec<3, double>& v, Dim k) const { return v[k]; }
  double across(const Vec<3, double>& v, Dim k) const { return v[k]; }
  static double volume() { return 1.0; }
  static Vec<3, double> half_extents(const Aabb<3, double>& box) { return box.max; }
};

/// Any axes. Aabb and Obb share the rest of the test, QuickBox.
struct GeneralAxes {
  explicit GeneralAxes(const Obb<3, double>& box)
      : axes(box.axes), normals(cross(axes[1], axes[2]), cross(axes[2], axes[0]), cross(axes[0], axes[1])) {}
  /// The dot product with axis k.
  double along(const Vec<3, double>& v, Dim k) const { return dot(v, axes[k]); }
  /// The dot product with the cross product of the other two axes.
  double across(const Vec<3, double>& v, Dim k) const { return dot(v, normals[k]); }
  /// Not quite 1: axes are orthonormal up to rounding in float.
  double volume() const { return std::fabs(dot(axes[0], normals[0])); }
  static Vec<3, double> half_extents(const Obb<3, double>& box) { return box.half_extents; }

  Mat<3, double> axes;
  Mat<3, double> normals;
};

template <class Box, class Axes>
class QuickBox {
 public:
  static constexpr std::size_t face_count = 3;

  explicit QuickBox(const Box& box) : axes_(box), half_extents_(Axes::half_extents(box)) {}

  /// At least the sum of the absolute coordinates of any axis, which is of unit length.
  static double size() { return 2.0; }
  double along(const Vec<3, double>& v, std::size_t k) const { return axes_.along(v, static_cast<Dim>(k)); }

  double face_gap(std::size_t face, const Triangle<3, double>& triangle) const {
    const auto k = static_cast<Dim>(face);
    const Projection projection =
        projection_of(axes_.across(triangle.a, k), axes_.across(triangle.b, k), axes_.across(triangle.c, k));
    return gap_between(projection, projection_around_zero(half_extents_[k] * axes_.volume()));
  }

  /// The value of an edge e that `beside` needs.
  Vec<3, double> facing(const Vec<3, double>& e) const {
    return abs(Vec<3, double>(axes_.across(e, 0), axes_.across(e, 1), axes_.across(e, 2)));
  }
  /// Along e x (axis k), from its center.
  Projection beside(const Vec<3, double>& facing, std::size_t k) const {
    const auto i = static_cast<Dim>((k + 1) % 3);
    const auto j = static_cast<Dim>((k + 2) % 3);
    return projection_around_zero(half_extents_[i] * facing[j] + half_extents_[j] * facing[i]);
  }

 private:
  Axes axes_;
  Vec<3, double> half_extents_;
};

/// A segment centered at zero, as half of its edge.
class QuickSegment {
 public:
  static constexpr std::size_t face_count = 0;

  explicit QuickSegment(const Segment<3, double>& segment) : half_(segment.end) {}

  double size() const { return sum_abs(half_); }
  double along(const Vec<3, double>& v, std::size_t) const { return dot(v, half_); }
  static double facing(const Vec<3, double>&) { return 0; }
  static Projection beside(double, std::size_t) { return {0, 0}; }

 private:
  Vec<3, double> half_;
};

class QuickTriangle {
 public:
  static constexpr std::size_t face_count = 1;

  explicit QuickTriangle(const Triangle<3, double>& triangle)
      : corner_(triangle.a), edges_(edges_of(triangle)), normal_(cross(edges_[0], edges_[1])) {}

  double size() const { return std::max(std::max(sum_abs(edges_[0]), sum_abs(edges_[1])), sum_abs(edges_[2])); }
  double along(const Vec<3, double>& v, std::size_t k) const { return dot(v, edges_[k]); }

  const Vec<3, double>& normal() const { return normal_; }
  double face_gap(std::size_t, const Triangle<3, double>& other) const {
    const Projection projection = projection_on(normal_, other);
    const double height = dot(normal_, corner_);
    return gap_between(projection, {height, height});
  }
  double facing(const Vec<3, double>& e) const { return dot(e, normal_); }
  /// Along e x (edge k), from that edge.
  static Projection beside(double facing, std::size_t) { return {std::min(0.0, facing), std::max(0.0, facing)}; }

  /// Corner k, where edge k starts, x edge k.
  std::array<Vec<3, double>, 3> moments(const Triangle<3, double>& triangle) const {
    return {cross(triangle.a, edges_[0]), cross(triangle.b, edges_[1]), cross(triangle.c, edges_[2])};
  }

 private:
  Vec<3, double> corner_;
  std::array<Vec<3, double>, 3> edges_;
  Vec<3, double> normal_;
};

inline QuickSegment quick_form(const Segment<3, double>& segment) { return QuickSegment(segment); }
inline QuickBox<Aabb<3, double>, AlignedAxes> quick_form(const Aabb<3, double>& box) {
  return QuickBox<Aabb<3, double>, AlignedAxes>(box);
}
inline QuickBox<Obb<3, double>, GeneralAxes> quick_form(const Obb<3, double>& box) {
  return QuickBox<Obb<3, double>, GeneralAxes>(box);
}
inline QuickTriangle quick_form(const Triangle<3, double>& triangle) { return QuickTriangle(triangle); }

/// `slack` covers the errors along a unit axis, with a margin. Products of plain cross products are off by as much
/// times the sizes of the factors; axes that this leaves undecided are evaluated by projection.
template <class S>
class QuickAxes {
 public:
  QuickAxes(const S& other, const Triangle<3, double>& triangle, double slack)
      : shape_(other), triangle_(triangle), slack_(slack), other_(quick_form(other)), own_(quick_form(triangle)) {}

  /// Certain, or none.
  std::optional<Relation> verdict() {
    if (!settle_faces() || !settle_edges()) return Relation::apart;
    if (is_undecided_ || !has_axis_) return std::nullopt;
    return Relation::overlapping;
  }

 private:
  static constexpr bool is_triangle = std::is_same_v<S, Triangle<3, double>>;

  /// False if the gap proves the shapes apart.
  bool settle(double gap, double bound, const Vec<3, double>& first, const Vec<3, double>& second) {
    if (gap < -bound) {
      has_axis_ = true;
      return true;
    }
    return !(gap > bound) && project(accurate_cross(first, second));
  }

  bool project(const Vec<3, double>& axis) {
    const double bound = slack_ * sum_abs(axis);
    if (bound == 0) return true;  // parallel edges span no face
    const double gap = gap_between(projection_on(axis, shape_), projection_on(axis, triangle_));
    has_axis_ = true;
    is_undecided_ = is_undecided_ || !(gap < -bound);
    return !(gap > bound);
  }

  /// A box's own faces cost least.
  bool settle_faces() {
    if constexpr (Other::face_count > 0) {
      const auto other_edges = edges_of(shape_);
      const double bound = slack_ * other_.size() * other_.size();
      for (std::size_t k = 0; k < Other::face_count; ++k) {
        const auto& first = other_edges[(k + 1) % 3];
        if (!settle(other_.face_gap(k, triangle_), bound, first, other_edges[(k + 2) % 3])) return false;
      }
    }
    const std::array<Vec<3, double>, 3> edges = edges_of(triangle_);
    const double height = dot(own_.normal(), triangle_.a);
    const double gap = gap_between(projection_on(own_.normal(), shape_), {height, height});
    return settle(gap, slack_ * own_.size() * own_.size(), edges[0], edges[1]);
  }

  bool settle_edges() {
    const std::array<Vec<3, double>, 3> edges = edges_of(triangle_);
    const auto other_edges = edges_of(shape_);
    const std::array<Vec<3, double>, 3> moments = own_.moments(triangle_);
    const auto other_moments = moments_of_other();
    const double bound = slack_ * own_.size() * other_.size();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto facing = other_.facing(edges[i]);
      for (std::size_t j = 0; j < other_edges.size(); ++j) {
        double place = -other_.along(moments[i], j);
        if constexpr (is_triangle) place -= dot(other_moments[j], edges[i]);
        const double third = -other_.along(own_.normal(), j);
        const Projection beside = other_.beside(facing, j);
        const double gap =
            gap_between({std::min(0.0, third), std::max(0.0, third)}, {place + beside.low, place + beside.high});
        if (!settle(gap, bound, edges[i], other_edges[j])) return false;
      }
    }
    return true;
  }

  /// Zero for shapes centered at zero.
  std::array<Vec<3, double>, 3> moments_of_other() const {
    if constexpr (is_triangle) return other_.moments(shape_);
    return {};
  }

  using Other = decltype(quick_form(std::declval<const S&>()));

  const S& shape_;
  const Triangle<3, double>& triangle_;
  double slack_;
  Other other_;
  QuickTriangle own_;
  bool has_axis_ = false;
  bool is_undecided_ = false;
};

}  // namespace graze::detail
