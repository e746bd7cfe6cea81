// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/text/in_quotes.hpp>
#include <graze/io/tiled/model.hpp>

namespace graze::io {
namespace {

void require_not_negative(std::optional<double> size, std::string_view field, const TiledObject& object,
                          const TiledText& file) {
  if (!size || *size >= 0) return;
  fail_at(file, object.offset, fmt::format("{} has the {} {}; it must be 0 or more", described(object), field, *size));
}

}  // namespace

void require_group_depth(std::size_t depth, const TiledText& file, std::size_t offset) {
  if (depth <= max_tiled_group_depth) return;
  fail_at(file, offset, fmt::format("this group is nested deeper than {} groups; flatten them", max_tiled_group_depth));
}

std::optional<TiledAlignment> tiled_alignment(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, std::array<double, 2>>, 9> names{{
      {"topleft", {0, 0}},
      {"top", {0.5, 0}},
      {"topright", {1, 0}},
      {"left", {0, 0.5}},
      {"center", {0.5, 0.5}},
      {"right", {1, 0.5}},
      {"bottomleft", {0, 1}},
      {"bottom", {0.5, 1}},
      {"bottomright", {1, 1}},
  }};
  const auto* const found =
      std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == name; });
  if (found == names.end()) return std::nullopt;
  return TiledAlignment{{found->second[0], found->second[1]}};
}

void add_cells(TiledMap& map, std::uint64_t width, std::uint64_t height, const TiledPlace& place) {
  // No overflow: both factors are below 2^32, and so is the count.
  map.cell_count += width * height;
  if (map.cell_count <= max_tiled_cells) return;
  fail_at(place,
          fmt::format("with this one of {} x {} the compressed tile layers of the map have {} cells; the most is {}",
                      width, height, map.cell_count, max_tiled_cells));
}

void require_sound(const TiledObject& object, const TiledText& file) {
  require_not_negative(object.width, "width", object, file);
  require_not_negative(object.height, "height", object, file);
  const bool polygon = object.outline == TiledOutline::polygon;
  if ((polygon || object.outline == TiledOutline::polyline) && object.points.size() < 2) {
    fail_at(file, object.offset,
            fmt::format("the {} of {} has {} point{}; it needs at least 2", polygon ? "polygon" : "polyline",
                        described(object), object.points.size(), object.points.size() == 1 ? "" : "s"));
  }
}

TiledGrid tiled_drawing_grid(std::string_view orientation, double width, double height) {
  TiledGrid grid;
  if (orientation != "isometric" || !(width > 0 && height > 0)) return grid;
  grid.orientation = orientation;
  grid.height = 1;
  grid.tile_width = width;
  grid.tile_height = height;
  return grid;
}

void require_whole(double value, std::string_view field, const TiledPlace& place) {
  constexpr double largest = std::numeric_limits<std::int32_t>::max();
  if (std::fabs(value) <= largest && value == std::floor(value)) return;
  fail_at(place,
          fmt::format("the {} here is {}; it must be a whole number from -{} to {}", field, value, largest, largest));
}

void require_sound(const TiledGrid& grid, const TiledPlace& place) {
  const bool divides = grid.orientation == "isometric";
  const auto require_size = [&](double size, std::string_view field) {
    if (size > 0 || (size == 0 && !divides)) return;
    fail_at(place, fmt::format("the map is {} and has the {} {}; it must be {}", grid.orientation, field, size,
                               divides ? "above 0" : "0 or more"));
  };
  require_size(grid.tile_width, "tilewidth");
  require_size(grid.tile_height, "tileheight");
}

void require_sound(const TiledTileset& tileset, const TiledText& file) {
  const auto require_size = [&](std::optional<double> size, const std::string& what) {
    if (!size || *size >= 0) return;
    fail_at(file, tileset.offset, fmt::format("the {} is {}; it must be 0 or more", what, *size));
  };
  require_size(tileset.tile_width, "tilewidth of the tileset");
  require_size(tileset.tile_height, "tileheight of the tileset");
  for (const auto& [id, tile] : tileset.tiles) {
    const double width = tile.width.value_or(0);
    const double height = tile.height.value_or(0);
    if (width >= 0 && height >= 0) continue;
    fail_at(file, tileset.offset, fmt::format("tile {} is {} x {}; both sizes must be 0 or more", id, width, height));
  }
  if (tileset.first_gid == 0)
    fail_at(file, tileset.offset, "the tileset has the firstgid 0; tiles are numbered from 1");
}

void fail_for_kind(const TiledText& file, std::size_t offset, std::string_view found, std::string_view needed) {
  const bool other_kind = found == "map" || found == "tileset" || found == "template";
  const std::string what =
      other_kind ? fmt::format("a Tiled {}", found) : fmt::format("of the kind {}", in_quotes(found));
  const std::string_view remedy = needed != "map" ? "check the reference to it"
                                  : other_kind    ? "give the map (.tmx or .tmj) that uses it"
                                                  : "give a .tmx or .tmj file";
  fail_at(file, offset, fmt::format("the file is {}, but a Tiled {} is needed; {}", what, needed, remedy));
}

std::string described(const TiledObject& object) {
  std::string text = "the object";
  if (object.name && !object.name->empty()) text = "object " + in_quotes(*object.name);
  if (object.id) text += fmt::format(" (id {})", *object.id);
  return text;
}

}  // namespace graze::io
