// SPDX-License-Identifier: MIT
#include <exception>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include <fcl/narrowphase/detail/gjk_solver_indep.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>
#include <fcl/narrowphase/detail/primitive_shape_algorithm/triangle_distance.h>

#include <graze/math/vec.hpp>

#include "exam/fcl_shapes.hpp"
#include "exam/rival.hpp"

namespace graze::exam {
namespace {

template <class T>
Vec<3, double> wide_point(const fcl::Vector3<T>& v) {
  return {v[0], v[1], v[2]};
}

/// FCL's distance of intersecting shapes is -1, or 0.
template <class T>
Separation separation(T distance, const fcl::Vector3<T>& on_a, const fcl::Vector3<T>& on_b) {
  return {distance <= 0, static_cast<double>(distance), wide_point(on_a), wide_point(on_b)};
}

Separation exchanged(Separation found) {
  std::swap(found.point_a, found.point_b);
  return found;
}

template <class Solver, class T>
Separation apart(const Triangle<3, T>& a, const Triangle<3, T>& b) {
  fcl::Vector3<T> on_a = fcl::Vector3<T>::Zero();
  fcl::Vector3<T> on_b = fcl::Vector3<T>::Zero();
  const T distance = fcl::detail::TriangleDistance<T>::triDistance(vector(a.a), vector(a.b), vector(a.c), vector(b.a),
                                                                   vector(b.b), vector(b.c), on_a, on_b);
  return separation<T>(distance, on_a, on_b);
}

template <class Solver, class Shape, class T>
Separation apart(const Placed<Shape, T>& a, const Triangle<3, T>& b) {
  const Solver solver;
  T distance = 0;
  fcl::Vector3<T> on_a = fcl::Vector3<T>::Zero();
  fcl::Vector3<T> on_b = fcl::Vector3<T>::Zero();
  solver.shapeTriangleDistance(a.shape, a.pose, vector(b.a), vector(b.b), vector(b.c), &distance, &on_a, &on_b);
  return separation<T>(distance, on_a, on_b);
}

template <class Solver, class First, class Second, class T>
Separation apart(const Placed<First, T>& a, const Placed<Second, T>& b) {
  const Solver solver;
  T distance = 0;
  fcl::Vector3<T> on_a = fcl::Vector3<T>::Zero();
  fcl::Vector3<T> on_b = fcl::Vector3<T>::Zero();
  solver.shapeDistance(a.shape, a.pose, b.shape, b.pose, &distance, &on_a, &on_b);
  return separation<T>(distance, on_a, on_b);
}

template <class Solver, class T>
std::optional<Separation> separation_of(const Solid3<T>& a, const Solid3<T>& b) {
  return std::visit(
      [](const auto& held_a, const auto& held_b) -> std::optional<Separation> {
        using A = std::decay_t<decltype(held_a)>;
        using B = std::decay_t<decltype(held_b)>;
        if constexpr (is_plane_or_half_space<A> || is_plane_or_half_space<B>) {
          return std::nullopt;
        } else if constexpr (is_triangle<A> && is_triangle<B>) {
          return apart<Solver>(held_a, held_b);
        } else if constexpr (is_triangle<A> && requires { placed(held_b); }) {
          return exchanged(apart<Solver>(placed(held_b), held_a));
        } else if constexpr (is_triangle<B> && requires { placed(held_a); }) {
          return apart<Solver>(placed(held_a), held_b);
        } else if constexpr (requires { placed(held_a), placed(held_b); }) {
          return apart<Solver>(placed(held_a), placed(held_b));
        } else {
          return std::nullopt;
        }
      },
      a, b);
}

/// Some of its steps throw if they reach an unexpected simplex.
template <class Solver, class T>
std::optional<Separation> answer(const Solid3<T>& a, const Solid3<T>& b) {
  try {
    return separation_of<Solver, T>(a, b);
  } catch (const std::exception&) {
    return Separation{false, std::numeric_limits<double>::quiet_NaN()};
  }
}

}  // namespace

std::optional<Separation> fcl_separation(const Solid3<float>& a, const Solid3<float>& b) {
  return answer<fcl::detail::GJKSolver_indep<float>, float>(a, b);
}
std::optional<Separation> fcl_separation(const Solid3<double>& a, const Solid3<double>& b) {
  return answer<fcl::detail::GJKSolver_indep<double>, double>(a, b);
}

std::optional<Separation> fcl_separation_by_libccd(const Solid3<float>& a, const Solid3<float>& b) {
  return answer<fcl::detail::GJKSolver_libccd<float>, float>(a, b);
}

}  // namespace graze::exam
