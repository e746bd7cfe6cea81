// SPDX-License-Identifier: MIT
// The fields that have the same names in Tiled's XML and JSON. A `Node` has `file`, `offset()` and `place()`. The
// functions text_of(node, name), number_of(node, name) and index_of(node, name), declared beside its type, return a
// field if it exists and refuse values of the wrong kind.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <graze/io/tiled/data.hpp>
#include <graze/io/tiled/model.hpp>
#include <graze/io/tiled/omissions.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

/// An integer, or 0 if there is none.
template <class Node>
std::int32_t tiled_whole_of(const Node& node, const char* name) {
  const double number = number_of(node, name).value_or(0);
  require_whole(number, name, node.place());
  return static_cast<std::int32_t>(number);
}

/// Reads an object without its outline and its number of properties.
template <class Node>
TiledObject tiled_object_of(const Node& node) {
  TiledObject object;
  object.offset = node.offset();
  object.name = text_of(node, "name");
  object.id = index_of(node, "id");
  object.x = number_of(node, "x");
  object.y = number_of(node, "y");
  object.width = number_of(node, "width");
  object.height = number_of(node, "height");
  object.rotation = number_of(node, "rotation");
  object.gid = index_of(node, "gid");
  object.template_source = text_of(node, "template").value_or("");
  object.has_class = !text_of(node, "type").value_or("").empty() || !text_of(node, "class").value_or("").empty();
  return object;
}

/// Reads a tileset without its tiles, drawing offset and grid.
template <class Node>
TiledTileset tiled_tileset_of(const Node& node) {
  TiledTileset tileset;
  tileset.offset = node.offset();
  tileset.first_gid = index_of(node, "firstgid").value_or(1);
  tileset.source = text_of(node, "source").value_or("");
  tileset.tile_width = number_of(node, "tilewidth");
  tileset.tile_height = number_of(node, "tileheight");
  tileset.tile_count = index_of(node, "tilecount");
  tileset.alignment = tiled_alignment(text_of(node, "objectalignment").value_or(""));
  tileset.fills_grid = text_of(node, "tilerendersize") == "grid";
  tileset.keeps_aspect = text_of(node, "fillmode") == "preserve-aspect-fit";
  return tileset;
}

template <class Node>
Vec<2, double> tiled_vector_of(const Node& node, const char* x, const char* y) {
  return {number_of(node, x).value_or(0), number_of(node, y).value_or(0)};
}

/// The grid of a tileset's collision shapes.
template <class Node>
TiledGrid tiled_drawing_grid_of(const Node& node) {
  const Vec<2, double> size = tiled_vector_of(node, "width", "height");
  return tiled_drawing_grid(text_of(node, "orientation").value_or(""), size.x, size.y);
}

/// Reads a layer without its content. What is not read is counted, except for its properties.
template <class Node>
TiledLayer tiled_layer_of(const Node& node, std::vector<Omission>& omissions) {
  TiledLayer layer;
  layer.offset = node.offset();
  layer.name = text_of(node, "name").value_or("");
  layer.shift = tiled_vector_of(node, "offsetx", "offsety");
  if (number_of(node, "parallaxx").value_or(1) != 1 || number_of(node, "parallaxy").value_or(1) != 1) {
    count_omission(omissions, tiled_omission::layer_parallax, node.place());
  }
  return layer;
}

/// The grid of a map; refused if nothing can be placed on it.
template <class Node>
TiledGrid tiled_grid_of(const Node& map) {
  TiledGrid grid;
  grid.orientation = text_of(map, "orientation").value_or(grid.orientation);
  grid.height = number_of(map, "height").value_or(0);
  grid.tile_width = number_of(map, "tilewidth").value_or(0);
  grid.tile_height = number_of(map, "tileheight").value_or(0);
  grid.hex_side = number_of(map, "hexsidelength").value_or(0);
  grid.skew_x = number_of(map, "skewx").value_or(0);
  grid.skew_y = number_of(map, "skewy").value_or(0);
  grid.staggers_x = text_of(map, "staggeraxis") == "x";
  grid.shifts_even = text_of(map, "staggerindex") == "even";
  require_sound(grid, map.place());
  return grid;
}

/// A rectangle of cells without its tiles: `sized` is the layer or chunk.
template <class Node>
TiledCells tiled_cells_of(const Node& sized) {
  TiledCells cells;
  cells.x = tiled_whole_of(sized, "x");
  cells.y = tiled_whole_of(sized, "y");
  cells.width = index_of(sized, "width").value_or(0);
  return cells;
}

}  // namespace graze::io
