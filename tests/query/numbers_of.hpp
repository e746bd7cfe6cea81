// SPDX-License-Identifier: MIT
// Visits the vectors and numbers of a shape, to change them.
#pragma once

#include <utility>
#include <variant>
#include <vector>

#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/visit.hpp>

#include "catalogue.hpp"
#include "parts_of.hpp"

namespace graze::test {

using detail::FieldKind;

/// Calls `visit(v)` for each vector that rotates with the shape: corners, centers, axes, directions, normals. An AABB
/// keeps min below max.
template <Dim N, class T, class Visit>
void for_each_vector(AnyShape<N, T>& shape, const Visit& visit) {
  const auto in_field = [&]<class Field>(const Field&, auto& value) {
    if constexpr (Field::kind == FieldKind::point || Field::kind == FieldKind::direction) visit(value);
    if constexpr (Field::kind == FieldKind::axes) {
      for (Dim i = 0; i < N; ++i) visit(value[i]);
    }
  };
  if (auto* polytope = std::get_if<Polytope<N, T>>(&shape)) {
    std::vector<Vec<N, T>> points(polytope->vertices().begin(), polytope->vertices().end());
    for (Vec<N, T>& point : points) visit(point);
    shape = convex_hull<N, T>(points);
  } else if (const auto* mesh = std::get_if<Mesh<N, T>>(&shape)) {
    shape = with_vertices_changed(*mesh, [&visit](Vec<N, T> vertex) {
      visit(vertex);
      return vertex;
    });
  } else if (auto* compound = std::get_if<Compound<N, T>>(&shape)) {
    std::vector<AnyShape<N, T>> parts;
    for (Part<N, T>& part : compound->parts) {
      for_each_vector<N, T>(part.shape, visit);
      parts.push_back(part.shape);
    }
    shape = compound_of<N, T>(std::move(parts));
  } else {
    detail::visit([&](auto& held) { detail::for_each_field(held, in_field); }, shape);
    if (auto* box = std::get_if<Aabb<N, T>>(&shape)) *box = Aabb<N, T>::from_corners(box->min, box->max);
  }
}

/// Calls `visit(x)` for each number of a shape that is not a polytope, a mesh or a compound, if `takes` accepts its
/// kind of field.
template <Dim N, class T, class Visit, class Takes>
void for_each_number_in(AnyShape<N, T>& shape, const Visit& visit, const Takes& takes) {
  const auto in_field = [&]<class Field>(const Field&, auto& value) {
    if constexpr (!detail::is_read_only(Field::kind) && Field::kind != FieldKind::parts) {
      if (takes(Field::kind)) detail::for_each_number(value, visit);
    }
  };
  detail::visit([&](auto& held) { detail::for_each_field(held, in_field); }, shape);
}

/// The same for all fields.
template <Dim N, class T, class Visit>
void for_each_number(AnyShape<N, T>& shape, const Visit& visit) {
  for_each_number_in<N, T>(shape, visit, [](FieldKind) { return true; });
}

/// The shape with every length replaced by change(length), also for polytopes and compounds. Directions, normals and
/// axes are unchanged.
template <Dim N, class T, class Change>
AnyShape<N, T> with_lengths(AnyShape<N, T> shape, const Change& change) {
  if (const auto* polytope = std::get_if<Polytope<N, T>>(&shape)) {
    std::vector<Vec<N, T>> points(polytope->vertices().begin(), polytope->vertices().end());
    for (Vec<N, T>& point : points) {
      for (Dim i = 0; i < N; ++i) point[i] = change(point[i]);
    }
    return convex_hull_in_order<N, T>(points);
  }
  if (const auto* mesh = std::get_if<Mesh<N, T>>(&shape)) {
    return with_vertices_changed(*mesh, [&change](Vec<N, T> vertex) {
      for (Dim i = 0; i < N; ++i) vertex[i] = change(vertex[i]);
      return vertex;
    });
  }
  if (const auto compound = parts_of<N, T>(shape)) {
    std::vector<AnyShape<N, T>> parts;
    for (const Part<N, T>& part : compound->parts) parts.push_back(with_lengths<N, T>(part.shape, change));
    return compound_of<N, T>(std::move(parts));
  }
  for_each_number_in<N, T>(
      shape, [&change](T& x) { x = change(x); },
      [](FieldKind kind) { return kind != FieldKind::direction && kind != FieldKind::axes; });
  return shape;
}

/// The shape scaled about the origin: every length times a power of two.
template <Dim N, class T>
AnyShape<N, T> scaled(const AnyShape<N, T>& shape, T factor) {
  return with_lengths<N, T>(shape, [factor](T x) { return x * factor; });
}

}  // namespace graze::test
