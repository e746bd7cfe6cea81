// SPDX-License-Identifier: MIT
// Pairs of shapes with a face of one opposite a face of the other, parallel except for a tilt that squared distances do
// not show.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <rapidcheck.h>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>

#include "catalogue.hpp"
#include "query/numbers_of.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"

namespace graze::test {

/// Generates a pair of shapes of any types: polytopes, meshes, triangles and segments are new, all others are moved.
template <Dim N, class T>
class FlushFaces {
 public:
  using Any = AnyShape<N, T>;
  using Pair = AnyPair<N, T>;

  explicit FlushFaces(rc::Random& random) : random_(random) {}

  /// With a gap or an overlap of 0.2 down to 2e-7; in two of three cases tilted by 1e-12 to 1e-6 radians (in float 1e-9
  /// to 1e-5); in half of the cases, for doubles, rounded to 7 to 13 decimal places.
  Pair make(const Pair& drawn) {
    const bool has_box =
        std::holds_alternative<Aabb<N, T>>(drawn.first) || std::holds_alternative<Aabb<N, T>>(drawn.second);
    const Mat<N, double> both = has_box ? Mat<N, double>(1.0) : turn(between(random_, -180, 180));
    Vec<N, double> way = unit_axis<N>(0) * (0.2 * std::pow(10, -between(random_, 0, 6)));
    if (whole(random_, 0, 1) == 0) way = -way;
    if (whole(random_, 0, 1) == 0) way[N - 1] = 0.25 * whole(random_, -2, 2);
    const Any a = placed(drawn.first, -1);
    const Any b = moved<N, T>(placed(drawn.second, 1), Vec<N, T>(way));
    const double step = whole(random_, 0, 1) == 0 ? 0 : std::pow(10, -whole(random_, 7, 13));
    return {rounded_to(step, turned(a, both)), rounded_to(step, turned(b, both * turn(tilt())))};
  }

 private:
  /// On one side of the plane x = 0, with a face in it.
  Any placed(const Any& drawn, double side) {
    if (std::holds_alternative<Polytope<N, T>>(drawn)) return convex_hull<N, T>(corners_behind(side));
    if (std::holds_alternative<Triangle<N, T>>(drawn)) {
      const Vec<N, T> last = N == 3 ? in_plane() : in_plane() + Vec<N, T>(unit_axis<N>(0) * side);
      return Triangle<N, T>{in_plane(), in_plane(), last};
    }
    if (std::holds_alternative<Segment<N, T>>(drawn)) return Segment<N, T>{in_plane(), in_plane()};
    if (std::holds_alternative<Mesh<N, T>>(drawn)) {
      std::vector<Vec<N, T>> vertices = {in_plane(), in_plane(), in_plane(), in_plane()};
      vertices.back() += Vec<N, T>(unit_axis<N>(0) * side);
      return mesh_of<N, T>(vertices, std::array<std::array<std::uint32_t, 3>, 2>{{{0, 1, 3}, {2, 3, 1}}});
    }
    const auto box = bounds(drawn);
    const T end = side < 0 ? box.max[0] : box.min[0];
    return std::isfinite(end) ? moved<N, T>(drawn, Vec<N, T>(unit_axis<N>(0)) * -end) : drawn;
  }

  /// In half of the cases on a lattice, so that perpendiculars may end on the diagonals of faces.
  Vec<N, T> in_plane() {
    Vec<N, double> point(0.0);
    const bool is_on_lattice = whole(random_, 0, 1) == 0;
    for (Dim i = 1; i < N; ++i) point[i] = is_on_lattice ? 0.5 * whole(random_, -2, 2) : between(random_, -1, 1);
    return Vec<N, T>(point);
  }

  /// A prism, or a few points behind the face.
  std::vector<Vec<N, T>> corners_behind(double side) {
    std::vector<Vec<N, T>> corners;
    const bool is_prism = whole(random_, 0, 1) == 0;
    const int count = static_cast<int>(whole(random_, N, 8));
    const auto depth = [&] { return unit_axis<N>(0) * (side * between(random_, 0.1, 2)); };
    const Vec<N, double> height = depth();
    for (int i = 0; i < count; ++i) {
      corners.push_back(in_plane());
      if (is_prism) corners.push_back(corners.back() + Vec<N, T>(height));
    }
    for (int i = 0; i < count && !is_prism; ++i) corners.push_back(in_plane() + Vec<N, T>(depth()));
    return corners;
  }

  double tilt() {
    if (whole(random_, 0, 2) == 0) return 0;
    const double radians =
        std::pow(10, std::is_same_v<T, float> ? between(random_, -9, -5) : between(random_, -12, -6));
    return radians * (180 / 3.14159265358979323846);
  }

  Mat<N, double> turn(double degrees) {
    if constexpr (N == 2) {
      return rotation_matrix(degrees);
    } else {
      return rotation_matrix(any_way<3>(random_), degrees);
    }
  }

  static Any turned(const Any& shape, const Mat<N, double>& rotation) {
    if (std::holds_alternative<Aabb<N, T>>(shape)) return shape;
    return transformed(shape, Pose<N, T>{rounded<N, T>(rotation), Vec<N, T>(T(0))});
  }

  /// Like data given with this many digits; not for floats, whose last bits are no digits.
  static Any rounded_to(double step, Any shape) {
    if (step == 0 || std::is_same_v<T, float>) return shape;
    for_each_vector<N, T>(shape, [step](Vec<N, T>& v) {
      for (Dim i = 0; i < N; ++i) v[i] = static_cast<T>(std::round(static_cast<double>(v[i]) / step) * step);
    });
    return shape;
  }

  rc::Random& random_;
};

}  // namespace graze::test
