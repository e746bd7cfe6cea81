// SPDX-License-Identifier: MIT
#include <cerrno>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include <graze/io/csv_boxes.hpp>
#include <graze/io/input_error.hpp>
#include <graze/io/json_document.hpp>
#include <graze/io/json_scene.hpp>
#include <graze/io/scene_file.hpp>
#include <graze/io/tiled.hpp>
#include <graze/io/utf8.hpp>

namespace graze::io {
namespace {

namespace fs = std::filesystem;

/// All that a file holds, read until its end: a pipe has no size to ask for, and a stated size is not to be trusted.
std::string read_whole_file(const fs::path& path) {
  const std::string source = path.string();
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::status_known(status)) throw InputError(source + ": cannot be read: " + error.message());
  if (!fs::exists(status)) throw InputError(source + ": there is no such file");
  if (fs::is_directory(status)) throw InputError(source + ": this is a folder; give the scene file in it");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(source + ": cannot be opened: " + std::generic_category().message(errno));
  std::string text;
  char chunk[1U << 16U];
  while (in.read(chunk, sizeof chunk) || in.gcount() > 0) text.append(chunk, static_cast<std::size_t>(in.gcount()));
  if (in.bad()) throw InputError(source + ": reading failed: " + std::generic_category().message(errno));
  return text;
}

/// Tiled writes its own version into every map, and "type": "map" since 1.0.
bool is_tiled_map(JsonValue root) {
  if (root.kind() != JsonKind::object) return false;
  const std::optional<JsonValue> type = root.find("type");
  return root.find("tiledversion") || (type && type->kind() == JsonKind::text && type->text() == "map");
}

SceneFile parse_json(std::string_view text, const std::string& source, const fs::path& folder) {
  const JsonDocument document(text, source);
  return is_tiled_map(document.root()) ? parse_tiled_map(text, source, folder) : read_json_scene(document);
}

}  // namespace

SceneFile read_scene(const fs::path& path) {
  const std::string text = read_whole_file(path);
  return parse_scene(text, path.string(), path.parent_path());
}

SceneFile parse_scene(std::string_view text, const std::string& source, const fs::path& folder) {
  const std::string_view content = without_byte_order_mark(text);
  const std::size_t begin = content.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) throw InputError(source + ": this is empty; a scene needs at least its header");
  const char first = content[begin];
  if (first == '<') return parse_tiled_map(content, source, folder);
  if (first == '{' || first == '[') return parse_json(content, source, folder);
  const bool is_utf16 = content.starts_with("\xFF\xFE") || content.starts_with("\xFE\xFF");
  if (is_utf16) throw InputError(source + ": this is UTF-16; save it as UTF-8");
  const std::string_view line = content.substr(begin, content.find('\n', begin) - begin);
  if (line.find(',') != std::string_view::npos) return parse_csv_boxes(content, source);
  throw InputError(source +
                   ": not a scene; graze reads its own JSON (begins with {), CSV of boxes (begins with a line like "
                   "id,min_x,min_y,max_x,max_y) and maps of Tiled, .tmx or .tmj (begin with < or {)");
}

}  // namespace graze::io
