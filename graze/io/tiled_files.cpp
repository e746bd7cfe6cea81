// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/printable.hpp>
#include <graze/io/tiled_files.hpp>
#include <graze/io/tiled_json.hpp>
#include <graze/io/tiled_xml.hpp>
#include <graze/io/utf8.hpp>

namespace graze::io {
namespace {

namespace fs = std::filesystem;

/// Tiled keeps in the upper bits of a gid how the tile is flipped or, on hexagonal maps, turned; none of it moves its
/// box.
constexpr std::uint32_t gid_bits = 0x0fffffffU;

/// A path as the files write it, in UTF-8 on every system.
fs::path path_of(const std::string& text) { return {std::u8string(text.begin(), text.end())}; }

/// The path as messages show it: whole, because its end is what tells files apart.
std::string name_of(const fs::path& path) {
  const std::u8string text = path.generic_u8string();
  return printable(std::string(text.begin(), text.end()));
}

/// Why a file cannot be read, or nothing. Devices and pipes are refused: they may never end.
std::string_view obstacle(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found ||
      path.native().find(fs::path::value_type{}) != fs::path::string_type::npos)
    return "there is no such file";
  if (status.type() == fs::file_type::directory) return "it is a folder";
  if (error || status.type() != fs::file_type::regular)
    return "it is not a regular file, or a folder of its path is closed";
  return "";
}

/// The text of the file that a map, tileset or template refers to. `role` says what it is to be: "template".
std::string read_reference(const fs::path& path, std::string_view role, const TiledText& asker, std::size_t offset) {
  std::string_view reason = obstacle(path);
  std::string text;
  if (reason.empty()) {
    std::ifstream stream(path, std::ios::binary);
    text.assign(std::istreambuf_iterator<char>(stream), {});
    if (!stream.is_open() || stream.bad()) reason = "it cannot be opened or read";
  }
  if (!reason.empty()) {
    fail_at(asker, offset,
            fmt::format("the {} \"{}\" cannot be read: {}; references are relative to the file that makes them", role,
                        name_of(path), reason));
  }
  return text;
}

/// The tile of a gid without flip bits; none when no tileset holds it.
std::optional<TiledTileUse> find_tile(std::uint32_t gid, const std::vector<TiledTilesetUse>& tilesets) {
  const auto beyond = std::upper_bound(tilesets.begin(), tilesets.end(), gid,
                                       [](std::uint32_t number, const auto& use) { return number < use.first_gid; });
  if (beyond == tilesets.begin()) return std::nullopt;
  const TiledTilesetUse& use = *std::prev(beyond);
  const TiledTileset& tileset = *use.tileset;
  const std::uint32_t id = gid - use.first_gid;
  const auto tile = tileset.tiles.find(id);
  if (tile != tileset.tiles.end()) return TiledTileUse{&tileset, &tile->second};
  // A collection lists all its tiles, with gaps in the numbers; the tiles of one image are counted.
  if (tileset.is_collection || id >= tileset.tile_count.value_or(gid_bits)) return std::nullopt;
  return TiledTileUse{&tileset, nullptr};
}

std::optional<TiledTileUse> tile_of(const TiledObject& object, const TiledScope& scope) {
  const std::uint32_t gid = object.gid.value_or(0) & gid_bits;
  if (gid == 0) return std::nullopt;
  const std::optional<TiledTileUse> tile = find_tile(gid, scope.tilesets);
  if (!tile) {
    fail_at(scope.file, object.offset,
            fmt::format("{} shows tile {} (gid {}), which none of the {} tilesets here holds", described(object), gid,
                        *object.gid, scope.tilesets.size()));
  }
  return tile;
}

/// Tiled writes a size of 0 for "as large as the tile", so it does not override.
std::optional<double> size_of(std::optional<double> own, std::optional<double> other) {
  return own.value_or(0) != 0 || !other ? own : other;
}

/// An object with the words of its template where it has none of its own.
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

/// Gives an object the size of its tile where it has none: that of the tile's image, else that of all tiles of the
/// tileset.
void add_tile_size(TiledResolvedObject& resolved, const TiledScope& scope) {
  TiledObject& object = resolved.object;
  const TiledTileset& tileset = *resolved.tile->tileset;
  const TiledTile tile = resolved.tile->tile != nullptr ? *resolved.tile->tile : TiledTile{};
  object.width = size_of(object.width, tile.width ? tile.width : tileset.tile_width);
  object.height = size_of(object.height, tile.height ? tile.height : tileset.tile_height);
  if (object.width && object.height) return;
  fail_at(scope.file, object.offset,
          fmt::format("{} has no size, and neither its tile nor its tileset has one; give it a width and a height",
                      described(object)));
}

/// Refuses to open a template that is open already, or too many inside each other. `open`: each made from the next.
void refuse_circle(const fs::path& path, const TiledObject& user, const TiledScope& scope,
                   const std::vector<fs::path>& open) {
  const auto again = std::find(open.begin(), open.end(), path);
  if (again != open.end()) {
    std::string chain;
    for (auto step = again; step != open.end(); ++step) chain += fmt::format("\"{}\" -> ", name_of(*step));
    fail_at(
        scope.file, user.offset,
        fmt::format("the template includes itself: {}\"{}\"; an object in a template must not use that template again",
                    chain, name_of(path)));
  }
  if (open.size() == TiledFiles::max_template_depth) {
    fail_at(scope.file, user.offset,
            fmt::format("this template is made from a template, and so on, {} times; that is the limit",
                        TiledFiles::max_template_depth));
  }
}

}  // namespace

