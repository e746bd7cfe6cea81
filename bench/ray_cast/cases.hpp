// SPDX-License-Identifier: MIT
// Random shapes of about unit size near the origin, and rays from outside towards them.
#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/contains.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::ray_bench {

/// The length of rays in t: twice as far as the point that each is aimed at, and so past every bounded shape.
inline constexpr float t_max = 2;

class Random {
 public:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

  template <Dim N>
  Vec<N, double> vector(double size) {
    Vec<N, double> v(0.0);
    for (Dim i = 0; i < N; ++i) v[i] = number(-size, size);
    return v;
  }

  /// At least a tenth of the size.
  template <Dim N>
  Vec<N, double> way(double size) {
    Vec<N, double> v = vector<N>(size);
    while (dot(v, v) < 0.01 * size * size) v = vector<N>(size);
    return v;
  }

  template <Dim N>
  Mat<N, double> rotation() {
    if constexpr (N == 2)
      return rotation_matrix(number(0, 360));
    else
      return rotation_matrix(way<3>(1), number(0, 360));
  }

 private:
  std::mt19937 engine_{20261122};
};

template <Dim N, class T>
void draw(Random& random, Ray<N, T>& ray) {
  const Vec<N, double> way = random.way<N>(1);
  const Vec<N, double> origin = way * (3 / std::sqrt(dot(way, way)));
  ray = {Vec<N, T>(origin), Vec<N, T>(random.vector<N>(1) - origin)};
}
template <Dim N, class T>
void draw(Random& random, Vec<N, T>& point) {
  point = Vec<N, T>(random.vector<N>(1));
}
template <Dim N, class T>
void draw(Random& random, Segment<N, T>& segment) {
  segment = {Vec<N, T>(random.vector<N>(1)), Vec<N, T>(random.vector<N>(1))};
}
template <Dim N, class T>
void draw(Random& random, Sphere<N, T>& sphere) {
  sphere = {Vec<N, T>(random.vector<N>(1)), static_cast<T>(random.number(0.3, 1))};
}
template <Dim N, class T>
void draw(Random& random, Aabb<N, T>& box) {
  box = Aabb<N, T>::from_center(Vec<N, T>(random.vector<N>(1)), Vec<N, T>(abs(random.way<N>(1))));
}
template <Dim N, class T>
void draw(Random& random, Obb<N, T>& box) {
  const Mat<N, double> rotation = random.rotation<N>();
  box = {Vec<N, T>(random.vector<N>(1)), Vec<N, T>(abs(random.way<N>(1))), {}};
  for (Dim i = 0; i < N; ++i) box.axes[i] = Vec<N, T>(rotation[i]);
}
template <Dim N, class T>
void draw(Random& random, Plane<N, T>& plane) {
  plane = {Vec<N, T>(random.way<N>(1)), static_cast<T>(random.number(-0.5, 0.5))};
}
template <Dim N, class T>
void draw(Random& random, HalfSpace<N, T>& solid) {
  solid = {Vec<N, T>(random.way<N>(1)), static_cast<T>(random.number(-0.5, 0.5))};
}
template <Dim N, class T>
void draw(Random& random, Triangle<N, T>& triangle) {
  for (Vec<N, T>* corner : {&triangle.a, &triangle.b, &triangle.c}) *corner = Vec<N, T>(random.vector<N>(1.5));
}
template <Dim N, class T>
void draw(Random& random, Capsule<N, T>& capsule) {
  const Vec<N, double> a = random.vector<N>(1);
  capsule = {Vec<N, T>(a), Vec<N, T>(a + random.way<N>(1)), static_cast<T>(random.number(0.2, 0.6))};
}
/// With 32 corners in 3D, and 8 in 2D, the maximum of Box2D.
template <Dim N, class T>
void draw(Random& random, Polytope<N, T>& polytope) {
  std::vector<Vec<N, T>> points(N == 2 ? 8 : 32);
  for (Vec<N, T>& point : points) {
    const Vec<N, double> way = random.way<N>(1);
    point = Vec<N, T>(way / std::sqrt(dot(way, way)));
  }
  polytope = convex_hull<N, T>(points);
}
/// With six parts: spheres, oriented boxes and capsules, up to another unit apart.
template <Dim N, class T>
void draw(Random& random, Compound<N, T>& compound) {
  std::vector<AnyShape<N, T>> parts;
  const auto add = [&](auto part) {
    draw(random, part);
    parts.push_back(transformed(part, Pose<N, T>{Mat<N, T>(T(1)), Vec<N, T>(random.vector<N>(1))}));
  };
  for (int i = 0; i < 2; ++i) {
    add(Sphere<N, T>());
    add(Obb<N, T>());
    add(Capsule<N, T>());
  }
  compound = compound_of<N, T>(std::move(parts));
}

template <class S>
struct Case {
  S shape;
  Ray<dimension_of<S>, scalar_of<S>> ray;
};

template <class S>
std::vector<Case<S>> random_cases(std::size_t count) {
  std::vector<Case<S>> cases(count);
  Random random;
  for (Case<S>& one : cases) {
    draw(random, one.shape);
    draw(random, one.ray);
    // Rays begin outside of all shapes.
    if constexpr (std::is_same_v<S, HalfSpace<dimension_of<S>, scalar_of<S>>>) {
      if (contains(one.shape, one.ray.origin)) one.shape = {-one.shape.normal, -one.shape.offset};
    }
  }
  return cases;
}

}  // namespace graze::ray_bench
