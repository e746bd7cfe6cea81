// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <graze/io/mesh/polygon.hpp>
#include <graze/math/orientation.hpp>
#include <graze/query/convex_parts.hpp>
#include <graze/shape/mesh/flat_triangle.hpp>

namespace graze::io {
namespace {

using Flat = std::vector<Vec<2, double>>;

/// Twice the area vector of a polygon, scaled so that no product overflows. Only its largest coordinate matters.
Vec<3, double> area_of(std::span<const Vec<3, double>> vertices, std::span<const std::uint32_t> corners) {
  double largest = 0;
  for (const std::uint32_t corner : corners) largest = std::max(largest, max_abs(vertices[corner]));
  Vec<3, double> area(0);
  if (largest == 0) return area;
  const Vec<3, double> first = vertices[corners[0]] / largest;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    area += cross(vertices[corners[i - 1]] / largest - first, vertices[corners[i]] / largest - first);
  }
  return area;
}

/// The polygon as seen along the axis on which its area is largest, from the side on which it runs counter-clockwise.
Flat flattened(std::span<const Vec<3, double>> vertices, std::span<const std::uint32_t> corners) {
  const Vec<3, double> area = area_of(vertices, corners);
  Dim axis = 0;
  for (Dim i = 1; i < 3; ++i) {
    if (std::fabs(area[i]) > std::fabs(area[axis])) axis = i;
  }
  Flat flat;
  for (const std::uint32_t corner : corners) {
    const Vec<2, double> point = detail::seen_along(axis, vertices[corner]);
    flat.push_back(area[axis] < 0 ? Vec<2, double>(point.y, point.x) : point);
  }
  return flat;
}

/// True if all triangles of the fan from the first corner run counter-clockwise and lie within half a turn about it, so
/// that no two of them overlap.
bool is_fan(const Flat& flat) {
  for (std::size_t i = 2; i < flat.size(); ++i) {
    if (orientation(flat[0], flat[i - 1], flat[i]) <= 0 || orientation(flat[0], flat[1], flat[i]) <= 0) return false;
  }
  return true;
}

/// The triangles of the ears, by places in `flat`; none if it crosses or touches itself. Corners on straight edges are
/// no obstacle to cutting: a triangle that has one on its border is no ear.
std::optional<std::vector<std::size_t>> ears_of(const Flat& flat) {
  const Flat corners = detail::true_corners<double>(flat);
  if (corners.size() < 3 || !detail::is_simple(corners) || !detail::runs_counter_clockwise(corners))
    return std::nullopt;
  const std::optional<detail::Triangles> triangles = detail::EarClipper<double>(flat).clip();
  if (!triangles) return std::nullopt;
  return triangles->origin;
}

}  // namespace

void append_triangles(std::vector<std::array<std::uint32_t, 3>>& faces, std::span<const Vec<3, double>> vertices,
                      std::span<const std::uint32_t> corners) {
  if (corners.size() < 3) return;
  if (corners.size() > 3) {
    const Flat flat = flattened(vertices, corners);
    const auto ears = is_fan(flat) ? std::nullopt : ears_of(flat);
    if (ears) {
      for (std::size_t i = 0; i + 2 < ears->size(); i += 3) {
        faces.push_back({corners[(*ears)[i]], corners[(*ears)[i + 1]], corners[(*ears)[i + 2]]});
      }
      return;
    }
  }
  for (std::size_t i = 2; i < corners.size(); ++i) faces.push_back({corners[0], corners[i - 1], corners[i]});
}

}  // namespace graze::io
