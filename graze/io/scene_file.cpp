// SPDX-License-Identifier: MIT
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <graze/io/csv/records.hpp>
#include <graze/io/csv/scene.hpp>
#include <graze/io/file/utf8_path.hpp>
#include <graze/io/file/whole_file.hpp>
#include <graze/io/gltf/reader.hpp>
#include <graze/io/gltf/root.hpp>
#include <graze/io/input_error.hpp>
#include <graze/io/json/document.hpp>
#include <graze/io/json_scene.hpp>
#include <graze/io/mesh/format.hpp>
#include <graze/io/mesh/scene.hpp>
#include <graze/io/mesh_file.hpp>
#include <graze/io/scene_file.hpp>
#include <graze/io/text/foreign_format.hpp>
#include <graze/io/text/utf8.hpp>
#include <graze/io/tiled/map.hpp>

namespace graze::io {
namespace {

namespace fs = std::filesystem;

/// Tiled writes its version into every map, and "type": "map" since 1.0. Older maps only have an orientation and
/// layers.
bool is_tiled_map(JsonValue root) {
  if (root.kind() != JsonKind::object) return false;
  const std::optional<JsonValue> type = root.find("type");
  if (type && type->kind() == JsonKind::text && type->text() == "map") return true;
  return root.find("tiledversion") || (root.find("orientation") && root.find("layers") && !root.find("schema"));
}

SceneFile scene_of(MeshFile meshes, const SceneReading& reading) {
  if (reading.meshes == MeshKind::solid) make_closed_parts_solid(meshes);
  return scene_of_meshes(std::move(meshes));
}

SceneFile parse_json(std::string_view text, const std::string& source, const fs::path& folder,
                     const SceneReading& reading) {
  const JsonDocument document(text, source, 1, "data");  // the field that holds the tiles of Tiled's layers
  if (is_gltf(document.root())) return scene_of(read_gltf(document, std::nullopt, folder), reading);
  return is_tiled_map(document.root()) ? read_tiled_map(document, text, source, folder)
                                       : read_json_scene(document, folder);
}

}  // namespace

SceneFile read_scene(const fs::path& path, const SceneReading& reading) {
  const std::string text = read_whole_file(path, "the scene file");
  return parse_scene(text, utf8_from_path(path), path.parent_path(), reading);
}

SceneFile parse_scene(std::string_view text, const std::string& source, const fs::path& folder,
                      const SceneReading& reading) {
  if (mesh_format_of(text)) return scene_of(parse_meshes(text, source, folder), reading);
  const std::string_view content = without_byte_order_mark(text);
  const std::size_t begin = content.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) throw InputError(source + ": this is empty; a scene needs at least its header");
  if (const std::string foreign = foreign_format(content); !foreign.empty()) throw InputError(source + ": " + foreign);
  const char first = content[begin];
  if (first == '<') return parse_tiled_map(content, source, folder);
  if (first == '{' || first == '[') return parse_json(content, source, folder, reading);
  const std::string_view line = content.substr(begin, content.find_first_of("\r\n", begin) - begin);
  if (line.find(csv_separator(line)) != std::string_view::npos) return parse_csv_scene(content, source);
  throw InputError(source +
                   ": not a scene; graze reads its own JSON (begins with {), CSV (begins with a line like "
                   "id,min_x,min_y,max_x,max_y or x,y,radius), maps of Tiled, .tmx or .tmj (begin with < or {), and "
                   "meshes in " +
                   std::string(mesh_formats_in_words));
}

}  // namespace graze::io
