// SPDX-License-Identifier: MIT
// Shapes from a fuzzer's bytes: of every type, valid or not.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/description.hpp>

#include "catalogue.hpp"
#include "fuzz/input.hpp"

namespace graze::test::fuzz {

/// A quarter turn in half of the cases, otherwise any, about each axis; sometimes nine arbitrary numbers.
template <Dim N, class T>
Mat<N, T> rotation(Input& input) {
  constexpr int wild = 15;
  const std::size_t kind = input.below(wild + 1);
  Mat<N, T> matrix(T(1));
  if (kind == wild) {
    for (Dim i = 0; i < N; ++i) matrix[i] = input.vec<N, T>();
    return matrix;
  }
  const auto turn = [&] {
    return direction_of(kind < 8 ? static_cast<int>(input.below(4)) - 1.0 : input.whole() / 64.0);
  };
  if constexpr (N == 2) {
    const Vec<2, double> way = turn();
    return rounded<2, T>(Mat<2, double>(way, Vec<2, double>(-way.y, way.x)));
  } else {
    Mat<3, double> product(1.0);
    for (const Dim axis : {2, 0, 2}) {
      const Vec<2, double> way = turn();
      Mat<3, double> step(1.0);
      const Dim next = (axis + 1) % 3;
      const Dim last = (axis + 2) % 3;
      step[next][next] = step[last][last] = way.x;
      step[next][last] = way.y;
      step[last][next] = -way.y;
      product = step * product;
    }
    return rounded<3, T>(product);
  }
}

/// Up to this many points, possibly with duplicates.
template <Dim N, class T>
std::vector<Vec<N, T>> points(Input& input, std::size_t most) {
  std::vector<Vec<N, T>> result(1 + input.below(most));
  for (Vec<N, T>& point : result) point = input.vec<N, T>();
  return result;
}

template <class S>
void fill(Input& input, S& shape) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  const auto set = [&](auto& field) {
    using Field = std::remove_reference_t<decltype(field)>;
    if constexpr (std::is_same_v<Field, T>) {
      field = input.number<T>();
    } else if constexpr (std::is_same_v<Field, Vec<N, T>>) {
      field = input.vec<N, T>();
    } else {
      field = rotation<N, T>(input);
    }
  };
  detail::for_each_field(shape, [&](const auto&, auto& field) { set(field); });
}

/// From finite numbers: convex_hull rejects others.
template <Dim N, class T>
void fill(Input& input, Polytope<N, T>& polytope) {
  std::vector<Vec<N, T>> corners = points<N, T>(input, 10);
  for (Vec<N, T>& corner : corners) {
    if (!is_finite(corner)) corner = Vec<N, T>(T(0));
  }
  polytope = convex_hull<N, T>(corners);
}

/// A surface, which the oracle knows, of finite vertices: mesh_of refuses others.
template <Dim N, class T>
void fill(Input& input, Mesh<N, T>& mesh) {
  std::vector<Vec<N, T>> vertices = points<N, T>(input, 8);
  for (Vec<N, T>& vertex : vertices) {
    if (!is_finite(vertex)) vertex = Vec<N, T>(T(0));
  }
  std::vector<std::array<std::uint32_t, 3>> faces(vertices.empty() ? 0 : input.below(6));
  for (std::array<std::uint32_t, 3>& face : faces) {
    for (std::uint32_t& vertex : face) vertex = static_cast<std::uint32_t>(input.below(vertices.size()));
  }
  mesh = mesh_of<N, T>(vertices, faces);
}

template <Dim N, class T>
AnyShape<N, T> any_shape(Input& input, int depth = 1);

template <Dim N, class T>
void fill(Input& input, Compound<N, T>& compound, int depth) {
  std::vector<AnyShape<N, T>> parts;
  for (std::size_t count = input.below(4); count > 0; --count) parts.push_back(any_shape<N, T>(input, depth - 1));
  compound = compound_of<N, T>(std::move(parts));
}

template <Dim N, class T>
AnyShape<N, T> any_shape(Input& input, int depth) {
  constexpr std::size_t types = std::variant_size_v<AnyShape<N, T>>;
  const std::size_t type = input.below(types);
  AnyShape<N, T> shape;
  [&]<std::size_t... Indices>(std::index_sequence<Indices...>) {
    const auto make = [&]<std::size_t index>(std::integral_constant<std::size_t, index>) {
      if (index != type) return;
      auto& held = shape.template emplace<index>();
      if constexpr (std::is_same_v<std::decay_t<decltype(held)>, Compound<N, T>>) {
        if (depth > 0) fill(input, held, depth);
      } else {
        fill(input, held);
      }
    };
    (make(std::integral_constant<std::size_t, Indices>()), ...);
  }
  (std::make_index_sequence<types>());
  return shape;
}

/// Two shapes for which queries guarantee results: valid, with numbers in range.
template <Dim N, class T>
struct ShapePair {
  AnyShape<N, T> a;
  AnyShape<N, T> b;
  bool is_judged;

  explicit ShapePair(Input& input) : a(any_shape<N, T>(input)), b(any_shape<N, T>(input)) {
    is_judged = input.is_in_range() && is_valid(a) && is_valid(b);
  }

  friend std::ostream& operator<<(std::ostream& out, const ShapePair& pair) {
    return out << to_source<N, T>(pair.a) << ", " << to_source<N, T>(pair.b);
  }
};

}  // namespace graze::test::fuzz
