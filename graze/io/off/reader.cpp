// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/mesh/parts.hpp>
#include <graze/io/mesh/polygon.hpp>
#include <graze/io/mesh/tokens.hpp>
#include <graze/io/off/header.hpp>
#include <graze/io/off/reader.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/utf8.hpp>

namespace graze::io {
namespace {

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& source)
      : text_(text), tokens_(text, source, MeshSyntax::comments), file_{{}, source, "off"} {}

  MeshFile read() {
    read_header();
    const std::size_t vertices = count("the number of vertices");
    const std::size_t faces = count("the number of faces");
    // The number of edges follows, of no use and often wrong; some programs leave it out.
    tokens_.next_line();
    for (std::size_t i = 0; i < vertices; ++i) read_vertex();
    for (std::size_t i = 0; i < faces; ++i) read_face(i);
    auto triangles = polygons_.triangles(vertices_, 1);
    file_.parts.push_back({"", mesh_of<3, double>(vertices_, triangles.front())});
    note_points(file_, vertices_.size(), triangles.front().size());
    return std::move(file_);
  }

 private:
  void read_header() {
    const MeshToken word = tokens_.next();
    const auto header = off_header_of(word.text);
    if (!header) throw tokens_.error(word.offset, fmt::format("{} stands where \"OFF\" must", in_quotes(word.text)));
    if (header->is_4d) {
      throw tokens_.error(word.offset,
                          fmt::format("the vertices of {} do not have three coordinates; write OFF with x, y "
                                      "and z",
                                      header->word));
    }
    MeshTokens ahead = tokens_;
    if (const MeshToken next = ahead.next_in_line(); next.text == "BINARY") {
      throw tokens_.error(next.offset, "binary OFF is not read; write it as text, or as binary PLY");
    }
  }

  /// Each vertex or face takes at least two bytes, which keeps a wrong number from taking memory.
  std::size_t count(std::string_view name) {
    const MeshToken token = tokens_.next();
    const std::int64_t number = tokens_.whole(token, name);
    const std::size_t left = text_.size() - tokens_.offset();
    if (number < 0 || static_cast<std::uint64_t>(number) > left) {
      throw tokens_.error(token.offset,
                          fmt::format("{} is {}, but only {} bytes follow; is the file cut off?", name, number, left));
    }
    return static_cast<std::size_t>(number);
  }

  void read_vertex() {
    Vec<3, double> point;
    for (Dim i = 0; i < 3; ++i) point[i] = tokens_.number(tokens_.next(), mesh_axes[static_cast<std::size_t>(i)]);
    vertices_.push_back(point);
    tokens_.next_line();
  }

  void read_face(std::size_t index) {
    const MeshToken first = tokens_.next();
    const std::int64_t corners = tokens_.whole(first, "the number of corners of a face");
    if (corners < 0 || corners > static_cast<std::int64_t>(max_polygon_corners)) {
      throw tokens_.error(first.offset, fmt::format("face {} has {} corners; at most {} are allowed", index, corners,
                                                    max_polygon_corners));
    }
    for (std::int64_t i = 0; i < corners; ++i) {
      const MeshToken token = tokens_.next();
      const std::int64_t vertex = tokens_.whole(token, "a vertex of a face");
      if (vertex < 0 || vertex >= static_cast<std::int64_t>(vertices_.size())) {
        throw tokens_.error(token.offset,
                            fmt::format("face {} has vertex {}, but there are {} vertices, numbered from 0", index,
                                        vertex, vertices_.size()));
      }
      polygons_.add_corner(static_cast<std::uint32_t>(vertex));
    }
    polygons_.end_polygon(0, first.offset);
    tokens_.next_line();
    if (corners < 3) count_omission(file_.omissions, corners == 2 ? "line" : "point", Loss::shape);
  }

  std::string_view text_;
  MeshTokens tokens_;
  MeshFile file_;
  std::vector<Vec<3, double>> vertices_;
  MeshPolygons polygons_;
};

}  // namespace

MeshFile read_off(std::string_view text, const std::string& source) {
  return OffReader(without_byte_order_mark(text), source).read();
}

}  // namespace graze::io
