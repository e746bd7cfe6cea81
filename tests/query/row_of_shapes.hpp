// SPDX-License-Identifier: MIT
// One shape of each type that extends from x = -1 to x = 1 (unbounded ones: only on one side) on the x axis: any two of
// them touch at one known point.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test {

/// The type with this index in AnyShape: a point at (side, 0), or a shape that ends at x = side; `side` is 1 or -1.
/// `size` scales it about the origin.
template <Dim N, class T>
AnyShape<N, T> row_shape(std::size_t type, T side, T size = T(1)) {
  using V = Vec<N, T>;
  const V end = unit_axis<N, T>(0) * (side * size);
  const V up = unit_axis<N, T>(1) * size;
  Mat<N, T> quarter_turn(T(1));
  quarter_turn[0] = unit_axis<N, T>(1);
  quarter_turn[1] = -unit_axis<N, T>(0);
  V tall(size);
  tall[0] = 2 * size;
  std::vector<V> corners{end, -end};
  for (Dim i = 1; i < N; ++i) {
    corners.push_back(unit_axis<N, T>(i) * size);
    corners.push_back(unit_axis<N, T>(i) * -size);
  }
  const std::array<AnyShape<N, T>, 11> simple = {
      end,
      Segment<N, T>{-end, end},
      Ray<N, T>{end, -end},
      Sphere<N, T>{V(T(0)), size},
      Aabb<N, T>{V(-size), V(size)},
      Obb<N, T>{V(T(0)), tall, quarter_turn},
      Plane<N, T>{end, size * size},
      HalfSpace<N, T>{end, size * size},
      Triangle<N, T>{end, -end + up, -end - up},
      Capsule<N, T>{up, -up, size},
      convex_hull<N, T>(corners),
  };
  static_assert(simple.size() + 2 == shape_type_names.size(),
                "tests/query/row_of_shapes.hpp has a row of one shape of each type: add the new one");
  if (type < simple.size()) return simple[type];
  if (type == simple.size()) return compound_of<N, T>({simple[3], Sphere<N, T>{end * T(-3), size}});
  const auto& triangle = std::get<Triangle<N, T>>(simple[8]);
  const std::array<V, 4> vertices = {triangle.a, triangle.b, triangle.c, triangle.b + triangle.c - triangle.a};
  return mesh_of<N, T>(vertices, std::array<std::array<std::uint32_t, 3>, 2>{{{0, 1, 2}, {3, 2, 1}}});
}

inline constexpr std::size_t row_types = shape_type_names.size();

}  // namespace graze::test
