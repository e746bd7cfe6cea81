// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <graze/io/mesh/parts.hpp>
#include <graze/io/mesh/polygon.hpp>

namespace graze::io {

void count_omission(std::vector<Omission>& omissions, std::string_view what, Loss loss, std::string_view where) {
  const auto known =
      std::find_if(omissions.begin(), omissions.end(), [what](const Omission& one) { return one.what == what; });
  if (known != omissions.end()) {
    ++known->count;
  } else {
    omissions.push_back({std::string(what), 1, loss, std::string(where)});
  }
}

void note_points(MeshFile& file, std::size_t vertices, std::size_t faces) {
  if (faces > 0 || vertices == 0) return;
  file.omissions.push_back({"point of no face", vertices, Loss::shape, file.source, "a mesh consists of its faces"});
}

void MeshPolygons::end_polygon(std::size_t part, std::size_t offset) {
  polygons_.push_back({begin_, offset, part});
  begin_ = corners_.size();
}

std::span<const std::uint32_t> MeshPolygons::corners_of(std::size_t polygon) const {
  const std::size_t begin = polygons_[polygon].begin;
  const std::size_t end = polygon + 1 < polygons_.size() ? polygons_[polygon + 1].begin : begin_;
  return std::span(corners_).subspan(begin, end - begin);
}

std::vector<std::vector<std::array<std::uint32_t, 3>>> MeshPolygons::triangles(std::span<const Vec<3, double>> vertices,
                                                                               std::size_t parts) const {
  std::vector<std::vector<std::array<std::uint32_t, 3>>> faces(parts);
  for (std::size_t i = 0; i < polygons_.size(); ++i)
    append_triangles(faces[polygons_[i].part], vertices, corners_of(i));
  return faces;
}

Mesh<3, double> mesh_of_used(std::span<const Vec<3, double>> vertices, std::vector<std::array<std::uint32_t, 3>> faces,
                             std::vector<std::uint32_t>& place) {
  std::vector<std::uint32_t> used;
  for (const std::array<std::uint32_t, 3>& face : faces) {
    for (const std::uint32_t vertex : face) {
      if (place[vertex] == 0) used.push_back(vertex);
      place[vertex] = 1;
    }
  }
  std::sort(used.begin(), used.end());
  std::vector<Vec<3, double>> kept;
  kept.reserve(used.size());
  for (const std::uint32_t vertex : used) {
    place[vertex] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(vertices[vertex]);
  }
  for (std::array<std::uint32_t, 3>& face : faces) {
    for (std::uint32_t& vertex : face) vertex = place[vertex];
  }
  for (const std::uint32_t vertex : used) place[vertex] = 0;
  return mesh_of<3, double>(kept, faces);
}

}  // namespace graze::io
