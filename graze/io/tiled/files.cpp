// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/file/referenced_file.hpp>
#include <graze/io/file/utf8_path.hpp>
#include <graze/io/input_error.hpp>
#include <graze/io/text/position.hpp>
#include <graze/io/text/printable.hpp>
#include <graze/io/text/utf8.hpp>
#include <graze/io/tiled/files.hpp>
#include <graze/io/tiled/json.hpp>
#include <graze/io/tiled/xml.hpp>

namespace graze::io {
namespace {

namespace fs = std::filesystem;

/// The path for messages: not shortened, because its end distinguishes files.
std::string name_of(const fs::path& path) {
  const std::u8string text = path.generic_u8string();
  return printable(std::string(text.begin(), text.end()));
}

/// The text of a referenced file, or a complete message why it cannot be read.
struct Reference {
  std::string text;
  std::string fault;
};

/// `role` is the expected kind of file: "template".
Reference read_reference(const fs::path& path, std::string_view role, const TiledPlace& asker) {
  ReferencedFile file = read_referenced_file(path);
  Reference read{std::move(file.bytes), ""};
  if (file.fault.empty()) return read;
  const TextPosition position = position_of(asker.file.text, asker.offset);
  read.fault = fmt::format(
      "{}: line {}, column {}: the {} \"{}\" cannot be read: {}; references are relative to the file that makes them",
      asker.file.name, position.line, position.column, role, name_of(path), file.fault);
  return read;
}

/// The result of `read` on a referenced file; errors also name the file that refers to it.
template <class Read>
auto read_for(const TiledPlace& asker, std::string_view role, const Read& read) {
  try {
    return read();
  } catch (const InputError& error) {
    const TextPosition position = position_of(asker.file.text, asker.offset);
    throw InputError(fmt::format("{}; {} refers to it as a {} in line {}, column {}", error.what(), asker.file.name,
                                 role, position.line, position.column));
  }
}

/// True for XML, false for JSON; refuses everything else. `role` is the expected kind of file: "template".
bool is_xml_reference(const TiledText& text, std::string_view role) {
  if (is_tiled_xml(text.text)) return true;
  const std::size_t first = text.text.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && text.text[first] == '{') return false;
  fail_at(text, 0, fmt::format("this is not a Tiled {}: it begins with neither < (XML) nor {{ (JSON)", role));
}

TiledTileset parse_tileset(const TiledText& text) {
  return is_xml_reference(text, "tileset") ? read_tiled_xml_tileset(text) : read_tiled_json_tileset(text);
}

TiledTemplate parse_template(const TiledText& text) {
  return is_xml_reference(text, "template") ? read_tiled_xml_template(text) : read_tiled_json_template(text);
}

std::optional<TiledTileUse> tile_of(const TiledObject& object, const TiledScope& scope) {
  const std::uint32_t gid = object.gid.value_or(0) & tiled_gid_bits;
  if (gid == 0) return std::nullopt;
  const TiledFoundTile found = find_tiled_tile(gid, scope.tilesets);
  if (found.use != nullptr && !found.use->fault.empty()) throw InputError(found.use->fault);
  if (!found.tile) {
    fail_at(scope.file, object.offset,
            fmt::format("{} shows tile {} (gid {}), which none of the {} tilesets here holds", described(object), gid,
                        *object.gid, scope.tilesets.size()));
  }
  return found.tile;
}

/// Tiled writes a size of 0 for "as large as the tile", so 0 does not override the template.
std::optional<double> size_of(std::optional<double> own, std::optional<double> other) {
  return own.value_or(0) != 0 || !other ? own : other;
}

/// An object with the fields of its template where it has none of its own.
TiledResolvedObject merged(const TiledResolvedObject& own, const TiledResolvedObject& base) {
  TiledResolvedObject result = own;
  TiledObject& object = result.object;
  const TiledObject& other = base.object;
  if (!object.name) object.name = other.name;
  if (!object.rotation) object.rotation = other.rotation;
  object.width = size_of(object.width, other.width);
  object.height = size_of(object.height, other.height);
  if (!object.outline && !own.tile) {
    object.outline = other.outline;
    object.points = other.points;
    result.tile = base.tile;
  }
  object.properties += other.properties;
  object.has_class = object.has_class || other.has_class;
  return result;
}

/// Sets the size of an object without one to that of its tile's image.
void add_tile_size(TiledResolvedObject& resolved, const TiledScope& scope) {
  TiledObject& object = resolved.object;
  const Vec<2, double> picture = tiled_picture_size(*resolved.tile);
  if (picture.x != 0) object.width = size_of(object.width, picture.x);
  if (picture.y != 0) object.height = size_of(object.height, picture.y);
  if (object.width && object.height) return;
  fail_at(scope.file, object.offset,
          fmt::format("{} has no size, and neither its tile nor its tileset has one; give it a width and a height",
                      described(object)));
}

/// Refuses to open a template that is already open, or too deeply nested templates. `open`: the chain of templates that
/// are being read.
void refuse_circle(const fs::path& path, const TiledObject& user, const TiledScope& scope,
                   const std::vector<fs::path>& open) {
  const auto again = std::find(open.begin(), open.end(), path);
  if (again != open.end()) {
    std::string chain;
    for (auto step = again; step != open.end(); ++step) chain += fmt::format("\"{}\" -> ", name_of(*step));
    fail_at(scope.file, user.offset,
            fmt::format("the template includes itself: {}\"{}\"; the object in a template must not use that template",
                        chain, name_of(path)));
  }
  if (open.size() == TiledFiles::max_template_depth) {
    fail_at(scope.file, user.offset,
            fmt::format("templates are nested deeper than {} levels, the most that is allowed",
                        TiledFiles::max_template_depth));
  }
}

}  // namespace

