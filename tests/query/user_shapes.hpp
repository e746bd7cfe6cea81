// SPDX-License-Identifier: MIT
// Shapes as a user of graze would write them, in a namespace of their own: only `support`, in their own number type.
#pragma once

#include <cmath>

#include <graze/math/vec.hpp>

namespace user {

/// |x / radii| <= 1.
template <class T>
struct Ellipsoid {
  graze::Vec<3, T> center;
  graze::Vec<3, T> radii;
};

template <class T>
graze::Vec<3, T> support(const Ellipsoid<T>& egg, const graze::Vec<3, T>& direction) {
  const graze::Vec<3, T> scaled = egg.radii * direction;
  return egg.center + egg.radii * scaled / std::sqrt(dot(scaled, scaled));
}

/// The sum of (|x_i| / radii_i)^4 <= 1: a box with rounded edges. With q = 4/3, x_i = radii_i u_i^(1/3) / |u|_q^(1/3)
/// where u = radii * direction.
template <class T>
struct Superellipsoid {
  graze::Vec<3, T> center;
  graze::Vec<3, T> radii;
};

template <class T>
graze::Vec<3, T> support(const Superellipsoid<T>& soap, const graze::Vec<3, T>& direction) {
  const graze::Vec<3, T> u = soap.radii * direction / graze::max_abs(direction);
  graze::Vec<3, T> roots;
  T sum = 0;
  for (graze::Dim i = 0; i < 3; ++i) {
    roots[i] = std::cbrt(u[i]);
    sum += roots[i] * u[i];
  }
  return soap.center + soap.radii * roots / std::sqrt(std::sqrt(sum));
}

/// Around the z axis, from z = center.z - half_height to center.z + half_height.
template <class T>
struct Cylinder {
  graze::Vec<3, T> center;
  T radius;
  T half_height;
};

template <class T>
graze::Vec<3, T> support(const Cylinder<T>& can, const graze::Vec<3, T>& direction) {
  const T across = std::hypot(direction.x, direction.y);
  const T scale = across > T(0) ? can.radius / across : T(0);
  return can.center + graze::Vec<3, T>(direction.x * scale, direction.y * scale,
                                       direction.z > T(0) ? can.half_height : -can.half_height);
}

/// A disc of `radius` around base, normal to z, and a tip above it.
template <class T>
struct Cone {
  graze::Vec<3, T> base;
  T radius;
  T height;
};

template <class T>
graze::Vec<3, T> support(const Cone<T>& hat, const graze::Vec<3, T>& direction) {
  const T across = std::hypot(direction.x, direction.y);
  const T scale = across > T(0) ? hat.radius / across : T(0);
  const graze::Vec<3, T> rim = hat.base + graze::Vec<3, T>(direction.x * scale, direction.y * scale, T(0));
  const graze::Vec<3, T> tip = hat.base + graze::Vec<3, T>(T(0), T(0), hat.height);
  return dot(tip, direction) > dot(rim, direction) ? tip : rim;
}

/// Not a valid shape: returns a fixed answer for every direction.
template <class T>
struct Liar {
  graze::Vec<3, T> answer;
};

template <class T>
graze::Vec<3, T> support(const Liar<T>& liar, const graze::Vec<3, T>&) {
  return liar.answer;
}

/// Not a valid shape either: every answer is another point, none of them farthest.
struct Chaos {
  mutable unsigned state = 1;
};

inline graze::Vec<3, double> support(const Chaos& chaos, const graze::Vec<3, double>&) {
  graze::Vec<3, double> point;
  for (graze::Dim i = 0; i < 3; ++i) {
    chaos.state = chaos.state * 1664525U + 1013904223U;
    point[i] = static_cast<double>(chaos.state) / 2147483648.0 - 1.0;
  }
  return point;
}

}  // namespace user
