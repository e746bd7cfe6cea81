// SPDX-License-Identifier: MIT
// The files around a map, external tilesets and templates, and what an object is once they are looked up.
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

/// Tiled keeps in the upper bits of a gid how the tile is flipped or turned; these are the others.
inline constexpr std::uint32_t tiled_gid_bits = 0x0fffffffU;

/// A tileset as one map or template numbers its tiles.
struct TiledTilesetUse {
  std::uint32_t first_gid = 1;
  const TiledTileset* tileset = nullptr;  ///< Of one whose file cannot be read, the reference to it.
  std::string fault;                      ///< Why its file cannot be read, as a whole message; empty when it was read.
};

/// The tile that an object shows.
struct TiledTileUse {
  const TiledTileset* tileset = nullptr;
  const TiledTile* tile = nullptr;  ///< Null when the tileset says nothing about this tile.
};

/// The tileset in whose range a gid is, none before the first; and the tile, none when the tileset does not hold it.
struct TiledFoundTile {
  const TiledTilesetUse* use = nullptr;
  std::optional<TiledTileUse> tile;
};

/// Looks a gid up, with or without its flip bits. `tilesets` are by ascending number.
TiledFoundTile find_tiled_tile(std::uint32_t gid, const std::vector<TiledTilesetUse>& tilesets);

/// The size of a tile's picture: of its own image, else what the tileset says of all; 0 where neither does.
Vec<2, double> tiled_picture_size(const TiledTileUse& use);

/// What surrounds an object: the file that it stands in, the folder that its references start from, its tilesets by
/// ascending number.
struct TiledScope {
  const TiledText& file;
  const std::filesystem::path& folder;
  const std::vector<TiledTilesetUse>& tilesets;
};

/// An object with everything that its template says, and its tile.
struct TiledResolvedObject {
  TiledObject object;
  std::optional<TiledTileUse> tile;
};

/// Reads each file around a map once. Whatever it gives refers to itself, and to the map given.
class TiledFiles {
 public:
  /// How many templates may be made from each other.
  static constexpr std::size_t max_template_depth = 16;

  /// The tilesets of a map or template, by ascending number; external ones are read. One whose file is missing is named
  /// in the use's `fault`, since nobody may need it; one that is broken throws InputError, naming who asks for it.
  std::vector<TiledTilesetUse> tilesets(const std::vector<TiledTileset>& written, const TiledText& file,
                                        const std::filesystem::path& folder);

  /// The object with its template and tile; its own words win over the template's, and a size that neither has is the
  /// tile's. Throws InputError for a template that is missing, broken or made from itself, for a tile that no tileset
  /// holds or whose tileset is missing, and for one whose size is said nowhere.
  TiledResolvedObject resolve(const TiledObject& object, const TiledScope& scope);

 private:
  TiledTilesetUse use_of(const TiledTileset& written, const TiledText& file, const std::filesystem::path& folder);
  // `open`: the templates that are being read, each made from the next.
  TiledResolvedObject with_template(const TiledObject& object, const TiledScope& scope,
                                    std::vector<std::filesystem::path>& open);
  const TiledResolvedObject& template_file(const TiledObject& user, const TiledScope& scope,
                                           std::vector<std::filesystem::path>& open);

  // Maps of path to file, because their elements stay where they are while more are read.
  std::map<std::filesystem::path, TiledTileset> tilesets_;
  std::map<std::filesystem::path, TiledTemplate> templates_;
  std::map<std::filesystem::path, TiledResolvedObject> resolved_;
};

/// True when a text is XML: what both XML and JSON readers may be given begins with '<' in XML and never in JSON.
bool is_tiled_xml(std::string_view text);

}  // namespace graze::io
