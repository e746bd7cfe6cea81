// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/tiled/merged_cells.hpp>
#include <graze/io/tiled/tile_blocks.hpp>
#include <graze/io/tiled/tile_layer.hpp>
#include <graze/query/transformed.hpp>
#include <graze/scene/object.hpp>

namespace graze::io {
namespace {

using Point = Vec<2, double>;
using Shape = AnyShape<2, double>;

std::string numbers(std::int64_t begin, std::int64_t end) {
  return end - begin == 1 ? fmt::format("{}", begin) : fmt::format("{}..{}", begin, end - 1);
}

std::string name_of(const std::string& layer, const CellRectangle& cells) {
  return fmt::format("{}[{},{}]", layer, numbers(cells.begin, cells.end), numbers(cells.top, cells.bottom));
}

void extend_run(std::vector<CellRun>& runs, std::int64_t x, std::int64_t y) {
  if (!runs.empty() && runs.back().row == y && runs.back().end == x) {
    ++runs.back().end;
  } else {
    runs.push_back({y, x, x + 1});
  }
}

/// Collects the objects of one layer and adds them to the scene.
class LayerWriter {
 public:
  LayerWriter(Scene<2, double>& scene, const std::string& name, const std::unordered_set<std::string>& taken)
      : scene_(scene), name_(name), taken_(taken) {}

  /// From now on, small pieces are joined into one object for each block of cells, by `add_blocks`.
  void gather_blocks() { gathers_ = true; }

  /// The collision shapes of the tile in one cell, whose bottom left corner is `corner`.
  void add_cell(const TiledTileShapes& tile, std::int64_t x, std::int64_t y, const Point& corner) {
    for (std::size_t i = 0; i < tile.shapes.size(); ++i) {
      const std::string suffix = i == 0 ? "" : fmt::format("#{}", i + 1);
      add({x, x + 1, y, y + 1}, suffix, translated<2, double>(tile.shapes[i], corner));
    }
  }

  /// Completely covered cells. No later rectangle begins in a higher row, so the blocks there are complete.
  void add_rectangle(const CellRectangle& cells, const TiledProjection& projection, const Point& shift) {
    blocks_.drain_above(cells.top, [this](TileBlock block) { add_block(std::move(block)); });
    std::array<Point, 4> corners =
        tiled_corners_of_cells(projection, {cells.begin, cells.top}, {cells.end, cells.bottom});
    for (Point& corner : corners) corner += shift;
    if (corners[0].y == corners[1].y && corners[1].x == corners[2].x) {
      add(cells, "", Aabb<2, double>::from_corners(corners[0], corners[2]));
    } else {
      add(cells, "", convex_hull<2, double>(corners));
    }
  }

  void add_blocks() {
    blocks_.drain([this](TileBlock block) { add_block(std::move(block)); });
  }

 private:
  void add(const CellRectangle& cells, std::string_view suffix, Shape shape) {
    if (gathers_ && fits_tile_block(cells)) return blocks_.add(cells, std::move(shape));
    add_object(name_of(name_, cells).append(suffix), std::move(shape));
  }

  void add_block(TileBlock block) { add_object(name_of(name_, block.cells), std::move(block.shape)); }

  void add_object(std::string name, Shape shape) {
    if (!has_layer_) layer_ = scene_.layer(name_);
    has_layer_ = true;
    while (taken_.contains(name) || scene_.find(name)) name += '+';
    scene_.add(std::move(shape), {.name = std::move(name), .layer = layer_, .mobility = Mobility::fixed});
  }

  Scene<2, double>& scene_;
  const std::string& name_;
  const std::unordered_set<std::string>& taken_;
  Layer layer_ = 0;
  bool has_layer_ = false;
  bool gathers_ = false;
  TileBlocks blocks_;
};

}  // namespace

std::size_t TiledTileLayers::index_of(std::uint32_t gid) {
  const auto [place, is_new] = indices_.try_emplace(gid, entries_.size());
  if (!is_new) return place->second;
  Entry& entry = entries_.emplace_back();
  const TiledFoundTile found = find_tiled_tile(gid, tilesets_);
  if (found.use != nullptr && !found.use->fault.empty()) {
    entry.lack = &tiled_omission::lost_tile;
  } else if (!found.tile) {
    entry.lack = &tiled_omission::stray_tile;
  } else {
    entry.tile = tiled_tile_shapes(*found.tile, gid, projection_);
    if (entry.tile.shapes.empty() && entry.tile.omissions.empty()) entry.lack = &tiled_omission::plain_tile;
  }
  return place->second;
}

template <class Visit>
void TiledTileLayers::for_each_tile(const TiledLayer& layer, const Visit& visit) {
  for (const TiledCells& cells : layer.cells) {
    std::uint32_t last_gid = 0;  // no gid
    Entry* entry = nullptr;
    for (std::size_t i = 0; i < cells.gids.size(); ++i) {
      const std::uint32_t gid = cells.gids[i];
      if ((gid & tiled_gid_bits) == 0) continue;
      if (gid != last_gid) entry = &entries_[index_of(gid)];
      last_gid = gid;
      visit(*entry, cells.x + static_cast<std::int64_t>(i % cells.width),
            cells.y + static_cast<std::int64_t>(i / cells.width));
    }
  }
}

void TiledTileLayers::add(const TiledPlacedTiles& tiles, Scene<2, double>& scene, std::vector<Omission>& omissions) {
  std::vector<CellRun> runs;  // of covered cells
  std::size_t shapes = 0;     // of all others
  for_each_tile(tiles.layer, [&](Entry& entry, std::int64_t x, std::int64_t y) {
    ++entry.count;
    if (entry.tile.fills_cell) {
      extend_run(runs, x, y);
    } else {
      shapes += entry.tile.shapes.size();
    }
  });
  std::deque<CellRectangle> rectangles = merged_cells(std::move(runs));
  LayerWriter writer(scene, tiles.name, taken_);
  const std::size_t objects = shapes + rectangles.size();
  if (objects <= room_) {
    room_ -= objects;
  } else {
    writer.gather_blocks();
  }
  if (shapes > 0) {
    for_each_tile(tiles.layer, [&](const Entry& entry, std::int64_t x, std::int64_t y) {
      if (entry.tile.fills_cell) return;
      writer.add_cell(entry.tile, x, y, projection_.corner_of_cell(x, y) + tiles.shift);
    });
  }
  tiles.layer.cells = {};  // freed before many objects are added
  for (; !rectangles.empty(); rectangles.pop_front()) {
    writer.add_rectangle(rectangles.front(), projection_, tiles.shift);
  }
  writer.add_blocks();
  count_omissions(tiles.place, omissions);
}

void TiledTileLayers::count_omissions(const TiledPlace& place, std::vector<Omission>& omissions) {
  for (Entry& entry : entries_) {
    const std::uint64_t count = std::exchange(entry.count, 0);
    if (entry.lack != nullptr) count_omission(omissions, *entry.lack, place, count);
    for (const OmissionKind& kind : entry.tile.omissions) count_omission(omissions, kind, place, count);
  }
}

}  // namespace graze::io
