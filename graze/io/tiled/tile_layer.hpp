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
  const TiledLayer& layer;
  const std::string& name;
  Vec<2, double> shift;
  TiledPlace place;
};

/// Makes objects of tile layers. Whatever it is given outlives it.
class TiledTileLayers {
 public:
  /// `taken` are the names that objects of the map have or will have.
  TiledTileLayers(const std::vector<TiledTilesetUse>& tilesets, const TiledProjection& projection,
                  const std::unordered_set<std::string>& taken)
      : tilesets_(tilesets), projection_(projection), taken_(taken) {}

  /// Adds an object for each collision shape of the layer's tiles, fixed, so that they are no pairs among themselves.
  /// Neighbours whose cells are filled become rectangles of cells. An object is called by the layer and its cells:
  /// "walls[3,0]", "walls[0..31,7..9]", of several in one cell the second "walls[3,0]#2". What is not read is counted.
  /// Throws std::invalid_argument when a coordinate overflows, and what `Scene::layer` does.
  void add(const TiledPlacedTiles& tiles, Scene<2, double>& scene, std::vector<Omission>& omissions);

 private:
  /// What a gid stands for.
  struct Entry {
    TiledTileShapes tile;
    const OmissionKind* lack = nullptr;  ///< Why it has no shape.
    std::uint64_t count = 0;             ///< How many cells of the layer at hand show it.
  };

  std::size_t index_of(std::uint32_t gid);
  void count_omissions(const TiledPlace& place, std::vector<Omission>& omissions);

  const std::vector<TiledTilesetUse>& tilesets_;
  const TiledProjection& projection_;
  const std::unordered_set<std::string>& taken_;
  std::vector<Entry> entries_;                              ///< In the order in which gids have appeared.
  std::unordered_map<std::uint32_t, std::size_t> indices_;  ///< By gid, with its flip bits.
};

}  // namespace graze::io
