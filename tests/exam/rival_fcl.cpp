// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>
#include <optional>
#include <variant>

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/detail/gjk_solver_indep.h>
#include <fcl/narrowphase/detail/traversal/collision/intersect.h>

#include <graze/math/vec.hpp>

#include "exam/contact_rival.hpp"
#include "exam/rival.hpp"

namespace graze::exam {
namespace {

template <class T>
fcl::Vector3<T> vector(const Vec<3, T>& v) {
  return {v.x, v.y, v.z};
}

/// One of FCL's shapes, and where it is.
template <class Shape, class T>
struct Placed {
  Shape shape;
  fcl::Transform3<T> pose = fcl::Transform3<T>::Identity();
};

template <class Shape, class T>
Placed<Shape, T> placed_at(const Shape& shape, const fcl::Vector3<T>& center) {
  Placed<Shape, T> placed{shape};
  placed.pose.translation() = center;
  return placed;
}

template <class T>
auto placed(const Sphere<3, T>& sphere) {
  return placed_at<fcl::Sphere<T>, T>(fcl::Sphere<T>(sphere.radius), vector(sphere.center));
}

template <class T>
auto placed(const Aabb<3, T>& box) {
  const Vec<3, T> center = (box.min + box.max) * T(0.5);
  return placed_at<fcl::Box<T>, T>(fcl::Box<T>(vector<T>(box.max - box.min)), vector(center));
}

template <class T>
auto placed(const Obb<3, T>& box) {
  auto result = placed_at<fcl::Box<T>, T>(fcl::Box<T>(vector<T>(box.half_extents * T(2))), vector(box.center));
  for (Dim i = 0; i < 3; ++i) result.pose.linear().col(static_cast<int>(i)) = vector<T>(box.axes[i]);
  return result;
}

/// FCL's capsules stand along z.
template <class T>
auto placed(const Capsule<3, T>& capsule) {
  const fcl::Vector3<T> way = vector<T>(capsule.b - capsule.a);
  const Vec<3, T> center = (capsule.a + capsule.b) * T(0.5);
  auto result = placed_at<fcl::Capsule<T>, T>(fcl::Capsule<T>(capsule.radius, way.norm()), vector(center));
  if (way.norm() > 0) {
    result.pose.linear() = Eigen::Quaternion<T>::FromTwoVectors(fcl::Vector3<T>::UnitZ(), way).toRotationMatrix();
  }
  return result;
}

template <class T>
auto placed(const Plane<3, T>& plane) {
  return Placed<fcl::Plane<T>, T>{fcl::Plane<T>(vector(plane.normal), plane.offset)};
}

template <class T>
auto placed(const HalfSpace<3, T>& solid) {
  return Placed<fcl::Halfspace<T>, T>{fcl::Halfspace<T>(vector(solid.normal), solid.offset)};
}

// Where FCL has no closed form it can use its own GJK or, by default, libccd's portal refinement. The latter has no
// limit to its steps: among these cases it had not returned from a box and a triangle, in double, after more than a
// minute. So it is its own GJK here.

template <class T>
bool meet(const Triangle<3, T>& a, const Triangle<3, T>& b) {
  return fcl::detail::Intersect<T>::intersect_Triangle(vector(a.a), vector(a.b), vector(a.c), vector(b.a), vector(b.b),
                                                       vector(b.c));
}

template <class Shape, class T>
bool meet(const Placed<Shape, T>& a, const Triangle<3, T>& b) {
  const fcl::detail::GJKSolver_indep<T> solver;
  return solver.shapeTriangleIntersect(a.shape, a.pose, vector(b.a), vector(b.b), vector(b.c));
}

template <class First, class Second, class T>
bool meet(const Placed<First, T>& a, const Placed<Second, T>& b) {
  fcl::CollisionRequest<T> request;
  request.gjk_solver_type = fcl::GST_INDEP;
  fcl::CollisionResult<T> result;
  return fcl::collide(&a.shape, a.pose, &b.shape, b.pose, request, result) > 0;
}

template <class T>
Parting parting(T depth, const fcl::Vector3<T>& normal) {
  return {true, std::fabs(static_cast<double>(depth)), Vec<3, double>(normal[0], normal[1], normal[2]), true};
}

template <class Shape, class T>
Parting parting(const Placed<Shape, T>& a, const Triangle<3, T>& b) {
  const fcl::detail::GJKSolver_indep<T> solver;
  fcl::Vector3<T> point;
  fcl::Vector3<T> normal;
  T depth = 0;
  const bool meets =
      solver.shapeTriangleIntersect(a.shape, a.pose, vector(b.a), vector(b.b), vector(b.c), &point, &depth, &normal);
  if (!meets) return {};
  return parting(depth, normal);
}

template <class First, class Second, class T>
Parting parting(const Placed<First, T>& a, const Placed<Second, T>& b) {
  fcl::CollisionRequest<T> request(1, true);
  request.gjk_solver_type = fcl::GST_INDEP;
  fcl::CollisionResult<T> result;
  if (fcl::collide(&a.shape, a.pose, &b.shape, b.pose, request, result) == 0) return {};
  const fcl::Contact<T>& contact = result.getContact(0);
  return parting(contact.penetration_depth, contact.normal);
}

template <class S>
constexpr bool is_triangle = false;
template <class T>
constexpr bool is_triangle<Triangle<3, T>> = true;
template <class S>
constexpr bool is_level = false;
template <class T>
constexpr bool is_level<Plane<3, T>> = true;
template <class T>
constexpr bool is_level<HalfSpace<3, T>> = true;

template <class T>
std::optional<bool> answer(const Solid3<T>& a, const Solid3<T>& b) {
  return std::visit(
      [](const auto& held_a, const auto& held_b) -> std::optional<bool> {
        using A = std::decay_t<decltype(held_a)>;
        using B = std::decay_t<decltype(held_b)>;
        if constexpr (is_triangle<A> && is_triangle<B>) {
          return meet(held_a, held_b);
        } else if constexpr ((is_level<A> && is_level<B>) || (is_level<A> && is_triangle<B>)) {
          return std::nullopt;
        } else if constexpr (is_triangle<A> && requires { placed(held_b); }) {
          return meet(placed(held_b), held_a);
        } else if constexpr (is_triangle<B> && requires { placed(held_a); }) {
          return meet(placed(held_a), held_b);
        } else if constexpr (requires { placed(held_a), placed(held_b); }) {
          return meet(placed(held_a), placed(held_b));
        } else {
          return std::nullopt;
        }
      },
      a, b);
}

template <class T>
std::optional<Parting> parting_of(const Solid3<T>& a, const Solid3<T>& b) {
  return std::visit(
      [](const auto& held_a, const auto& held_b) -> std::optional<Parting> {
        using A = std::decay_t<decltype(held_a)>;
        using B = std::decay_t<decltype(held_b)>;
        if constexpr ((is_level<A> && is_level<B>) || (is_level<A> && is_triangle<B>)) {
          return std::nullopt;
        } else if constexpr (is_triangle<A> && requires { placed(held_b); }) {
          return parting(placed(held_b), held_a);  // the normal has no sign
        } else if constexpr (is_triangle<B> && requires { placed(held_a); }) {
          return parting(placed(held_a), held_b);
        } else if constexpr (requires { placed(held_a), placed(held_b); }) {
          return parting(placed(held_a), placed(held_b));
        } else {
          return std::nullopt;
        }
      },
      a, b);
}

}  // namespace

std::optional<bool> fcl_answer(const Solid3<float>& a, const Solid3<float>& b) { return answer<float>(a, b); }
std::optional<bool> fcl_answer(const Solid3<double>& a, const Solid3<double>& b) { return answer<double>(a, b); }

std::optional<Parting> fcl_parting(const Solid3<float>& a, const Solid3<float>& b) { return parting_of<float>(a, b); }
std::optional<Parting> fcl_parting(const Solid3<double>& a, const Solid3<double>& b) {
  return parting_of<double>(a, b);
}

}  // namespace graze::exam
