// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/mesh/parts.hpp>
#include <graze/io/mesh/polygon.hpp>
#include <graze/io/mesh/tokens.hpp>
#include <graze/io/obj/reader.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/position.hpp>
#include <graze/io/text/printable.hpp>
#include <graze/io/text/utf8.hpp>

namespace graze::io {
namespace {

/// Statements without a shape: attributes of vertices, materials, appearance, and the details of curves and surfaces.
constexpr std::array<std::string_view, 36> without_shape = {
    "vn",     "vt",  "vp",       "s",        "mg",    "mtllib", "usemtl",    "usemap", "maplib",
    "bevel",  "lod", "c_interp", "d_interp", "ctech", "stech",  "trace_obj", "csh",    "shadow_obj",
    "cstype", "deg", "bmat",     "step",     "parm",  "trim",   "hole",      "scrv",   "sp",
    "end",    "con", "fvn",      "vc",       "bsp",   "res",    "cdc",       "cdp",    "bzp"};

/// Statements of shapes that are not faces, and what to call them.
struct OtherShape {
  std::string_view statement;
  std::string_view what;
};
constexpr std::array<OtherShape, 6> other_shapes = {{{"p", "points"},
                                                     {"l", "line"},
                                                     {"curv", "curve"},
                                                     {"curv2", "curve"},
                                                     {"surf", "free-form surface"},
                                                     {"call", "call of another file"}}};

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& source)
      : text_(text), tokens_(text, source, MeshSyntax::obj), file_{{}, source, "obj"} {
    part_by_ = has_objects() ? "o" : "g";
  }

  MeshFile read() {
    do {
      const MeshToken statement = tokens_.next_in_line();
      if (!statement.text.empty()) read_statement(statement);
    } while (tokens_.next_line());
    check_indices();
    make_parts();
    return std::move(file_);
  }

 private:
  bool has_objects() const {
    MeshTokens tokens = tokens_;
    do {
      const std::string_view statement = tokens.next_in_line().text;
      if (statement == "o") return true;
      if (statement == "g") tokens.rest_of_line();
    } while (tokens.next_line());
    return false;
  }

  void read_statement(const MeshToken& statement) {
    if (statement.text == "v") return read_vertex();
    if (statement.text == "f" || statement.text == "fo") return read_face(statement.offset);
    if (statement.text == "o" || statement.text == "g") {
      const std::string_view name = tokens_.rest_of_line();
      if (statement.text != part_by_) return;
      name_ = printable(name);
      has_part_ = false;
      return;
    }
    if (std::find(without_shape.begin(), without_shape.end(), statement.text) != without_shape.end()) return;
    const auto* const other = std::find_if(other_shapes.begin(), other_shapes.end(),
                                           [&](const OtherShape& one) { return one.statement == statement.text; });
    const std::string what =
        other != other_shapes.end() ? std::string(other->what) : "unknown statement " + in_quotes(statement.text);
    // The place is expensive, so it is looked up for the first occurrence only.
    const bool is_new = std::none_of(file_.omissions.begin(), file_.omissions.end(),
                                     [&what](const Omission& one) { return one.what == what; });
    count_omission(file_.omissions, what, Loss::shape, is_new ? place_of(statement.offset) : "");
  }

  std::string place_of(std::size_t offset) const {
    return fmt::format("{}, line {}", file_.source, position_of(text_, offset).line);
  }

  /// A weight or a colour may follow.
  void read_vertex() {
    Vec<3, double> point;
    for (Dim i = 0; i < 3; ++i) {
      point[i] = tokens_.number(tokens_.next_in_line(), mesh_axes[static_cast<std::size_t>(i)]);
    }
    vertices_.push_back(point);
  }

  void read_face(std::size_t offset) {
    for (MeshToken corner = tokens_.next_in_line(); !corner.text.empty(); corner = tokens_.next_in_line()) {
      polygons_.add_corner(vertex_of(corner));
    }
    const std::size_t corners = polygons_.open_corners();
    if (corners < 3 || corners > max_polygon_corners) {
      throw tokens_.error(offset, fmt::format("a face has {} corner{}; it must have 3 to {}", corners,
                                              corners == 1 ? "" : "s", max_polygon_corners));
    }
    polygons_.end_polygon(current_part(), offset);
  }

  /// The vertex of "7", "7/1", "7//2" or "7/1/2". Indices count from 1, negative ones back from the last vertex so far.
  std::uint32_t vertex_of(const MeshToken& corner) const {
    const MeshToken digits{corner.text.substr(0, corner.text.find('/')), corner.offset};
    const std::int64_t index = tokens_.whole(digits, "the index of a vertex");
    const auto so_far = static_cast<std::int64_t>(vertices_.size());
    if (index == 0) throw tokens_.error(corner.offset, "a face has vertex 0; vertices are numbered from 1");
    if (index < -so_far || index > std::numeric_limits<std::uint32_t>::max()) throw out_of_range(index, corner.offset);
    return static_cast<std::uint32_t>(index > 0 ? index - 1 : so_far + index);
  }

  InputError out_of_range(std::int64_t index, std::size_t offset) const {
    return tokens_.error(
        offset, fmt::format("a face has vertex {}, but there {} {} {}{}", index, vertices_.size() == 1 ? "is" : "are",
                            vertices_.size(), vertices_.size() == 1 ? "vertex" : "vertices",
                            index < 0 ? " before it" : ", numbered from 1"));
  }

  /// Vertices may follow the faces that use them, so these indices are checked at the end.
  void check_indices() const {
    polygons_.for_each_corner([this](std::uint32_t vertex, std::size_t offset) {
      if (vertex >= vertices_.size()) throw out_of_range(std::int64_t{vertex} + 1, offset);
    });
  }

  /// The part that faces belong to. Each object is its own; groups of the same name are one, because files repeat the
  /// name where the material changes.
  std::size_t current_part() {
    if (!has_part_) {
      part_ = names_.size();
      if (part_by_ == "g") part_ = part_by_name_.try_emplace(name_, part_).first->second;
      if (part_ == names_.size()) names_.push_back(name_);
      has_part_ = true;
    }
    return part_;
  }

  void make_parts() {
    auto faces = polygons_.triangles(vertices_, names_.size());
    std::vector<std::uint32_t> place(vertices_.size(), 0);
    for (std::size_t part = 0; part < names_.size(); ++part) {
      file_.parts.push_back({names_[part], mesh_of_used(vertices_, std::move(faces[part]), place)});
    }
    if (file_.omissions.empty()) note_points(file_, vertices_.size(), names_.size());
  }

  std::string_view text_;
  MeshTokens tokens_;
  MeshFile file_;
  std::string_view part_by_;
  std::vector<Vec<3, double>> vertices_;
  MeshPolygons polygons_;
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t> part_by_name_;
  std::string name_;       ///< Of the current object or group.
  std::size_t part_ = 0;   ///< Of the current name, if has_part_.
  bool has_part_ = false;  ///< A name without faces makes no part.
};

}  // namespace

MeshFile read_obj(std::string_view text, const std::string& source) {
  return ObjReader(without_byte_order_mark(text), source).read();
}

}  // namespace graze::io
