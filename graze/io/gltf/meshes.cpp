// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/gltf/meshes.hpp>
#include <graze/io/mesh/parts.hpp>

namespace graze::io {
namespace {

constexpr std::size_t triangles_mode = 4;
constexpr std::size_t strip_mode = 5;
constexpr std::size_t fan_mode = 6;
constexpr std::array<std::string_view, triangles_mode> other_modes = {"points", "lines", "line loop", "line strip"};

/// The corners of triangle `i` of a primitive (glTF 2.0, section 3.7.2.1).
std::array<std::size_t, 3> corners_of(std::size_t mode, std::size_t i) {
  if (mode == triangles_mode) return {3 * i, 3 * i + 1, 3 * i + 2};
  if (mode == strip_mode) return {i, i + 1 + i % 2, i + 2 - i % 2};
  return {i + 1, i + 2, 0};
}

/// "mesh 3"
std::string place_text(const JsonPlace& place) { return fmt::format("{} {}", place.word, place.index); }

}  // namespace

std::vector<GltfMeshes::Primitive> GltfMeshes::primitives_of(const GltfItem& mesh) {
  std::vector<Primitive> primitives;
  std::size_t number = 0;
  for (const JsonValue value : mesh.fields().array("primitives").items()) {
    const JsonPlace place{mesh.place.document, &mesh.place, "primitive", number++};
    if (value.kind() != JsonKind::object) {
      throw place.error(value.offset(), fmt::format("must be an object, not {}", kind_name(value.kind())));
    }
    const JsonFields fields(value, place, "a primitive");
    const std::size_t mode = gltf_size(fields, "mode", triangles_mode);
    if (mode > fan_mode) throw fields.error("mode", fmt::format("is {}; it must be 0 to 6", mode));
    if (mode < triangles_mode) {
      count_omission(file_.omissions, fmt::format("primitive of {}", other_modes[mode]), Loss::shape,
                     fmt::format("{}, {}", file_.source, place_text(mesh.place)));
      continue;
    }
    const JsonValue attributes = fields.require("attributes");
    if (attributes.kind() != JsonKind::object) throw fields.error("attributes", "must be an object");
    const std::optional<JsonValue> position = attributes.find("POSITION");
    if (!position) {
      count_omission(file_.omissions, "primitive without positions", Loss::shape,
                     fmt::format("{}, {}", file_.source, place_text(mesh.place)));
      continue;
    }
    const std::size_t points = root_.index(*position, {"POSITION"}, place, GltfArray::accessors);
    const std::optional<JsonValue> indices = fields.find("indices");
    primitives.emplace_back(points, indices ? 1 + root_.index(*indices, {"indices"}, place, GltfArray::accessors) : 0,
                            mode);
  }
  return primitives;
}

GltfMeshes::Faces GltfMeshes::faces_of(const Primitive& primitive, const JsonPlace& place) {
  const auto [accessor, one_more, mode] = primitive;
  const std::vector<Vec<3, double>>& points = one_more > 0 ? accessors_.points(accessor) : accessors_.corners(accessor);
  std::vector<std::uint32_t> indices;
  if (one_more > 0) indices = accessors_.indices(one_more - 1);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] < points.size()) continue;
    const GltfItem item = root_.item(GltfArray::accessors, one_more - 1);
    throw item.place.error(item.value.offset(),
                           fmt::format("index {} is {}, but accessor {}, which {} uses with it, has {} vertices", i,
                                       indices[i], accessor, place_text(place), points.size()));
  }
  const std::size_t corners = one_more > 0 ? indices.size() : points.size();
  const std::size_t triangles = mode == triangles_mode ? corners / 3 : corners - std::min<std::size_t>(corners, 2);
  if (mode == triangles_mode && corners % 3 != 0) {
    file_.warnings.push_back(fmt::format("{}: {} has a primitive with {} corners; the last {} make no triangle",
                                         file_.source, place_text(place), corners, corners % 3));
  }
  Faces faces;
  faces.reserve(triangles);
  for (std::size_t i = 0; i < triangles; ++i) {
    std::array<std::uint32_t, 3> face{};
    const std::array<std::size_t, 3> at = corners_of(mode, i);
    for (std::size_t j = 0; j < 3; ++j) {
      face[j] = one_more > 0 ? indices[at[j]] : static_cast<std::uint32_t>(at[j]);
    }
    faces.push_back(face);
  }
  return faces;
}

/// Primitives on the same points share vertices.
Mesh<3, double> GltfMeshes::built(const std::vector<Primitive>& primitives, const GltfItem& mesh) {
  std::map<std::size_t, Faces> faces_by_points;
  std::vector<std::size_t> order;
  for (const Primitive& primitive : primitives) {
    Faces faces = faces_of(primitive, mesh.place);
    const auto [known, is_new] = faces_by_points.try_emplace(std::get<0>(primitive));
    if (is_new) order.push_back(known->first);
    known->second.insert(known->second.end(), faces.begin(), faces.end());
  }
  std::vector<Vec<3, double>> vertices;
  Faces all;
  for (const std::size_t accessor : order) {
    const std::vector<Vec<3, double>>& points = accessors_.points(accessor);
    std::vector<std::uint32_t>& place = places_[accessor];
    place.resize(points.size(), 0);
    Mesh<3, double> part = mesh_of_used(points, std::move(faces_by_points[accessor]), place);
    if (order.size() == 1) return part;
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), part.vertices().begin(), part.vertices().end());
    for (const std::array<std::uint32_t, 3>& face : part.faces()) {
      all.push_back({first + face[0], first + face[1], first + face[2]});
    }
  }
  return mesh_of<3, double>(vertices, all);
}

const Mesh<3, double>& GltfMeshes::mesh(std::size_t index) {
  const auto [known, is_new] = by_index_.try_emplace(index, nullptr);
  if (!is_new) return *known->second;
  const GltfItem item = root_.item(GltfArray::meshes, index);
  const std::vector<Primitive> primitives = primitives_of(item);
  auto same = by_primitives_.find(primitives);
  if (same == by_primitives_.end()) same = by_primitives_.emplace(primitives, built(primitives, item)).first;
  known->second = &same->second;
  return same->second;
}

}  // namespace graze::io
