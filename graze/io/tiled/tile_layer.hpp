// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <graze/io/tiled/files.hpp>
#include <graze/io/tiled/model.hpp>
#include <graze/io/tiled/omissions.hpp>
#include <graze/io/tiled/projection.hpp>
#include <graze/io/tiled/tile_shapes.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/scene.hpp>

namespace graze::io {

/// A tile layer, its name and screen offset including those of its groups, and its position.
struct TiledPlacedTiles {
  TiledLayer& layer;  ///< Its cells are released once they have become objects.
  const std::string& name;
  Vec<2, double> shift;
  TiledPlace place;
};

/// How many objects the tile layers of a map may become before small ones are joined.
inline constexpr std::size_t most_tile_objects = std::size_t{1} << 18U;

/// Turns tile layers into objects. All references must outlive this.
class TiledTileLayers {
 public:
  /// `taken` are the names of all other objects of the map.
  TiledTileLayers(const std::vector<TiledTilesetUse>& tilesets, const TiledProjection& projection,
                  const std::unordered_set<std::string>& taken, std::size_t most_objects = most_tile_objects)
      : tilesets_(tilesets), projection_(projection), taken_(taken), room_(most_objects) {}

  /// Adds a fixed object for each collision shape of the layer's tiles; fixed, so that they form no pairs among
  /// themselves. Adjacent, completely covered cells are merged into rectangles of cells. Objects are named after the
  /// layer and their cells: "walls[3,0]", "walls[0..31,7..9]"; the second of several in one cell is "walls[3,0]#2". If
  /// these and those of earlier layers exceed `most_objects`, those that fit into a block of cells (see TileBlocks) are
  /// joined into one compound for each block, named after all its cells, so that memory grows with parts instead of
  /// objects. What is not read is counted. Throws std::invalid_argument if a coordinate overflows, and whatever
  /// `Scene::layer` throws.
  void add(const TiledPlacedTiles& tiles, Scene<2, double>& scene, std::vector<Omission>& omissions);

 private:
  /// The meaning of a gid.
  struct Entry {
    TiledTileShapes tile;
    const OmissionKind* lack = nullptr;  ///< Why it has no shape.
    std::uint64_t count = 0;             ///< How many cells of the current layer use it.
  };

  std::size_t index_of(std::uint32_t gid);

  /// Calls visit(entry, x, y) for each nonempty cell.
  template <class Visit>
  void for_each_tile(const TiledLayer& layer, const Visit& visit);

  void count_omissions(const TiledPlace& place, std::vector<Omission>& omissions);

  const std::vector<TiledTilesetUse>& tilesets_;
  const TiledProjection& projection_;
  const std::unordered_set<std::string>& taken_;
  std::size_t room_;                                        ///< How many more objects may be added.
  std::vector<Entry> entries_;                              ///< In the order in which gids first appeared.
  std::unordered_map<std::uint32_t, std::size_t> indices_;  ///< By gid, with its flip bits.
};

}  // namespace graze::io
