// SPDX-License-Identifier: MIT
// Visits the vectors and numbers that a shape is made of, to change them.
#pragma once

#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>

#include "catalogue.hpp"

namespace graze::test {

/// Calls `visit(field)` for each field of a simple shape.
template <class S, class Visit>
void for_each_field(S& shape, const Visit& visit) {
  if constexpr (requires { Entry<S>::fields; }) {
    std::apply([&](auto... fields) { (visit(shape.*fields), ...); }, Entry<S>::fields);
  } else {
    visit(shape);
  }
}

/// Calls `visit(v)` for each vector that turns with the shape: corners, centers, axes, directions, normals. An
/// axis-aligned box is left in order.
template <Dim N, class T, class Visit>
void for_each_vector(AnyShape<N, T>& shape, const Visit& visit) {
  const auto in_field = [&](auto& field) {
    using Field = std::decay_t<decltype(field)>;
    if constexpr (std::is_same_v<Field, Vec<N, T>>) visit(field);
    if constexpr (std::is_same_v<Field, Mat<N, T>>) {
      for (Dim i = 0; i < N; ++i) visit(field[i]);
    }
  };
  if (auto* polytope = std::get_if<Polytope<N, T>>(&shape)) {
    std::vector<Vec<N, T>> points(polytope->vertices().begin(), polytope->vertices().end());
    for (Vec<N, T>& point : points) visit(point);
    shape = convex_hull<N, T>(points);
  } else if (auto* compound = std::get_if<Compound<N, T>>(&shape)) {
    std::vector<AnyShape<N, T>> parts;
    for (Part<N, T>& part : compound->parts) {
      for_each_vector<N, T>(part.shape, visit);
      parts.push_back(part.shape);
    }
    shape = compound_of<N, T>(std::move(parts));
  } else if (auto* box = std::get_if<Aabb<N, T>>(&shape)) {
    visit(box->min);
    visit(box->max);
    shape = Aabb<N, T>::from_corners(box->min, box->max);
  } else if (auto* oriented_box = std::get_if<Obb<N, T>>(&shape)) {
    visit(oriented_box->center);  // the half extents belong to the axes
    in_field(oriented_box->axes);
  } else {
    detail::visit(
        [&](auto& held) {
          using S = std::decay_t<decltype(held)>;
          if constexpr (!std::is_same_v<S, Polytope<N, T>> && !std::is_same_v<S, Compound<N, T>>) {
            for_each_field(held, in_field);
          }
        },
        shape);
  }
}

/// Calls `visit(x)` for each number of a shape that is not a polytope or a compound.
template <Dim N, class T, class Visit>
void for_each_number(AnyShape<N, T>& shape, const Visit& visit) {
  const auto in_field = [&](auto& field) {
    using Field = std::decay_t<decltype(field)>;
    if constexpr (std::is_same_v<Field, T>) visit(field);
    if constexpr (std::is_same_v<Field, Vec<N, T>>) {
      for (Dim i = 0; i < N; ++i) visit(field[i]);
    }
    if constexpr (std::is_same_v<Field, Mat<N, T>>) {
      for (Dim i = 0; i < N; ++i) {
        for (Dim j = 0; j < N; ++j) visit(field[i][j]);
      }
    }
  };
  detail::visit(
      [&](auto& held) {
        using S = std::decay_t<decltype(held)>;
        if constexpr (!std::is_same_v<S, Polytope<N, T>> && !std::is_same_v<S, Compound<N, T>>) {
          for_each_field(held, in_field);
        }
      },
      shape);
}

/// The shape scaled about the origin: every length times a power of two. Directions and normals stay.
template <Dim N, class T>
AnyShape<N, T> scaled(AnyShape<N, T> shape, T factor) {
  if (std::holds_alternative<Polytope<N, T>>(shape)) {
    for_each_vector<N, T>(shape, [factor](Vec<N, T>& v) { v *= factor; });
  } else if (auto* compound = std::get_if<Compound<N, T>>(&shape)) {
    std::vector<AnyShape<N, T>> parts;
    for (const Part<N, T>& part : compound->parts) parts.push_back(scaled<N, T>(part.shape, factor));
    shape = compound_of<N, T>(std::move(parts));
  } else if (auto* ray = std::get_if<Ray<N, T>>(&shape)) {
    ray->origin *= factor;
  } else if (auto* plane = std::get_if<Plane<N, T>>(&shape)) {
    plane->offset *= factor;
  } else if (auto* solid = std::get_if<HalfSpace<N, T>>(&shape)) {
    solid->offset *= factor;
  } else if (auto* box = std::get_if<Obb<N, T>>(&shape)) {
    box->center *= factor;
    box->half_extents *= factor;
  } else {
    for_each_number<N, T>(shape, [factor](T& x) { x *= factor; });
  }
  return shape;
}

}  // namespace graze::test
