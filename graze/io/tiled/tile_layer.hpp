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

/// A tile layer, the name and the shift on the screen that it has with the groups around it, and where it stands.
struct TiledPlacedTiles {
  TiledLayer& layer;  ///< Its cells are given up when they are objects.
  const std::string& name;
  Vec<2, double> shift;
  TiledPlace place;
};

/// As many objects the tile layers of a map become before small ones are joined.
inline constexpr std::size_t most_tile_objects = std::size_t{1} << 18U;

/// Makes objects of tile layers. Whatever it is given outlives it.
class TiledTileLayers {
 public:
  /// `taken` are the names that objects of the map have or will have.
  TiledTileLayers(const std::vector<TiledTilesetUse>& tilesets, const TiledProjection& projection,
                  const std::unordered_set<std::string>& taken, std::size_t most_objects = most_tile_objects)
      : tilesets_(tilesets), projection_(projection), taken_(taken), room_(most_objects) {}

  /// Adds an object for each collision shape of the layer's tiles, fixed, so that they are no pairs among themselves.
  /// Neighbours whose cells are filled become rectangles of cells. An object is called by the layer and its cells:
  /// "walls[3,0]", "walls[0..31,7..9]", of several in one cell the second "walls[3,0]#2". Where these
  /// and those of earlier layers are more than `most_objects`, those that fit into a block of cells (see TileBlocks)
  /// become one compound for each block, called by all its cells, so that memory grows by parts and not by objects.
  /// What is not read is counted. Throws
  /// std::invalid_argument when a coordinate overflows, and what `Scene::layer` does.
  void add(const TiledPlacedTiles& tiles, Scene<2, double>& scene, std::vector<Omission>& omissions);

 private:
  /// What a gid stands for.
  struct Entry {
    TiledTileShapes tile;
    const OmissionKind* lack = nullptr;  ///< Why it has no shape.
    std::uint64_t count = 0;             ///< How many cells of the layer at hand show it.
  };

  std::size_t index_of(std::uint32_t gid);

  /// Calls visit(entry, x, y) for each cell that holds a tile.
  template <class Visit>
  void for_each_tile(const TiledLayer& layer, const Visit& visit);

  void count_omissions(const TiledPlace& place, std::vector<Omission>& omissions);

  const std::vector<TiledTilesetUse>& tilesets_;
  const TiledProjection& projection_;
  const std::unordered_set<std::string>& taken_;
  std::size_t room_;                                        ///< For so many more objects.
  std::vector<Entry> entries_;                              ///< In the order in which gids have appeared.
  std::unordered_map<std::uint32_t, std::size_t> indices_;  ///< By gid, with its flip bits.
};

}  // namespace graze::io
