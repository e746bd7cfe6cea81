// SPDX-License-Identifier: MIT
// Shapes as corners, triangles and lines.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::wasm {

/// Triangles and lines refer to corners by index.
template <Dim N>
struct Drawing {
  std::vector<Vec<N, double>> corners;
  std::vector<std::uint32_t> triangles;  ///< Three each, counter-clockwise from outside.
  std::vector<std::uint32_t> lines;      ///< Two each.

  /// Adds a corner and returns its index.
  std::uint32_t add(const Vec<N, double>& corner) {
    corners.push_back(corner);
    return static_cast<std::uint32_t>(corners.size() - 1);
  }
};

/// The resolution of round shapes, and the box that cuts off unbounded ones.
template <Dim N>
struct DrawingOptions {
  std::optional<Aabb<N, double>> within;  ///< Without it, unbounded shapes are not drawn.
  int circle = 64;                        ///< Corners of a full circle.
};

/// In 2D filled shapes and their outlines, for a compound that of the union of its parts; in 3D surfaces and edges. For
/// drawing only: accurate up to rounding, and round shapes are drawn slightly too small.
Drawing<2> drawing_of(const AnyShape<2, double>& shape, const DrawingOptions<2>& options);
Drawing<3> drawing_of(const AnyShape<3, double>& shape, const DrawingOptions<3>& options);

}  // namespace graze::wasm
