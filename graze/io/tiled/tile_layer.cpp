// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/tiled/merged_cells.hpp>
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

/// The objects of one layer on their way into the scene.
class LayerWriter {
 public:
  LayerWriter(Scene<2, double>& scene, const std::string& name, const std::unordered_set<std::string>& taken)
      : scene_(scene), name_(name), taken_(taken) {}

  void add(Shape shape, std::string name) {
    if (!has_layer_) layer_ = scene_.layer(name_);
    has_layer_ = true;
    while (taken_.contains(name) || scene_.find(name)) name += '+';
    scene_.add(std::move(shape), {.name = std::move(name), .layer = layer_, .mobility = Mobility::fixed});
  }

  /// The shapes of the tile in one cell, whose bottom left corner is `corner`; one that fills it waits for its
  /// neighbours.
  void add_cell(const TiledTileShapes& tile, std::int64_t x, std::int64_t y, const Point& corner) {
    if (tile.fills_cell) return extend_run(x, y);
    for (std::size_t i = 0; i < tile.shapes.size(); ++i) {
      std::string name = fmt::format("{}[{},{}]", name_, x, y);
      if (i > 0) name += fmt::format("#{}", i + 1);
      add(translated<2, double>(tile.shapes[i], corner), std::move(name));
    }
  }

  /// The cells that were filled, as rectangles.
  void add_rectangles(const TiledProjection& projection, const Point& shift) {
    for (const CellRectangle& cells : merged_cells(std::move(runs_))) {
      std::array<Point, 4> corners =
          tiled_corners_of_cells(projection, {cells.begin, cells.top}, {cells.end, cells.bottom});
      for (Point& corner : corners) corner += shift;
      std::string name =
          fmt::format("{}[{},{}]", name_, numbers(cells.begin, cells.end), numbers(cells.top, cells.bottom));
      if (corners[0].y == corners[1].y && corners[1].x == corners[2].x) {
        add(Aabb<2, double>::from_corners(corners[0], corners[2]), std::move(name));
      } else {
        add(convex_hull<2, double>(corners), std::move(name));
      }
    }
  }

 private:
  void extend_run(std::int64_t x, std::int64_t y) {
    if (!runs_.empty() && runs_.back().row == y && runs_.back().end == x) {
      ++runs_.back().end;
    } else {
      runs_.push_back({y, x, x + 1});
    }
  }

  Scene<2, double>& scene_;
  const std::string& name_;
  const std::unordered_set<std::string>& taken_;
  Layer layer_ = 0;
  bool has_layer_ = false;
  std::vector<CellRun> runs_;  ///< Of cells that were filled.
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

void TiledTileLayers::add(const TiledPlacedTiles& tiles, Scene<2, double>& scene, std::vector<Omission>& omissions) {
  LayerWriter writer(scene, tiles.name, taken_);
  for (const TiledCells& cells : tiles.layer.cells) {
    std::uint32_t last_gid = 0;  // which is none
    Entry* entry = nullptr;
    for (std::size_t i = 0; i < cells.gids.size(); ++i) {
      const std::uint32_t gid = cells.gids[i];
      if ((gid & tiled_gid_bits) == 0) continue;
      if (gid != last_gid) entry = &entries_[index_of(gid)];
      last_gid = gid;
      ++entry->count;
      if (entry->tile.shapes.empty()) continue;
      const std::int64_t x = cells.x + static_cast<std::int64_t>(i % cells.width);
      const std::int64_t y = cells.y + static_cast<std::int64_t>(i / cells.width);
      writer.add_cell(entry->tile, x, y, projection_.corner_of_cell(x, y) + tiles.shift);
    }
  }
  writer.add_rectangles(projection_, tiles.shift);
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
