// SPDX-License-Identifier: MIT
// Random shapes that are the same on every machine: only integers decide, and coordinates are exact.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/pose.hpp>
#include <graze/math/random/linear_congruential.hpp>
#include <graze/math/rotation.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::answers {

/// Coordinates from -2 to 2; every other one is a multiple of 1/2, so that many things touch or coincide.
template <Dim N, class T>
class Draw {
 public:
  using Any = AnyShape<N, T>;
  using Point = Vec<N, T>;

  explicit Draw(std::uint64_t seed) : random_(seed) { make_pool(); }

  std::size_t below(std::size_t count) { return random_.below(count); }

  T coordinate() {
    const std::size_t steps = below(2) == 0 ? 8 : 4'000'000;
    return static_cast<T>(4 * static_cast<double>(below(steps + 1)) / static_cast<double>(steps) - 2);
  }

  /// Greater than zero, at most 1.
  T size() { return static_cast<T>(static_cast<double>(1 + below(64)) / 64); }

  Point point() {
    Point result;
    for (Dim i = 0; i < N; ++i) result[i] = coordinate();
    return result;
  }

  /// Of length 1 up to rounding; every other one along an axis.
  Point direction() {
    Vec<N, double> result(0.0);
    if (below(2) == 0) {
      result[static_cast<Dim>(below(N))] = below(2) == 0 ? 1 : -1;
    } else if constexpr (N == 2) {
      result = cosine_sine_of_degrees(degrees());
    } else {
      const Vec<2, double> around = cosine_sine_of_degrees(degrees());
      const Vec<2, double> up = cosine_sine_of_degrees(degrees());
      result = {around.x * up.x, around.y * up.x, up.y};
    }
    return Point(result);
  }

  Pose<N, T> pose() {
    if constexpr (N == 2) {
      return {Mat<N, T>(rotation_matrix(degrees())), point()};
    } else {
      const Vec<3, double> axis(direction());
      return {Mat<N, T>(rotation_matrix(axis, degrees())), point()};
    }
  }

  /// A shape of any type. Hulls, compounds and meshes are taken from a pool and moved.
  Any shape() {
    switch (below(14)) {
      case 0:
        return point();
      case 1:
        return Segment<N, T>{point(), point()};
      case 2:
        return Ray<N, T>{point(), direction()};
      case 3:
        return Sphere<N, T>{point(), size()};
      case 4:
        return aabb();
      case 5:
      case 6:
        return box();
      case 7:
        return Plane<N, T>{direction(), coordinate()};
      case 8:
        return HalfSpace<N, T>{direction(), coordinate()};
      case 9:
        return Triangle<N, T>{point(), point(), point()};
      case 10:
        return Capsule<N, T>{point(), point(), size()};
      default:
        return from_pool();
    }
  }

 private:
  // Numbers are drawn in lists in braces or one by one, because compilers evaluate arguments in different orders.

  Aabb<N, T> aabb() {
    const Point corner = point();
    return Aabb<N, T>::from_corners(corner, point());
  }

  Any from_pool() {
    const Any& shape = pool_[below(pool_.size())];
    return transformed(shape, pose());
  }

  double degrees() {
    return below(2) == 0 ? 15.0 * static_cast<double>(below(24)) : static_cast<double>(below(360'000)) / 1000;
  }

  Obb<N, T> box() {
    Point half;
    for (Dim i = 0; i < N; ++i) half[i] = size();
    const Pose<N, T> at = pose();
    return {at.position, half, at.rotation};
  }

  std::vector<Point> points(std::size_t count) {
    std::vector<Point> result(count);
    for (Point& each : result) each = point();
    return result;
  }

  void make_pool() {
    constexpr std::size_t of_each = 16;
    for (std::size_t i = 0; i < of_each; ++i) {
      const std::vector<Point> corners = points(N + 1 + below(24));
      pool_.push_back(convex_hull<N, T>(corners));
      pool_.push_back(
          compound_of<N, T>({Any(box()), Any(Sphere<N, T>{point(), size()}), Any(convex_hull<N, T>(points(8)))}));
      std::vector<std::array<std::uint32_t, 3>> faces(12);
      for (auto& face : faces) {
        for (std::uint32_t& vertex : face) vertex = static_cast<std::uint32_t>(below(corners.size()));
      }
      pool_.push_back(mesh_of<N, T>(corners, faces, i % 2 == 0 ? MeshKind::surface : MeshKind::solid));
    }
  }

  detail::LinearCongruential random_;
  std::vector<Any> pool_;
};

}  // namespace graze::answers