bool is_tiled_xml(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '<';
}

TiledFoundTile find_tiled_tile(std::uint32_t gid, const std::vector<TiledTilesetUse>& tilesets) {
  const std::uint32_t number = gid & tiled_gid_bits;
  const auto beyond = std::upper_bound(tilesets.begin(), tilesets.end(), number,
                                       [](std::uint32_t of, const auto& use) { return of < use.first_gid; });
  if (beyond == tilesets.begin()) return {};
  const TiledTilesetUse& use = *std::prev(beyond);
  const TiledTileset& tileset = *use.tileset;
  const std::uint32_t id = number - use.first_gid;
  const auto tile = tileset.tiles.find(id);
  if (tile != tileset.tiles.end()) return {&use, TiledTileUse{&tileset, &tile->second}};
  // An image collection lists all its tiles, with gaps in their ids; the tiles of a single image are only counted.
  if (tileset.is_collection || id >= tileset.tile_count.value_or(tiled_gid_bits)) return {&use, std::nullopt};
  return {&use, TiledTileUse{&tileset, nullptr}};
}

Vec<2, double> tiled_picture_size(const TiledTileUse& use) {
  const TiledTile tile = use.tile != nullptr ? TiledTile{use.tile->width, use.tile->height, {}} : TiledTile{};
  return {size_of(tile.width, use.tileset->tile_width).value_or(0),
          size_of(tile.height, use.tileset->tile_height).value_or(0)};
}

std::vector<TiledTilesetUse> TiledFiles::tilesets(const std::vector<TiledTileset>& written, const TiledText& file,
                                                  const fs::path& folder) {
  std::vector<TiledTilesetUse> uses;
  uses.reserve(written.size());
  for (const TiledTileset& tileset : written) uses.push_back(use_of(tileset, file, folder));
  std::stable_sort(uses.begin(), uses.end(),
                   [](const TiledTilesetUse& a, const TiledTilesetUse& b) { return a.first_gid < b.first_gid; });
  return uses;
}

TiledTilesetUse TiledFiles::use_of(const TiledTileset& written, const TiledText& file, const fs::path& folder) {
  if (written.source.empty()) return {written.first_gid, &written, ""};
  const fs::path path = (folder / path_from_utf8(written.source)).lexically_normal();
  if (const auto known = tilesets_.find(path); known != tilesets_.end()) return {written.first_gid, &known->second, ""};
  const TiledPlace asker{file, written.offset};
  const Reference read = read_reference(path, "tileset", asker);
  if (!read.fault.empty()) return {written.first_gid, &written, read.fault};
  const TiledText text{name_of(path), without_byte_order_mark(read.text)};
  const TiledTileset tileset = read_for(asker, "tileset", [&] { return parse_tileset(text); });
  return {written.first_gid, &tilesets_.emplace(path, tileset).first->second, ""};
}

TiledResolvedObject TiledFiles::resolve(const TiledObject& object, const TiledScope& scope) {
  std::vector<fs::path> open;
  TiledResolvedObject resolved = with_template(object, scope, open);
  if (resolved.tile) add_tile_size(resolved, scope);
  return resolved;
}

TiledResolvedObject TiledFiles::with_template(const TiledObject& object, const TiledScope& scope,
                                              std::vector<fs::path>& open) {
  const TiledResolvedObject own{object, tile_of(object, scope)};
  return object.template_source.empty() ? own : merged(own, template_file(object, scope, open));
}

const TiledResolvedObject& TiledFiles::template_file(const TiledObject& user, const TiledScope& scope,
                                                     std::vector<fs::path>& open) {
  const fs::path path = (scope.folder / path_from_utf8(user.template_source)).lexically_normal();
  if (const auto known = resolved_.find(path); known != resolved_.end()) return known->second;
  refuse_circle(path, user, scope, open);

  const TiledPlace asker{scope.file, user.offset};
  const Reference reference = read_reference(path, "template", asker);
  if (!reference.fault.empty()) throw InputError(reference.fault);
  const TiledText text{name_of(path), without_byte_order_mark(reference.text)};
  TiledTemplate& read = templates_[path];
  read = read_for(asker, "template", [&] { return parse_template(text); });
  std::vector<TiledTilesetUse> uses;
  const fs::path folder = path.parent_path();
  if (read.tileset) uses.push_back(use_of(*read.tileset, text, folder));

  open.push_back(path);
  TiledResolvedObject resolved = with_template(read.object, {text, folder, uses}, open);
  open.pop_back();
  return resolved_.emplace(path, std::move(resolved)).first->second;
}

}  // namespace graze::io
