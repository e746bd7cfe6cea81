// SPDX-License-Identifier: MIT
/// @file
/// mass_properties(shape): volume, centroid and inertia of a solid of density 1.
///
///     sphere, aabb, obb, capsule            closed form
///     triangle and polytope in 2D           sum over triangles
///     polytope in 3D                        sum over tetrahedra under the faces of the hull
///     compound                              sum of its parts: where parts overlap, the common volume counts twice
///     posed                                 that of the shape, rotated and moved
///     point, segment; triangle in 3D        no volume, no inertia; the centroid is the middle
///     ray, plane, half-space                unbounded: no centroid (NaN); half-spaces have an infinite volume
///
/// Users' shapes, which are known by their support points alone, have no mass properties.
///
/// Calculated in double for every type, because volumes of floats can leave the range of float. Errors are a few
/// epsilon of double of the volume, and of the centroid and inertia of a box around the shape.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <type_traits>
#include <vector>

#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/compiled/instances.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/hull/faces.hpp>
#include <graze/shape/posed.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

/// In 3D a symmetric matrix; in 2D one number, for rotation about the centroid.
template <Dim N>
using Inertia = std::conditional_t<N == 2, double, Mat<3, double>>;

/// The result of `mass_properties`.
template <Dim N>
struct MassProperties {
  double volume = 0;  ///< In 2D the area.
  /// In world coordinates; NaN for unbounded shapes and empty compounds.
  Vec<N, double> centroid = Vec<N, double>(0.0);
  Inertia<N> inertia = Inertia<N>(0.0);  ///< About the centroid, along the world's axes, at density 1.
};

namespace detail {

/// The integrals of 1, x and (x - centroid)(x - centroid)^T over a solid, the second divided by the first.
template <Dim N>
struct Moments {
  double volume = 0;
  Vec<N, double> centroid = Vec<N, double>(0.0);
  Mat<N, double> second = Mat<N, double>(0.0);
};

template <Dim N>
Mat<N, double> outer_product(const Vec<N, double>& a, const Vec<N, double>& b) {
  Mat<N, double> result;
  for (Dim i = 0; i < N; ++i) result[i] = a * b[i];
  return result;
}

/// The moments of simplices that consist of the origin and N corners each; their signed volumes are added.
template <Dim N>
class SimplexSum {
 public:
  void add(const std::array<Vec<N, double>, static_cast<std::size_t>(N)>& corners) {
    double volume = 0;
    Vec<N, double> sum(0.0);
    Mat<N, double> squares(0.0);
    for (const Vec<N, double>& corner : corners) {
      sum += corner;
      squares += outer_product<N>(corner, corner);
    }
    if constexpr (N == 2) {
      volume = accurate_cross(corners[0], corners[1]) / 2;
    } else {
      volume = dot(corners[0], accurate_cross(corners[1], corners[2])) / 6;
    }
    volume_ += volume;
    first_ += sum * (volume / (N + 1));
    second_ += (squares + outer_product<N>(sum, sum)) * (volume / ((N + 1) * (N + 2)));
  }

  /// Relative to the former origin; `middle` is the centroid if there is no volume.
  Moments<N> moments(const Vec<N, double>& origin, const Vec<N, double>& middle) const {
    if (!(volume_ > 0)) return {0, middle};
    const Vec<N, double> off = first_ / volume_;
    return {volume_, origin + off, second_ - outer_product<N>(off, off) * volume_};
  }

 private:
  double volume_ = 0;
  Vec<N, double> first_ = Vec<N, double>(0.0);
  Mat<N, double> second_ = Mat<N, double>(0.0);
};

template <Dim N, class T>
Vec<N, double> mean_of(std::span<const Vec<N, T>> points) {
  const Vec<N, double> first = wide<N, T>(points.front());
  Vec<N, double> sum(0.0);
  for (const Vec<N, T>& point : points) sum += wide<N, T>(point) - first;
  return first + sum / static_cast<double>(points.size());
}

template <class T>
Moments<2> moments_of_polygon(std::span<const Vec<2, T>> corners) {
  const Vec<2, double> origin = mean_of(corners);
  SimplexSum<2> sum;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec<2, T>& next = corners[(i + 1) % corners.size()];
    sum.add({wide<2, T>(corners[i]) - origin, wide<2, T>(next) - origin});
  }
  return sum.moments(origin, origin);
}

// ---- The moments of each type

template <Dim N, class T>
Moments<N> moments_of(const Vec<N, T>& point) {
  return {0, wide<N, T>(point)};
}

template <Dim N, class T>
Moments<N> moments_of(const Segment<N, T>& segment) {
  return {0, 0.5 * wide<N, T>(segment.start) + 0.5 * wide<N, T>(segment.end)};
}

template <Dim N>
Moments<N> moments_without_end(double volume) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {volume, Vec<N, double>(nan), outer_product<N>(Vec<N, double>(nan), Vec<N, double>(nan))};
}

template <Dim N, class T>
Moments<N> moments_of(const Ray<N, T>&) {
  return moments_without_end<N>(0);
}

