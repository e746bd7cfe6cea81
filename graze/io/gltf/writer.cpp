// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include <graze/io/gltf/container.hpp>
#include <graze/io/gltf/writer.hpp>
#include <graze/io/mesh/bytes.hpp>
#include <graze/io/mesh/joined.hpp>
#include <graze/io/output_error.hpp>
#include <graze/math/pose.hpp>

namespace graze::io {
namespace {

using Json = nlohmann::ordered_json;
using Data = detail::MeshData<3, double>;

constexpr int float_type = 5126;
constexpr int index_type = 5125;
constexpr int vertex_target = 34962;
constexpr int index_target = 34963;

/// Collects the document and the bytes that it describes.
class GlbWriter {
 public:
  explicit GlbWriter(std::span<const MeshPart> parts) {
    for (const MeshPart& part : parts) add(part);
  }

  void write(std::ostream& out) const {
    Json indices = Json::array();
    for (std::size_t i = 0; i < nodes_.size(); ++i) indices.push_back(i);
    Json document = {{"asset", {{"version", "2.0"}, {"generator", "graze"}}},
                     {"scene", 0},
                     {"scenes", Json::array({Json::object()})}};
    const auto set = [](Json& object, std::string_view name, const Json& list) {
      if (!list.empty()) object[std::string(name)] = list;  // empty lists are not allowed
    };
    set(document["scenes"][0], "nodes", indices);
    set(document, "nodes", nodes_);
    set(document, "meshes", meshes_);
    set(document, "accessors", accessors_);
    set(document, "bufferViews", views_);
    if (!bytes_.empty()) document["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
    std::string text = document.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    write_chunks(out, text);
  }

 private:
  /// The number of a mesh with these triangles; they are added the first time.
  std::size_t mesh_of(const Data& data) {
    const auto [known, is_new] = mesh_by_data_.try_emplace(&data, meshes_.size());
    if (is_new) add_mesh(data);
    return known->second;
  }

  void add(const MeshPart& part) {
    Json node = Json::object();
    if (!part.name.empty()) node["name"] = part.name;
    const auto& placed = detail::placed(part.mesh);
    if (!part.mesh.faces().empty()) node["mesh"] = mesh_of(*placed.data());  // accessors must not be empty
    if (placed.is_moved()) {
      const Pose<3, double>& pose = placed.pose();
      Json matrix = Json::array();
      for (Dim j = 0; j < 3; ++j) {
        for (Dim i = 0; i < 3; ++i) matrix.push_back(pose.rotation[j][i]);
        matrix.push_back(0);
      }
      for (Dim i = 0; i < 3; ++i) matrix.push_back(pose.position[i]);
      matrix.push_back(1);
      node["matrix"] = matrix;
    }
    nodes_.push_back(node);
  }

  void add_mesh(const Data& data) {
    std::array<float, 3> low;
    std::array<float, 3> high;
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
    const std::size_t begin = bytes_.size();
    for (const Vec<3, double>& vertex : data.vertices()) {
      for (std::size_t i = 0; i < 3; ++i) {
        const float coordinate = as_float(vertex[static_cast<Dim>(i)], "glTF");
        low[i] = std::min(low[i], coordinate);
        high[i] = std::max(high[i], coordinate);
        append_number(bytes_, coordinate);
      }
    }
    const std::size_t points = add_accessor(begin, vertex_target, float_type, data.vertices().size(), "VEC3");
    accessors_.back()["min"] = low;
    accessors_.back()["max"] = high;
    const std::size_t middle = bytes_.size();
    for (const std::array<std::uint32_t, 3>& face : data.faces()) {
      for (const std::uint32_t vertex : face) append_number(bytes_, vertex);
    }
    const std::size_t indices = add_accessor(middle, index_target, index_type, 3 * data.faces().size(), "SCALAR");
    const Json primitive = {{"attributes", {{"POSITION", points}}}, {"indices", indices}};
    meshes_.push_back({{"primitives", Json::array({primitive})}});
  }

  std::size_t add_accessor(std::size_t begin, int target, int type, std::size_t count, std::string_view shape) {
    views_.push_back({{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes_.size() - begin}, {"target", target}});
    accessors_.push_back(
        {{"bufferView", views_.size() - 1}, {"componentType", type}, {"count", count}, {"type", shape}});
    return accessors_.size() - 1;
  }

  void write_chunks(std::ostream& out, const std::string& text) const {
    const std::size_t total = glb_head_bytes + glb_chunk_head_bytes + text.size() +
                              (bytes_.empty() ? 0 : glb_chunk_head_bytes + bytes_.size());
    if (total > std::numeric_limits<std::uint32_t>::max()) {
      throw OutputError("a .glb file holds at most 4 GiB, and the meshes need more");
    }
    std::string head = "glTF";
    append_number(head, std::uint32_t{2});
    append_number(head, static_cast<std::uint32_t>(total));
    append_number(head, static_cast<std::uint32_t>(text.size()));
    append_number(head, glb_json_chunk);
    out << head << text;
    if (bytes_.empty()) return;
    head.clear();
    append_number(head, static_cast<std::uint32_t>(bytes_.size()));
    append_number(head, glb_binary_chunk);
    out << head << bytes_;
  }

  Json nodes_ = Json::array();
  Json meshes_ = Json::array();
  Json accessors_ = Json::array();
  Json views_ = Json::array();
  std::string bytes_;  ///< Of all accessors, whose numbers have four bytes.
  std::map<const Data*, std::size_t> mesh_by_data_;
};

}  // namespace

void write_glb(std::ostream& out, std::span<const MeshPart> parts) { GlbWriter(parts).write(out); }

}  // namespace graze::io
