// SPDX-License-Identifier: MIT
/// @file
/// winding_number(mesh, point): how often the faces of a mesh run around a point.
///
/// A closed surface divides space into regions with an integer each: 0 outside, 1 inside if the faces run
/// counter-clockwise as seen from outside, -1 if they run clockwise, 2 where two insides overlap. It is counted where a
/// ray from the point along x passes the faces, by exact orientation of the numbers as stored, and in time logarithmic
/// in the number of faces. A surface with holes is closed by strips from the edges of its holes to infinity, against
/// that ray, which therefore does not meet them; then what the strips contribute, their solid angles over 4 pi, is
/// subtracted. That is the generalized winding number of Jacobson, Kavan, Sorkine-Hornung, "Robust Inside-Outside
/// Segmentation using Generalized Winding Numbers" (2013), which changes smoothly around a hole: the sum of the solid
/// angles of all faces over 4 pi. Its error is a few epsilon for each edge of a hole.
///
/// On a face the number jumps. There the result is that of one side: of a point that is displaced by less than any
/// number along z, by less than that along y, and still less along x.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <type_traits>
#include <utility>

#include <graze/math/orientation.hpp>
#include <graze/math/orientation_3d.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/parts/on_way.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/mesh/flat_triangle.hpp>
#include <graze/shape/triangle.hpp>