template <Dim N, class T>
Moments<N> moments_of(const Plane<N, T>&) {
  return moments_without_end<N>(0);
}

template <Dim N, class T>
Moments<N> moments_of(const HalfSpace<N, T>&) {
  return moments_without_end<N>(std::numeric_limits<double>::infinity());
}

template <Dim N>
double sphere_volume(double radius) {
  return N == 2 ? std::numbers::pi * radius * radius : 4 * std::numbers::pi / 3 * radius * radius * radius;
}

template <Dim N, class T>
Moments<N> moments_of(const Sphere<N, T>& sphere) {
  const auto radius = static_cast<double>(sphere.radius);
  const double volume = sphere_volume<N>(radius);
  return {volume, wide<N, T>(sphere.center), Mat<N, double>(volume * radius * radius / (N + 2))};
}

/// center + edges * u with |u[i]| <= 1.
template <Dim N>
Moments<N> moments_of_box(const Vec<N, double>& center, const Mat<N, double>& edges) {
  double volume = 0;
  if constexpr (N == 2) {
    volume = 4 * std::fabs(accurate_cross(edges[0], edges[1]));
  } else {
    volume = 8 * std::fabs(dot(edges[0], accurate_cross(edges[1], edges[2])));
  }
  Mat<N, double> squares(0.0);
  for (Dim i = 0; i < N; ++i) squares += outer_product<N>(edges[i], edges[i]);
  return {volume, center, squares * (volume / 3)};
}

template <Dim N, class T>
Moments<N> moments_of(const Aabb<N, T>& box) {
  Mat<N, double> edges(0.0);
  for (Dim i = 0; i < N; ++i)
    edges[i][i] = 0.5 * static_cast<double>(box.max[i]) - 0.5 * static_cast<double>(box.min[i]);
  return moments_of_box<N>(0.5 * wide<N, T>(box.min) + 0.5 * wide<N, T>(box.max), edges);
}

template <Dim N, class T>
Moments<N> moments_of(const Obb<N, T>& box) {
  return moments_of_box<N>(wide<N, T>(box.center), half_edges(box));
}

template <Dim N, class T>
Moments<N> moments_of(const Triangle<N, T>& triangle) {
  const std::array<Vec<N, T>, 3> corners{triangle.a, triangle.b, triangle.c};
  if constexpr (N == 2) {
    const bool is_turned = orientation(corners[0], corners[1], corners[2]) < 0;
    return moments_of_polygon<T>(
        std::array<Vec<2, T>, 3>{corners[0], corners[is_turned ? 2 : 1], corners[is_turned ? 1 : 2]});
  } else {
    return {0, mean_of<3, T>(corners)};
  }
}

/// A cylinder, in 2D a rectangle, with half a sphere at either end.
template <Dim N, class T>
Moments<N> moments_of(const Capsule<N, T>& capsule) {
  const Vec<N, double> start = wide<N, T>(capsule.a);
  const Vec<N, double> way = wide<N, T>(capsule.b) - start;
  const double length = std::sqrt(dot(way, way));
  const auto radius = static_cast<double>(capsule.radius);
  const double sphere = sphere_volume<N>(radius);
  const double middle = length * (N == 2 ? 2 * radius : std::numbers::pi * radius * radius);
  const Vec<N, double> axis = length > 0 ? way / length : unit_axis<N>(0);
  // The distance of the centroid of half a sphere from its flat side, in radii.
  constexpr double rise = N == 2 ? 4 / (3 * std::numbers::pi) : 0.375;
  const double radius_squared = radius * radius;
  const double along = middle * length * length / 12 +
                       sphere * (radius_squared / (N + 2) + length * length / 4 + rise * length * radius);
  const double across = middle * radius_squared / (N == 2 ? 3 : 4) + sphere * radius_squared / (N + 2);
  return {middle + sphere, start + 0.5 * way, Mat<N, double>(across) + outer_product<N>(axis, axis) * (along - across)};
}

template <Dim N, class T>
Moments<N> moments_of(const Polytope<N, T>& polytope) {
  const std::span<const Vec<N, T>> vertices = polytope.vertices();
  if constexpr (N == 2) {
    return moments_of_polygon<T>(vertices);
  } else {
    const Vec<3, double> origin = mean_of(vertices);
    const auto from_origin = [&](std::uint32_t vertex) { return wide<3, T>(vertices[vertex]) - origin; };
    SimplexSum<3> sum;
    for (const HullTriangle& face : hull_faces<T>(vertices)) {
      sum.add({from_origin(face[0]), from_origin(face[1]), from_origin(face[2])});
    }
    return sum.moments(origin, origin);
  }
}

template <Dim N, class T>
Moments<N> moments_of(const AnyShape<N, T>& shape);

