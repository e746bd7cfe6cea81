// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/gltf/accessors.hpp>
#include <graze/io/gltf/container.hpp>
#include <graze/io/gltf/meshes.hpp>
#include <graze/io/gltf/placement.hpp>
#include <graze/io/gltf/reader.hpp>
#include <graze/io/gltf/root.hpp>
#include <graze/io/mesh/parts.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/printable.hpp>

namespace graze::io {
namespace {

/// Extensions that a reader of shapes can ignore or, like quantization, understands.
constexpr std::array<std::string_view, 5> harmless_prefixes = {"KHR_materials_", "KHR_texture_", "EXT_texture_",
                                                               "KHR_lights_", "EXT_lights_"};
constexpr std::array<std::string_view, 6> harmless_names = {
    "KHR_mesh_quantization", "KHR_technique_webgl",   "KHR_xmp",
    "KHR_xmp_json_ld",       "KHR_animation_pointer", "KHR_techniques_webgl"};

bool is_harmless(std::string_view extension) {
  return std::any_of(harmless_prefixes.begin(), harmless_prefixes.end(),
                     [extension](std::string_view prefix) { return extension.starts_with(prefix); }) ||
         std::find(harmless_names.begin(), harmless_names.end(), extension) != harmless_names.end();
}

class GltfReader {
 public:
  GltfReader(const JsonDocument& document, std::optional<std::string_view> binary, std::filesystem::path folder)
      : file_{{}, document.source(), "gltf", UpAxis::y, 1.0},
        root_(checked(document)),
        accessors_(root_, binary, std::move(folder)),
        meshes_(root_, accessors_, file_) {}

  MeshFile read() {
    if (const auto animations = root_.fields().find("animations")) note_animations(*animations);
    visited_.assign(root_.size(GltfArray::nodes), false);
    open_ = roots();
    std::reverse(open_.begin(), open_.end());
    while (!open_.empty()) {
      const Visit visit = open_.back();
      open_.pop_back();
      read_node(visit);
    }
    return std::move(file_);
  }

 private:
  /// A node that is to be read, and the transform of its parent.
  struct Visit {
    std::size_t node = 0;
    GltfTransform outer = {};
  };

  /// Refuses other versions before anything else, because glTF 1.0 has objects where 2.0 has arrays.
  static const JsonDocument& checked(const JsonDocument& document) {
    const JsonPlace place{document};
    const JsonValue root = document.root();
    const std::optional<JsonValue> asset = root.find("asset");
    const bool is_object = asset && asset->kind() == JsonKind::object;
    const std::optional<JsonValue> version = is_object ? asset->find("version") : std::nullopt;
    const std::string_view text = version && version->kind() == JsonKind::text ? version->text() : "1.0";
    if (!text.starts_with("2.")) {
      throw place.error((asset ? *asset : root).offset(),
                        fmt::format("this is glTF {}; graze reads glTF 2.0, so export it as that", printable(text)));
    }
    if (const auto required = root.find("extensionsRequired")) refuse_extensions(*required, place);
    return document;
  }

  static void refuse_extensions(JsonValue required, const JsonPlace& place) {
    std::size_t number = 0;
    for (const JsonValue value : read_array(required, {"extensionsRequired"}, place).items()) {
      const std::string_view name = read_text(value, {"extensionsRequired", number++}, place);
      if (is_harmless(name)) continue;
      throw place.error(value.offset(),
                        fmt::format("the file needs the extension {}, which graze does not read; export "
                                    "it without",
                                    in_quotes(name)));
    }
  }

  void note_animations(JsonValue animations) {
    const std::size_t count = read_array(animations, {"animations"}, root_.place()).size();
    if (count > 0) file_.omissions.push_back({"animation", count});
  }

  std::vector<Visit> nodes_in(JsonValue list, std::string_view name, const JsonPlace& place) const {
    std::vector<Visit> nodes;
    for (const JsonValue value : read_array(list, {name}, place).items()) {
      nodes.push_back({root_.index(value, {name, nodes.size()}, place, GltfArray::nodes)});
    }
    return nodes;
  }

