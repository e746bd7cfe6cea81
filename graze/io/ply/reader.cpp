// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/mesh/parts.hpp>
#include <graze/io/mesh/polygon.hpp>
#include <graze/io/ply/header.hpp>
#include <graze/io/ply/reader.hpp>
#include <graze/io/ply/values.hpp>
#include <graze/io/text/in_quotes.hpp>

namespace graze::io {
namespace {

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::string& source)
      : header_(read_ply_header(bytes, source)), values_(bytes, source, header_), file_{{}, source, "ply"} {
    file_.warnings = std::move(header_.warnings);
  }

  MeshFile read() {
    for (const PlyElement& element : header_.elements) {
      require_bytes(element);
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face" || element.name == "tristrips") {
        read_faces(element);
      } else {
        skip(element);
      }
    }
    check_indices();
    auto faces = polygons_.triangles(vertices_, 1);
    file_.parts.push_back({"", mesh_of<3, double>(vertices_, faces.front())});
    note_points(file_, vertices_.size(), faces.front().size());
    return std::move(file_);
  }

 private:
  /// A wrong number must not take memory or time.
  void require_bytes(const PlyElement& element) const {
    const std::size_t least = element.least_bytes(values_.is_text());
    const std::size_t left = values_.bytes_left() + 1;  // no line end is needed after the last number
    if (least == 0 || element.count <= left / least) return;
    throw values_.error(
        element.offset,
        fmt::format("the header promises {} elements {}, which take at least {} bytes each, but only {} "
                    "bytes follow; is the file cut off?",
                    element.count, in_quotes(element.name), least, left - 1));
  }

  void skip(const PlyElement& element) {
    if (element.count > 0)
      file_.omissions.push_back({"element " + in_quotes(element.name), static_cast<std::size_t>(element.count)});
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      for (const PlyProperty& property : element.properties) values_.skip(property);
    }
  }

  void read_vertices(const PlyElement& element) {
    std::array<std::size_t, 3> places{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::optional<std::size_t> place = element.find(mesh_axes[i]);
      if (!place || element.properties[*place].count_type) {
        throw values_.error(element.offset, fmt::format("the vertices have no number {}; they need x, y and z",
                                                        in_quotes(mesh_axes[i])));
      }
      places[i] = *place;
    }
    if (!vertices_.empty()) throw values_.error(element.offset, "the vertices are listed twice");
    vertices_.reserve(static_cast<std::size_t>(element.count));
    for (std::uint64_t i = 0; i < element.count; ++i) {
      Vec<3, double>& point = vertices_.emplace_back(0);
      for (std::size_t place = 0; place < element.properties.size(); ++place) {
        const PlyProperty& property = element.properties[place];
        std::size_t axis = 0;
        while (axis < 3 && places[axis] != place) ++axis;
        if (axis == 3) {
          values_.skip(property);
        } else {
          point[static_cast<Dim>(axis)] = values_.number(property.type, property.name);
        }
      }
    }
  }

  void read_faces(const PlyElement& element) {
    std::optional<std::size_t> list = element.find("vertex_indices");
    if (!list) list = element.find("vertex_index");
    if (!list || !element.properties[*list].count_type) {
      if (element.count == 0) return;
      throw values_.error(element.offset, fmt::format("the elements {} have no list \"vertex_indices\" (or "
                                                      "\"vertex_index\")",
                                                      in_quotes(element.name)));
    }
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (std::size_t place = 0; place < element.properties.size(); ++place) {
        const PlyProperty& property = element.properties[place];
        if (place != *list) {
          values_.skip(property);
        } else if (element.name == "face") {
          read_face(property);
        } else {
          read_strips(property);
        }
      }
    }
  }

  std::uint32_t read_index(const PlyProperty& list) {
    const std::int64_t vertex = values_.whole(list.type, "a vertex of a face");
    if (vertex < 0 || vertex > 0xFFFFFFFF) throw out_of_range(vertex, values_.offset());
    return static_cast<std::uint32_t>(vertex);
  }

  InputError out_of_range(std::int64_t vertex, std::size_t offset) const {
    return values_.error(offset, fmt::format("a face has vertex {}, but there are {} vertices, numbered from 0", vertex,
                                             vertices_.size()));
  }

  void read_face(const PlyProperty& list) {
    const std::size_t corners = values_.length(list);
    const std::size_t offset = values_.offset();
    if (corners > max_polygon_corners) {
      throw values_.error(offset,
                          fmt::format("a face has {} corners; at most {} are allowed", corners, max_polygon_corners));
    }
    for (std::size_t i = 0; i < corners; ++i) polygons_.add_corner(read_index(list));
    polygons_.end_polygon(0, offset);
    if (corners < 3) count_omission(file_.omissions, corners == 2 ? "line" : "point", Loss::shape);
  }

  /// Of each strip the triangles, every other one turned around, so that all have the same side up.
  void read_strips(const PlyProperty& list) {
    const std::size_t length = values_.length(list);
    std::vector<std::uint32_t> strip;
    for (std::size_t i = 0; i < length; ++i) {
      const std::int64_t vertex = values_.whole(list.type, "a vertex of a strip");
      if (vertex == -1) {
        strip.clear();
        continue;
      }
      if (vertex < 0 || vertex > 0xFFFFFFFF) throw out_of_range(vertex, values_.offset());
      strip.push_back(static_cast<std::uint32_t>(vertex));
      const std::size_t size = strip.size();
      if (size < 3) continue;
      const bool is_turned = size % 2 == 0;
      polygons_.add_corner(strip[size - 3]);
      polygons_.add_corner(strip[size - (is_turned ? 1 : 2)]);
      polygons_.add_corner(strip[size - (is_turned ? 2 : 1)]);
      polygons_.end_polygon(0, values_.offset());
    }
  }

  /// Faces may precede vertices, so the indices are checked at the end.
  void check_indices() const {
    polygons_.for_each_corner([this](std::uint32_t vertex, std::size_t offset) {
      if (vertex >= vertices_.size()) throw out_of_range(vertex, offset);
    });
  }

  PlyHeader header_;
  PlyValues values_;
  MeshFile file_;
  std::vector<Vec<3, double>> vertices_;
  MeshPolygons polygons_;
};

}  // namespace

MeshFile read_ply(std::string_view bytes, const std::string& source) { return PlyReader(bytes, source).read(); }

}  // namespace graze::io