namespace graze {

namespace detail {

/// orientation(a, b, p) for a p that is displaced by less than any number along its second coordinate, and by less than
/// that along its first: zero only if a = b.
template <class T>
int turn_to_displaced(const Vec<2, T>& a, const Vec<2, T>& b, const Vec<2, T>& p) {
  if (const int turn = orientation(a, b, p); turn != 0) return turn;
  if (a[0] != b[0]) return b[0] > a[0] ? 1 : -1;
  if (a[1] != b[1]) return a[1] > b[1] ? 1 : -1;
  return 0;
}

/// The turn of a triangle if the displaced point is inside; 0 if it is outside.
template <class T>
int turn_around_displaced(const Vec<2, T>& a, const Vec<2, T>& b, const Vec<2, T>& c, const Vec<2, T>& p) {
  const int turn = turn_to_displaced(a, b, p);
  return turn == turn_to_displaced(b, c, p) && turn == turn_to_displaced(c, a, p) ? turn : 0;
}

/// The side of a face's plane on which the displaced point lies, as `orientation` returns it.
template <class T>
int side_of_displaced(const Triangle<3, T>& face, const Vec<3, T>& point) {
  int side = orientation(face.a, face.b, face.c, point);
  for (Dim axis = 2; axis >= 0 && side == 0; --axis) {
    side = orientation(seen_along(axis, face.a), seen_along(axis, face.b), seen_along(axis, face.c));
  }
  return side;
}

/// The power of two by which points are multiplied before they are asked for their orientation, whose products of
/// coordinates may leave the range of double; 1 for usual ones.
template <class T, class... Points>
T scale_of_points([[maybe_unused]] const Points&... points) {
  if constexpr (std::is_same_v<T, float>) {
    return 1;
  } else {
    return scale_to_moderate(std::max({max_abs(points)...}));
  }
}

/// 1 if a ray from a point along x leaves through a face, -1 if it enters, 0 if it does not pass.
template <class T>
int passage_in_range(const Triangle<3, T>& face, const Vec<3, T>& point) {
  const int turn =
      turn_around_displaced(seen_along(0, face.a), seen_along(0, face.b), seen_along(0, face.c), seen_along(0, point));
  return turn != 0 && side_of_displaced(face, point) == -turn ? turn : 0;
}
/// In 2D: the turn of the face that contains the point.
template <class T>
int passage_in_range(const Triangle<2, T>& face, const Vec<2, T>& point) {
  return turn_around_displaced(face.a, face.b, face.c, point);
}

/// The same for numbers of any size.
template <Dim N, class T>
int passage(const Triangle<N, T>& face, const Vec<N, T>& point) {
  const T scale = scale_of_points<T>(face.a, face.b, face.c, point);
  if (scale == 1) return passage_in_range(face, point);
  return passage_in_range(Triangle<N, T>{face.a * scale, face.b * scale, face.c * scale}, Vec<N, T>(point * scale));
}

/// Whether a corner is at the displaced point or, seen from it, along x. The strips from there run through the point.
inline bool is_on_axis(const Vec<3, double>& seen) { return seen[1] == 0 && seen[2] == 0 && seen[0] >= 0; }

/// The length of a vector minus its x, without cancellation.
inline double length_beyond_x(const Vec<3, double>& v) {
  const double across = v[1] * v[1] + v[2] * v[2];
  const double length = std::sqrt(v[0] * v[0] + across);
  return v[0] > 0 ? across / (length + v[0]) : length - v[0];
}

/// Half the solid angle of the strip from an edge toward -x, whose corners the displaced point sees at u and v. Van
/// Oosterom and Strackee, "The Solid Angle of a Plane Triangle" (1983), with the corners u, v and the direction -x. A
/// corner on the axis is seen along -z, as far away as the displacement.
inline double half_angle_of_strip(Vec<3, double> u, Vec<3, double> v) {
  if (is_on_axis(v)) std::swap(u, v);
  if (is_on_axis(u)) {
    if (u[0] > 0) return std::atan2(std::fabs(v[1]), -v[2]);
    u = {0, 0, -1};
  }
  const double size = std::fabs(u[1] * v[2] - u[2] * v[1]);
  return std::atan2(size, length_beyond_x(u) * length_beyond_x(v) + u[1] * v[1] + u[2] * v[2]);
}

/// The signed solid angle of the strip from the edge a, b toward -x, as seen from the point, over 4 pi. The exact turn
/// tells the sign where rounding hides it, so that the sum jumps exactly where the number of passages does.
template <class T>
double share_of_strip(const Vec<3, T>& a, const Vec<3, T>& b, const Vec<3, T>& point) {
  const T scale = scale_of_points<T>(a, b, point);
  const std::array<Vec<3, T>, 3> at = {a * scale, b * scale, point * scale};
  const int turn = turn_to_displaced(seen_along(0, at[0]), seen_along(0, at[1]), seen_along(0, at[2]));
  if (turn == 0) return 0;
  const Vec<3, double> from = wide<3, T>(at[2]);
  return turn * half_angle_of_strip(wide<3, T>(at[1]) - from, wide<3, T>(at[0]) - from) / (2 * std::numbers::pi);
}

/// The number of times the faces run around a point, without the strips of open edges.
template <Dim N, class T>
int passages(const Mesh<N, T>& mesh, const Vec<N, T>& point) {
  int sum = 0;
  visit_parts(mesh, MayBeOnWay<N, T>{point}, [&](const FacePart<N, T>& face, std::size_t) {
    sum += passage(face.shape, point);
    return true;
  });
  return sum;
}

/// What the strips of open edges contribute.
template <Dim N, class T>
double share_of_strips([[maybe_unused]] const Mesh<N, T>& mesh, [[maybe_unused]] const Vec<N, T>& point) {
  double sum = 0;
  if constexpr (N == 3) {
    const PlacedMesh<N, T>& faces = placed(mesh);
    for (const OpenEdge& edge : faces.data()->open_edges()) {
      sum += edge.count * share_of_strip(faces.vertex(edge.from), faces.vertex(edge.to), point);
    }
  }
  return sum;
}

}  // namespace detail

/// How often the faces of a mesh run around a point: the generalized winding number, also of surfaces that are open or
/// cross themselves. An integer, and exact, if the mesh is closed. In 2D: the number of faces that contain the point
/// and run counter-clockwise, minus those that run clockwise. See the top of this file; also for points on a face. 0
/// for a mesh without faces. Coordinates that differ by more than a factor of 1e120 may count as equal.
template <Dim N, class T>
double winding_number(const Mesh<N, T>& mesh, const std::type_identity_t<Vec<N, T>>& point) {
  return detail::passages(mesh, point) - detail::share_of_strips(mesh, point);
}

namespace detail {

/// Whether a solid mesh contains a point that is not on a face.
template <Dim N, class T>
bool is_inside([[maybe_unused]] const Mesh<N, T>& mesh, [[maybe_unused]] const Vec<N, T>& point) {
  if constexpr (N == 2) return false;  // all is on faces
  return mesh.kind() == MeshKind::solid && winding_number(mesh, point) > 0.5;
}

}  // namespace detail

}  // namespace graze