  /// The roots of the default scene, else of the first; without scenes, all nodes that are no children.
  std::vector<Visit> roots() const {
    const JsonFields root = root_.fields();
    std::size_t scene = 0;
    if (const auto value = root.find("scene")) scene = root_.index(*value, {"scene"}, root_.place(), GltfArray::scenes);
    if (root_.size(GltfArray::scenes) > 0) {
      const GltfItem item = root_.item(GltfArray::scenes, scene);
      const auto nodes = item.fields().find("nodes");
      return nodes ? nodes_in(*nodes, "nodes", item.place) : std::vector<Visit>();
    }
    std::vector<bool> is_child(root_.size(GltfArray::nodes), false);
    for (std::size_t i = 0; i < is_child.size(); ++i) {
      for (const Visit& child : children_of(root_.item(GltfArray::nodes, i))) is_child[child.node] = true;
    }
    std::vector<Visit> result;
    for (std::size_t i = 0; i < is_child.size(); ++i) {
      if (!is_child[i]) result.push_back({i});
    }
    return result;
  }

  std::vector<Visit> children_of(const GltfItem& node) const {
    const auto children = node.fields().find("children");
    return children ? nodes_in(*children, "children", node.place) : std::vector<Visit>();
  }

  void read_node(const Visit& visit) {
    const GltfItem node = root_.item(GltfArray::nodes, visit.node);
    if (visited_[visit.node]) {
      throw node.place.error(node.value.offset(), "is a child of two nodes, or of itself; the nodes must be a tree");
    }
    visited_[visit.node] = true;
    const GltfTransform transform = visit.outer.after(transform_of_node(node));
    if (const auto mesh = node.fields().find("mesh")) {
      add_part(node, root_.index(*mesh, {"mesh"}, node.place, GltfArray::meshes), transform);
    }
    std::vector<Visit> children = children_of(node);
    for (Visit& child : children) child.outer = transform;
    open_.insert(open_.end(), children.rbegin(), children.rend());
  }

  static std::string name_in(const GltfItem& item) {
    const auto name = item.fields().find("name");
    return name && name->kind() == JsonKind::text ? printable(name->text()) : "";
  }

  void add_part(const GltfItem& node, std::size_t mesh, const GltfTransform& transform) {
    const GltfItem item = root_.item(GltfArray::meshes, mesh);
    std::string name = name_in(node);
    if (name.empty()) name = name_in(item);
    note_deformations(node, item);
    try {
      file_.parts.push_back({std::move(name), placement_.placed(meshes_.mesh(mesh), transform)});
    } catch (const std::invalid_argument&) {
      throw node.place.error(node.value.offset(), "moves a vertex of its mesh to where numbers end, about 1.8e308");
    } catch (const std::length_error& error) {
      throw node.place.error(node.value.offset(), error.what());
    }
  }

  /// What moves single vertices; the mesh is read as it is without.
  void note_deformations(const GltfItem& node, const GltfItem& mesh) {
    const std::string where = fmt::format("{}, node {}", file_.source, node.place.index);
    if (node.fields().find("skin")) count_omission(file_.omissions, "skin", Loss::precision, where);
    const auto weights = node.fields().find("weights") ? node.fields().find("weights") : mesh.fields().find("weights");
    if (weights && weights->kind() == JsonKind::array) {
      bool is_morphed = false;
      for (const JsonValue weight : weights->items()) {
        is_morphed = is_morphed || !weight.is_number() || weight.number() != 0;
      }
      if (is_morphed) count_omission(file_.omissions, "morph target", Loss::precision, where);
    }
    const auto extensions = node.fields().find("extensions");
    if (extensions && extensions->kind() == JsonKind::object && extensions->find("EXT_mesh_gpu_instancing")) {
      count_omission(file_.omissions, "instances by EXT_mesh_gpu_instancing", Loss::shape, where);
    }
  }

  MeshFile file_;
  GltfRoot root_;
  GltfAccessors accessors_;
  GltfMeshes meshes_;
  GltfPlacement placement_;
  std::vector<bool> visited_;
  std::vector<Visit> open_;
};

}  // namespace

MeshFile read_gltf(const JsonDocument& document, std::optional<std::string_view> binary,
                   const std::filesystem::path& folder) {
  return GltfReader(document, binary, folder).read();
}

MeshFile read_glb_file(std::string_view bytes, const std::string& source, const std::filesystem::path& folder) {
  const GlbChunks chunks = read_glb(bytes, source);
  return read_gltf(JsonDocument(chunks.json, source), chunks.binary, folder);
}

}  // namespace graze::io