bool is_tiled_xml(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '<';
}

std::vector<TiledTilesetUse> TiledFiles::tilesets(const std::vector<TiledTileset>& written, const TiledText& file,
                                                  const fs::path& folder) {
  std::vector<TiledTilesetUse> uses;
  uses.reserve(written.size());
  for (const TiledTileset& tileset : written) {
    uses.push_back({tileset.first_gid, tileset.source.empty() ? &tileset : &tileset_file(tileset, file, folder)});
  }
  std::stable_sort(uses.begin(), uses.end(),
                   [](const TiledTilesetUse& a, const TiledTilesetUse& b) { return a.first_gid < b.first_gid; });
  return uses;
}

const TiledTileset& TiledFiles::tileset_file(const TiledTileset& reference, const TiledText& file,
                                             const fs::path& folder) {
  const fs::path path = (folder / path_of(reference.source)).lexically_normal();
  if (const auto known = tilesets_.find(path); known != tilesets_.end()) return known->second;
  const std::string bytes = read_reference(path, "tileset", file, reference.offset);
  const TiledText text{name_of(path), without_byte_order_mark(bytes)};
  const TiledTileset tileset = is_tiled_xml(text.text) ? read_tiled_xml_tileset(text) : read_tiled_json_tileset(text);
  return tilesets_.emplace(path, tileset).first->second;
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
  const fs::path path = (scope.folder / path_of(user.template_source)).lexically_normal();
  if (const auto known = resolved_.find(path); known != resolved_.end()) return known->second;
  refuse_circle(path, user, scope, open);

  const std::string bytes = read_reference(path, "template", scope.file, user.offset);
  const TiledText text{name_of(path), without_byte_order_mark(bytes)};
  TiledTemplate& read = templates_[path];
  read = is_tiled_xml(text.text) ? read_tiled_xml_template(text) : read_tiled_json_template(text);
  std::vector<TiledTilesetUse> uses;
  const fs::path folder = path.parent_path();
  if (read.tileset && !read.tileset->source.empty()) {
    uses.push_back({read.tileset->first_gid, &tileset_file(*read.tileset, text, folder)});
  } else if (read.tileset) {
    uses.push_back({read.tileset->first_gid, &*read.tileset});
  }

  open.push_back(path);
  TiledResolvedObject resolved = with_template(read.object, {text, folder, uses}, open);
  open.pop_back();
  return resolved_.emplace(path, std::move(resolved)).first->second;
}

}  // namespace graze::io
