// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <variant>

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/detail/gjk_solver_indep.h>
#include <fcl/narrowphase/detail/traversal/collision/intersect.h>

#include <graze/math/vec.hpp>

#include "exam/fcl_shapes.hpp"
#include "exam/rival.hpp"

namespace graze::exam {
namespace {

// Where FCL has no closed form, it can use its own GJK or, by default, libccd's portal refinement. The latter has no
// iteration limit: for a box and a triangle among these cases, in double, it had not returned after more than a minute.
// So its own GJK is used here.

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
Proximity parting(T depth, const fcl::Vector3<T>& normal) {
  return {true, std::fabs(static_cast<double>(depth)), Vec<3, double>(normal[0], normal[1], normal[2]), true};
}

template <class Shape, class T>
Proximity parting(const Placed<Shape, T>& a, const Triangle<3, T>& b) {
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
Proximity parting(const Placed<First, T>& a, const Placed<Second, T>& b) {
  fcl::CollisionRequest<T> request(1, true);
  request.gjk_solver_type = fcl::GST_INDEP;
  fcl::CollisionResult<T> result;
  if (fcl::collide(&a.shape, a.pose, &b.shape, b.pose, request, result) == 0) return {};
  const fcl::Contact<T>& contact = result.getContact(0);
  return parting(contact.penetration_depth, contact.normal);
}

template <class T>
PatchPoint patch_point(T depth, const fcl::Vector3<T>& place) {
  return {Vec<3, double>(place[0], place[1], place[2]), std::fabs(static_cast<double>(depth))};
}

template <class Shape, class T>
ContactPatch patch(const Placed<Shape, T>& a, const Triangle<3, T>& b) {
  const fcl::detail::GJKSolver_indep<T> solver;
  fcl::Vector3<T> point;
  fcl::Vector3<T> normal;
  T depth = 0;
  const bool meets =
      solver.shapeTriangleIntersect(a.shape, a.pose, vector(b.a), vector(b.b), vector(b.c), &point, &depth, &normal);
  return meets ? ContactPatch{patch_point(depth, point)} : ContactPatch{};
}

template <class First, class Second, class T>
ContactPatch patch(const Placed<First, T>& a, const Placed<Second, T>& b) {
  constexpr std::size_t most_contacts = 8;
  fcl::CollisionRequest<T> request(most_contacts, true);
  request.gjk_solver_type = fcl::GST_INDEP;
  fcl::CollisionResult<T> result;
  fcl::collide(&a.shape, a.pose, &b.shape, b.pose, request, result);
  ContactPatch points;
  for (std::size_t i = 0; i < result.numContacts(); ++i) {
    const fcl::Contact<T>& contact = result.getContact(i);
    points.push_back(patch_point(contact.penetration_depth, contact.pos));
  }
  return points;
}

template <class T>
std::optional<bool> answer(const Solid3<T>& a, const Solid3<T>& b) {
  return std::visit(
      [](const auto& held_a, const auto& held_b) -> std::optional<bool> {
        using A = std::decay_t<decltype(held_a)>;
        using B = std::decay_t<decltype(held_b)>;
        if constexpr (is_triangle<A> && is_triangle<B>) {
          return meet(held_a, held_b);
        } else if constexpr ((is_plane_or_half_space<A> && is_plane_or_half_space<B>) ||
                             (is_plane_or_half_space<A> && is_triangle<B>)) {
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
std::optional<Proximity> parting_of(const Solid3<T>& a, const Solid3<T>& b) {
  return std::visit(
      [](const auto& held_a, const auto& held_b) -> std::optional<Proximity> {
        using A = std::decay_t<decltype(held_a)>;
        using B = std::decay_t<decltype(held_b)>;
        if constexpr ((is_plane_or_half_space<A> && is_plane_or_half_space<B>) ||
                      (is_plane_or_half_space<A> && is_triangle<B>)) {
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

template <class T>
std::optional<ContactPatch> patch_of(const Solid3<T>& a, const Solid3<T>& b) {
  return std::visit(
      [](const auto& held_a, const auto& held_b) -> std::optional<ContactPatch> {
        using A = std::decay_t<decltype(held_a)>;
        using B = std::decay_t<decltype(held_b)>;
        if constexpr ((is_plane_or_half_space<A> && is_plane_or_half_space<B>) ||
                      (is_plane_or_half_space<A> && is_triangle<B>)) {
          return std::nullopt;
        } else if constexpr (is_triangle<A> && requires { placed(held_b); }) {
          return patch(placed(held_b), held_a);
        } else if constexpr (is_triangle<B> && requires { placed(held_a); }) {
          return patch(placed(held_a), held_b);
        } else if constexpr (requires { placed(held_a), placed(held_b); }) {
          return patch(placed(held_a), placed(held_b));
        } else {
          return std::nullopt;
        }
      },
      a, b);
}

}  // namespace

std::optional<bool> fcl_answer(const Solid3<float>& a, const Solid3<float>& b) { return answer<float>(a, b); }
std::optional<bool> fcl_answer(const Solid3<double>& a, const Solid3<double>& b) { return answer<double>(a, b); }

std::optional<Proximity> fcl_parting(const Solid3<float>& a, const Solid3<float>& b) { return parting_of<float>(a, b); }
std::optional<Proximity> fcl_parting(const Solid3<double>& a, const Solid3<double>& b) {
  return parting_of<double>(a, b);
}

std::optional<ContactPatch> fcl_patch(const Solid3<float>& a, const Solid3<float>& b) { return patch_of<float>(a, b); }
std::optional<ContactPatch> fcl_patch(const Solid3<double>& a, const Solid3<double>& b) {
  return patch_of<double>(a, b);
}

}  // namespace graze::exam
