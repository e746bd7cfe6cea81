// SPDX-License-Identifier: MIT
// Meshes of polygons on common vertices, while a file is read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/io/mesh_file.hpp>
#include <graze/io/omission.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

/// The names of the axes in messages.
inline constexpr std::array<std::string_view, 3> mesh_axes = {"x", "y", "z"};

/// Counts omissions by name, in the order of first occurrence. `where` is the place of the first one.
void count_omission(std::vector<Omission>& omissions, std::string_view what, Loss loss, std::string_view where = {});

/// Notes vertices of a file without faces, as of a point cloud.
void note_points(MeshFile& file, std::size_t vertices, std::size_t faces);

/// Polygons of a file, and the part that each belongs to.
class MeshPolygons {
 public:
  void reserve(std::size_t polygons) { polygons_.reserve(polygons); }

  /// Appends a polygon with the corners that `add_corner` was called with since the last one. `offset` is its place in
  /// the file.
  void end_polygon(std::size_t part, std::size_t offset);
  void add_corner(std::uint32_t vertex) { corners_.push_back(vertex); }
  /// The number of corners since the last polygon.
  std::size_t open_corners() const { return corners_.size() - begin_; }

  /// The triangles of each part, on all vertices. The indices must be valid.
  std::vector<std::vector<std::array<std::uint32_t, 3>>> triangles(std::span<const Vec<3, double>> vertices,
                                                                   std::size_t parts) const;

  /// Calls visit(corner, offset of its polygon) for all corners.
  template <class Visit>
  void for_each_corner(const Visit& visit) const {
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      for (const std::uint32_t corner : corners_of(i)) visit(corner, polygons_[i].offset);
    }
  }

 private:
  struct Polygon {
    std::size_t begin;
    std::size_t offset;
    std::size_t part;
  };

  std::span<const std::uint32_t> corners_of(std::size_t polygon) const;

  std::vector<Polygon> polygons_;
  std::vector<std::uint32_t> corners_;
  std::size_t begin_ = 0;  ///< Of the corners of the polygon that is being read.
};

/// A part on those of the vertices that it uses, in their order. `place` has as many elements as there are vertices and
/// is reused from part to part; it is 0 everywhere before and after.
Mesh<3, double> mesh_of_used(std::span<const Vec<3, double>> vertices, std::vector<std::array<std::uint32_t, 3>> faces,
                             std::vector<std::uint32_t>& place);

}  // namespace graze::io