/// Adds the parts by Steiner's theorem. Without any volume, the centroid is the mean of the parts' centroids.
template <HasParts Whole>
Moments<dimension_of<Whole>> moments_of_parts(const Whole& whole_shape) {
  constexpr Dim N = dimension_of<Whole>;
  std::vector<Moments<N>> parts(count_of_parts(whole_shape));
  if (parts.empty()) return moments_without_end<N>(0);
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = moments_of(part_of(whole_shape, i));
  const Vec<N, double> origin = parts.front().centroid;
  Moments<N> whole;
  Vec<N, double> first(0.0);
  Vec<N, double> mean(0.0);
  for (const Moments<N>& part : parts) {
    whole.volume += part.volume;
    first += (part.centroid - origin) * part.volume;
    mean += (part.centroid - origin) / static_cast<double>(parts.size());
  }
  whole.centroid = origin + (whole.volume > 0 ? first / whole.volume : mean);
  for (const Moments<N>& part : parts) {
    const Vec<N, double> off = part.centroid - whole.centroid;
    whole.second += part.second + outer_product<N>(off, off) * part.volume;
  }
  return whole;
}

template <Dim N, class T>
Moments<N> moments_of(const Compound<N, T>& compound) {
  return moments_of_parts(compound);
}

/// Of a solid in 3D, the integrals over the tetrahedra of its faces, with their sign; without a positive volume, and
/// for a surface, those of the faces.
template <Dim N, class T>
Moments<N> moments_of(const Mesh<N, T>& mesh) {
  if constexpr (N == 3) {
    if (mesh.kind() == MeshKind::solid) {
      const Vec<3, double> origin = wide<3, T>(bounds(mesh).center());
      SimplexSum<3> sum;
      for (std::size_t face = 0; face < mesh.faces().size(); ++face) {
        const Triangle<3, T> triangle = mesh.triangle(face);
        sum.add({wide<3, T>(triangle.a) - origin, wide<3, T>(triangle.b) - origin, wide<3, T>(triangle.c) - origin});
      }
      const Moments<3> solid = sum.moments(origin, origin);
      if (solid.volume > 0) return solid;
    }
  }
  return moments_of_parts(mesh);
}

template <Dim N, class T>
Moments<N> moments_of(const AnyShape<N, T>& shape) {
  return detail::visit(
      [](const auto& held) -> Moments<N> {
        static_assert(
            requires { moments_of(held); },
            "a shape of AnyShape has no moments_of: add one to graze/query/mass_properties.hpp");
        return moments_of(held);
      },
      shape);
}

/// For all rotation * x + position, also for a rotation that is orthonormal only nearly.
template <class S>
requires requires(const S& shape) { moments_of(shape); }
Moments<dimension_of<S>> moments_of(const Posed<S>& posed) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  const Moments<N> before = moments_of(posed.shape);
  const Mat<N, double> rotation = wide_matrix<N, T>(posed.pose.rotation);
  const double growth = moments_of_box<N>(Vec<N, double>(0.0), rotation).volume / (1 << N);  // about 1
  return {before.volume * growth, rotation * before.centroid + wide<N, T>(posed.pose.position),
          rotation * before.second * transpose(rotation) * growth};
}

/// The moments of a shape, also of one that is out of range, except for what double cannot represent.
template <class S>
Moments<dimension_of<S>> moments_in_range(const S& shape) {
  constexpr Dim N = dimension_of<S>;
  if (!are_usual(shape)) {
    const auto rescaled = answer_in_range<Moments<N>>(
        [](const PowerOfTwo& power, const auto& scaled_shape) {
          Moments<N> moments = moments_of(scaled_shape);
          moments.volume = std::ldexp(moments.volume, -static_cast<int>(N) * power.exponent());
          moments.centroid = power.inverse()(moments.centroid);
          for (Dim j = 0; j < N; ++j) {
            for (double& number : std::span(&moments.second[j][0], static_cast<std::size_t>(N))) {
              number = std::ldexp(number, -static_cast<int>(N + 2) * power.exponent());
            }
          }
          return moments;
        },
        shape);
    if (rescaled) return *rescaled;
  }
  return moments_of(shape);
}

/// A built-in shape, posed or not.
template <class S>
concept HasMoments = requires(const S& shape) {
  moments_of(shape);
};

}  // namespace detail

/// Volume, centroid and inertia of a valid shape of density 1. Multiply the inertia by m / volume for a body of mass m.
/// Boxes count as stored, even if their axes are orthonormal only nearly. Volumes and inertias out of the range of
/// double are infinite or zero. The integrals are those of Mirtich, "Fast and Accurate Computation of Polyhedral Mass
/// Properties" (1996), summed over tetrahedra (Blow and Binstock, 2004).
template <Shape S>
requires detail::HasMoments<S> MassProperties<dimension_of<S>> mass_properties(const S& shape) {
  constexpr Dim N = dimension_of<S>;
  const detail::Moments<N> moments = detail::moments_in_range(shape);
  MassProperties<N> result;
  result.volume = moments.volume;
  result.centroid = moments.centroid;
  double trace = 0;
  for (Dim i = 0; i < N; ++i) trace += moments.second[i][i];
  if constexpr (N == 2) {
    result.inertia = trace;
  } else {
    result.inertia = Mat<3, double>(trace) - moments.second;
  }
  return result;
}

GRAZE_DECLARE_INSTANCES(GRAZE_MASS_PROPERTIES_INSTANCES)

}  // namespace graze
