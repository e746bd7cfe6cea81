// SPDX-License-Identifier: MIT
// The files around a map, external tilesets and templates, and what an object is once they are looked up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include <graze/io/tiled_model.hpp>

namespace graze::io {

/// A tileset as one map or template numbers its tiles.
struct TiledTilesetUse {
  std::uint32_t first_gid = 1;
  const TiledTileset* tileset = nullptr;
};

/// The tile that an object shows.
struct TiledTileUse {
  const TiledTileset* tileset = nullptr;
  const TiledTile* tile = nullptr;  ///< Null when the tileset says nothing about this tile.
};

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

  /// The tilesets of a map or template, by ascending number; external ones are read. Throws InputError, naming who asks
  /// and what is missing.
  std::vector<TiledTilesetUse> tilesets(const std::vector<TiledTileset>& written, const TiledText& file,
                                        const std::filesystem::path& folder);

  /// The object with its template and tile; its own words win over the template's, and a size that neither has is the
  /// tile's. Throws InputError for a template that is missing, broken or made from itself, for a tile that no tileset
  /// holds, and for one whose size is said nowhere.
  TiledResolvedObject resolve(const TiledObject& object, const TiledScope& scope);

 private:
  const TiledTileset& tileset_file(const TiledTileset& reference, const TiledText& file,
                                   const std::filesystem::path& folder);
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
