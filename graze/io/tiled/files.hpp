// SPDX-License-Identifier: MIT
// The external tilesets and templates of a map, and its objects with all references resolved.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <graze/io/tiled/model.hpp>

namespace graze::io {

/// The lower bits of a gid; Tiled uses the upper bits for flips and rotations.
inline constexpr std::uint32_t tiled_gid_bits = 0x0fffffffU;

/// A tileset with the numbering that one map or template gives it.
struct TiledTilesetUse {
  std::uint32_t first_gid = 1;
  const TiledTileset* tileset = nullptr;  ///< If its file cannot be read, the element that refers to it.
  std::string fault;                      ///< A complete message why its file cannot be read; empty if it was read.
};

/// The tile of an object.
struct TiledTileUse {
  const TiledTileset* tileset = nullptr;
  const TiledTile* tile = nullptr;  ///< Null if the tileset contains no data about this tile.
};

/// The tileset whose range contains a gid, none before the first; and the tile, none if the tileset does not contain
/// it.
struct TiledFoundTile {
  const TiledTilesetUse* use = nullptr;
  std::optional<TiledTileUse> tile;
};

/// Looks up a gid, with or without its flip bits. `tilesets` are sorted by number.
TiledFoundTile find_tiled_tile(std::uint32_t gid, const std::vector<TiledTilesetUse>& tilesets);

/// The size of a tile's image: of its own image, otherwise that given by the tileset; 0 if neither exists.
Vec<2, double> tiled_picture_size(const TiledTileUse& use);

/// The context of an object: the file that contains it, the folder that its references are relative to, and its
/// tilesets sorted by number.
struct TiledScope {
  const TiledText& file;
  const std::filesystem::path& folder;
  const std::vector<TiledTilesetUse>& tilesets;
};

/// An object with all fields from its template, and its tile.
struct TiledResolvedObject {
  TiledObject object;
  std::optional<TiledTileUse> tile;
};

/// Reads each external file of a map once. Results refer to this object and to the map.
class TiledFiles {
 public:
  /// How deeply templates may be nested.
  static constexpr std::size_t max_template_depth = 16;

  /// The tilesets of a map or template, sorted by number; external ones are read. A missing file is reported in the
  /// use's `fault`, because no object may need it; a broken file throws InputError, naming the file that refers to it.
  std::vector<TiledTilesetUse> tilesets(const std::vector<TiledTileset>& written, const TiledText& file,
                                        const std::filesystem::path& folder);

  /// The object with its template and tile; its own fields override the template's, and a size that neither gives is
  /// the tile's. Throws InputError for a template that is missing, broken or recursive, for a tile that no tileset
  /// contains or whose tileset is missing, and for a tile without a size.
  TiledResolvedObject resolve(const TiledObject& object, const TiledScope& scope);

 private:
  TiledTilesetUse use_of(const TiledTileset& written, const TiledText& file, const std::filesystem::path& folder);
  // `open`: the chain of templates that are being read.
  TiledResolvedObject with_template(const TiledObject& object, const TiledScope& scope,
                                    std::vector<std::filesystem::path>& open);
  const TiledResolvedObject& template_file(const TiledObject& user, const TiledScope& scope,
                                           std::vector<std::filesystem::path>& open);

  // Maps from path to file, because their elements keep their addresses when more files are read.
  std::map<std::filesystem::path, TiledTileset> tilesets_;
  std::map<std::filesystem::path, TiledTemplate> templates_;
  std::map<std::filesystem::path, TiledResolvedObject> resolved_;
};

/// True if a text is XML rather than JSON: XML begins with '<' and JSON never does.
bool is_tiled_xml(std::string_view text);

}  // namespace graze::io
