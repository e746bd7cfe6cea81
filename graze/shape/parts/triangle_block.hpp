// SPDX-License-Identifier: MIT
// Sixteen triangles side by side.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include <graze/math/lanes/sixteen.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/parts/box_block.hpp>
#include <graze/shape/parts/grown_box.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

/// One row for each coordinate of the corners. Default: not set.
template <Dim N, class T>
struct alignas(64) TriangleBlock {
  using Corners = std::array<Row<T>, static_cast<std::size_t>(N)>;
  std::array<Corners, 3> corners;

  Triangle<N, T> triangle(std::size_t lane) const {
    Triangle<N, T> result;
    for (Dim i = 0; i < N; ++i) {
      const auto k = static_cast<std::size_t>(i);
      result.a[i] = corners[0][k][lane];
      result.b[i] = corners[1][k][lane];
      result.c[i] = corners[2][k][lane];
    }
    return result;
  }

  void set(std::size_t lane, const Triangle<N, T>& triangle) {
    for (Dim i = 0; i < N; ++i) {
      const auto k = static_cast<std::size_t>(i);
      corners[0][k][lane] = triangle.a[i];
      corners[1][k][lane] = triangle.b[i];
      corners[2][k][lane] = triangle.c[i];
    }
  }
};

/// The box of a triangle, grown as by touching_bounds.
template <Dim N, class T>
Aabb<N, T> grown_box_of(const Triangle<N, T>& triangle) {
  Aabb<N, T> box{triangle.a, triangle.a};
  box.grow(triangle.b);
  box.grow(triangle.c);
  grow_for_touching(box);
  return box;
}

/// A block whose boxes together are the least box around all corners.
template <Dim N, class T>
BoxBlock<N, T> box_around_corners(std::span<const TriangleBlock<N, T>> blocks) {
  BoxBlock<N, T> boxes = BoxBlock<N, T>::nothing();
#ifdef GRAZE_HAS_LANES
  lanes_set_by<T>([&](auto& group) __attribute__((always_inline)) {
    using Numbers = NumbersOf<decltype(group)>;
    for (std::size_t k = 0; k < static_cast<std::size_t>(N); ++k) {
      Numbers low = Numbers{} + std::numeric_limits<T>::infinity();
      Numbers high = -low;
      for (const TriangleBlock<N, T>& block : blocks) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
          Numbers coordinate;
          group.read(block.corners[corner][k], coordinate);
          make_smaller(low, coordinate);
          make_larger(high, coordinate);
        }
      }
      group.write(low, boxes.min_row(static_cast<Dim>(k)));
      group.write(high, boxes.max_row(static_cast<Dim>(k)));
    }
  });
#else
  for (const TriangleBlock<N, T>& block : blocks) {
    for (std::size_t lane = 0; lane < row_length; ++lane) {
      Aabb<N, T> box = boxes.box(lane);
      for (const Vec<N, T>& corner : block.triangle(lane).vertices()) box.grow(corner);
      boxes.set(lane, box);
    }
  }
#endif
  return boxes;
}

/// Boxes around triangles, at least as large as those of grown_box_of.
template <Dim N, class T>
void set_boxes_around(const TriangleBlock<N, T>& triangles, BoxBlock<N, T>& boxes) {
#ifdef GRAZE_HAS_LANES
  lanes_set_by<T>([&](auto& group) __attribute__((always_inline)) {
    using Numbers = NumbersOf<decltype(group)>;
    Numbers low[static_cast<std::size_t>(N)];
    Numbers high[static_cast<std::size_t>(N)];
    Numbers size = {};
    for (Dim i = 0; i < N; ++i) {
      const auto k = static_cast<std::size_t>(i);
      Numbers b;
      Numbers c;
      group.read(triangles.corners[0][k], low[k]);
      group.read(triangles.corners[1][k], b);
      group.read(triangles.corners[2][k], c);
      high[k] = low[k];
      make_smaller(low[k], b);
      make_smaller(low[k], c);
      make_larger(high[k], b);
      make_larger(high[k], c);
      make_larger(size, high[k]);
      make_larger(size, -low[k]);
    }
    // A rounding error of T, or the slack; one step of the least numbers, where the product is zero.
    constexpr T slack = std::numeric_limits<T>::epsilon() + 2 * static_cast<T>(tolerance::box_slack);
    size = size * slack + std::numeric_limits<T>::denorm_min();
    for (Dim i = 0; i < N; ++i) {
      group.write(low[static_cast<std::size_t>(i)] - size, boxes.min_row(i));
      group.write(high[static_cast<std::size_t>(i)] + size, boxes.max_row(i));
    }
  });
#else
  for (std::size_t lane = 0; lane < row_length; ++lane) boxes.set(lane, grown_box_of(triangles.triangle(lane)));
#endif
}

#ifdef GRAZE_HAS_LANES
/// The triangles of a block at another place, up to the slack of that.
template <Dim N, class T>
void place_triangles(const TriangleBlock<N, T>& triangles, const LanePlace<N, T>& place, TriangleBlock<N, T>& placed) {
  lanes_set_by<T>([&](auto& group) __attribute__((always_inline)) {
    using Numbers = NumbersOf<decltype(group)>;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (Dim i = 0; i < N; ++i) {
        Numbers sum = Numbers{} + place.position[i];
        for (Dim j = 0; j < N; ++j) {
          Numbers coordinate;
          group.read(triangles.corners[corner][static_cast<std::size_t>(j)], coordinate);
          sum += coordinate * place.rotation[j][i];
        }
        group.write(sum, placed.corners[corner][static_cast<std::size_t>(i)]);
      }
    }
  });
}
#endif

}  // namespace graze::detail
