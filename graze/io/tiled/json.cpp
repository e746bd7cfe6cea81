// SPDX-License-Identifier: MIT
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/json/document.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/tiled/data.hpp>
#include <graze/io/tiled/fields.hpp>
#include <graze/io/tiled/json.hpp>
#include <graze/io/tiled/omissions.hpp>

namespace graze::io {
namespace {

/// A JSON value, and its file for error messages.
struct Value {
  const TiledText& file;
  JsonValue json;

  std::size_t offset() const { return json.offset(); }
  TiledPlace place() const { return {file, offset()}; }
};

/// A field of an object, which must be of some kind if it exists; `what` describes that kind in the message.
template <class Accept>
std::optional<Value> field_of(const Value& object, std::string_view name, std::string_view what, const Accept& accept) {
  const std::optional<JsonValue> field = object.json.find(name);
  if (!field) return std::nullopt;
  if (!accept(*field)) {
    fail_at(object.file, field->offset(),
            fmt::format("\"{}\" is {}; it must be {}", name, kind_name(field->kind()), what));
  }
  return Value{object.file, *field};
}

std::optional<Value> field_of(const Value& object, std::string_view name, JsonKind kind) {
  return field_of(object, name, kind_name(kind), [&](const JsonValue& value) { return value.kind() == kind; });
}

std::optional<std::string> text_of(const Value& object, std::string_view name) {
  const std::optional<Value> field = field_of(object, name, JsonKind::text);
  if (!field) return std::nullopt;
  return std::string(field->json.text());
}

std::optional<double> number_of(const Value& object, std::string_view name) {
  const std::optional<Value> field =
      field_of(object, name, "a number", [](const JsonValue& value) { return value.is_number(); });
  if (!field) return std::nullopt;
  return field->json.number();
}

std::optional<std::uint32_t> index_of(const Value& object, std::string_view name) {
  constexpr std::uint64_t largest = std::numeric_limits<std::uint32_t>::max();
  const std::optional<Value> field =
      field_of(object, name, "a number", [](const JsonValue& value) { return value.is_number(); });
  if (!field) return std::nullopt;
  if (field->json.kind() != JsonKind::whole || field->json.whole() > largest) {
    fail_at(object.file, field->offset(), fmt::format("\"{}\" must be a whole number from 0 to {}", name, largest));
  }
  return static_cast<std::uint32_t>(field->json.whole());
}

/// Calls `visit(element)` for each element of an array of objects, if the field exists.
template <class Visit>
void for_each_in(const Value& object, std::string_view name, const Visit& visit) {
  const std::optional<Value> array = field_of(object, name, JsonKind::array);
  if (!array) return;
  for (const JsonValue element : array->json.items()) {
    if (element.kind() != JsonKind::object) {
      fail_at(object.file, element.offset(),
              fmt::format("\"{}\" holds {} here; it must hold objects", name, kind_name(element.kind())));
    }
    visit(Value{object.file, element});
  }
}

/// The number of custom properties: an array, or an object before Tiled 1.2.
std::size_t count_properties(const Value& object) {
  const std::optional<Value> properties = field_of(object, "properties", "an array", [](const JsonValue& value) {
    return value.kind() == JsonKind::array || value.kind() == JsonKind::object;
  });
  return properties ? properties->json.size() : 0;
}

std::vector<Vec<2, double>> points_of(const Value& object, std::string_view name) {
  std::vector<Vec<2, double>> points;
  for_each_in(object, name, [&](const Value& point) {
    const std::optional<double> x = number_of(point, "x");
    const std::optional<double> y = number_of(point, "y");
    if (!x || !y)
      fail_at(point.file, point.offset(), fmt::format("this point of the {} needs both an x and a y", name));
    points.emplace_back(*x, *y);
  });
  return points;
}

bool flag_of(const Value& object, std::string_view name) {
  const std::optional<Value> flag = field_of(object, name, JsonKind::boolean);
  return flag && object.file.text[flag->offset()] == 't';
}

void read_outline(const Value& value, TiledObject& object) {
  if (flag_of(value, "ellipse")) object.outline = TiledOutline::ellipse;
  if (flag_of(value, "capsule")) object.outline = TiledOutline::capsule;
  if (flag_of(value, "point")) object.outline = TiledOutline::point;
  if (value.json.find("text")) object.outline = TiledOutline::text;
  for (const auto& [name, outline] :
       {std::pair("polygon", TiledOutline::polygon), {"polyline", TiledOutline::polyline}}) {
    if (!value.json.find(name)) continue;
    object.outline = outline;
    object.points = points_of(value, name);
  }
}

TiledObject object_of(const Value& value) {
  TiledObject object = tiled_object_of(value);
  object.properties = count_properties(value);
  read_outline(value, object);
  require_sound(object, value.file);
  return object;
}

/// The size of a tile (of the shown part of the image, otherwise of the whole image) and its collision shapes.
TiledTile tile_of(const Value& value) {
  TiledTile tile;
  tile.width = number_of(value, "width");
  tile.height = number_of(value, "height");
  if (!tile.width) tile.width = number_of(value, "imagewidth");
  if (!tile.height) tile.height = number_of(value, "imageheight");
  if (const auto shapes = field_of(value, "objectgroup", JsonKind::object)) {
    for_each_in(*shapes, "objects", [&](const Value& object) { tile.shapes.push_back(object_of(object)); });
  }
  return tile;
}

void add_tile(const Value& value, std::uint32_t id, TiledTileset& tileset) {
  if (value.json.find("image")) tileset.is_collection = true;
  tileset.tiles.insert_or_assign(id, tile_of(value));
}

/// Tiles keyed by their ids, as Tiled wrote them before version 1.2.
void read_keyed_tiles(const Value& tiles, TiledTileset& tileset) {
  for (const JsonField tile : tiles.json.fields()) {
    std::uint32_t id = 0;
    const char* last = tile.name.data() + tile.name.size();
    const auto [end, error] = std::from_chars(tile.name.data(), last, id);
    if (error != std::errc() || end != last || tile.value.kind() != JsonKind::object) {
      fail_at(tiles.file, tile.offset,
              fmt::format("{} is not a tile id, or its value is not an object", in_quotes(tile.name)));
    }
    add_tile({tiles.file, tile.value}, id, tileset);
  }
}

void read_tiles(const Value& value, TiledTileset& tileset) {
  const std::optional<Value> tiles = field_of(value, "tiles", "an array", [](const JsonValue& json) {
    return json.kind() == JsonKind::array || json.kind() == JsonKind::object;
  });
  if (tiles && tiles->json.kind() == JsonKind::object) {
    read_keyed_tiles(*tiles, tileset);
  } else {
    for_each_in(value, "tiles", [&](const Value& tile) {
      const std::optional<std::uint32_t> id = index_of(tile, "id");
      if (!id) fail_at(tile.file, tile.offset(), "this tile has no id");
      add_tile(tile, *id, tileset);
    });
  }
  if (value.json.find("image")) tileset.is_collection = false;
}

TiledTileset tileset_of(const Value& value) {
  TiledTileset tileset = tiled_tileset_of(value);
  if (const auto offset = field_of(value, "tileoffset", JsonKind::object)) {
    tileset.drawing_offset = tiled_vector_of(*offset, "x", "y");
  }
  if (const auto grid = field_of(value, "grid", JsonKind::object)) tileset.grid = tiled_drawing_grid_of(*grid);
  read_tiles(value, tileset);
  require_sound(tileset, value.file);
  return tileset;
}

/// The gids in an array of numbers.
std::vector<std::uint32_t> gids_of_array(const Value& array, std::uint64_t count, std::vector<Omission>& omissions) {
  std::vector<std::uint32_t> gids(array.json.packed().begin(), array.json.packed().end());
  if (gids.empty()) {
    for (const JsonValue element : array.json.items()) {
      if (element.kind() == JsonKind::whole && element.whole() <= std::numeric_limits<std::uint32_t>::max()) {
        gids.push_back(static_cast<std::uint32_t>(element.whole()));
        continue;
      }
      fail_at(array.file, element.offset(),
              "\"data\" holds something else here; it must hold whole numbers from 0 to "
              "4294967295");
    }
  }
  check_count(gids.size(), count, array.place(), omissions);
  return gids;
}

/// Reads the cells of the "data" of a layer or chunk.
void read_cells(const Value& value, const TiledDataFormat& format, TiledLayer& layer, TiledMap& map) {
  const std::optional<Value> data = field_of(value, "data", "an array or a string", [](const JsonValue& json) {
    return json.kind() == JsonKind::array || json.kind() == JsonKind::text;
  });
  if (!data) return;
  TiledCells cells = tiled_cells_of(value);
  const std::uint64_t height = index_of(value, "height").value_or(0);
  if (data->json.kind() == JsonKind::text) add_cells(map, cells.width, height, value.place());
  const std::uint64_t count = cells.width * height;
  if (data->json.kind() == JsonKind::array) {
    cells.gids = gids_of_array(*data, count, map.omissions);
  } else if (auto gids = tiled_gids(data->json.text(), format, count, data->place(), map.omissions)) {
    cells.gids = *std::move(gids);
  }
  if (!cells.gids.empty()) layer.cells.push_back(std::move(cells));
}

/// Reads the cells of a tile layer: one rectangle, or the chunks of an infinite map.
void read_tile_layer(const Value& value, TiledLayer& layer, TiledMap& map) {
  const TiledDataFormat format{text_of(value, "encoding").value_or("csv"), text_of(value, "compression").value_or("")};
  if (!value.json.find("chunks")) return read_cells(value, format, layer, map);
  for_each_in(value, "chunks", [&](const Value& chunk) { read_cells(chunk, format, layer, map); });
}

/// Reads the layers of a map or group; `depth` is the number of enclosing groups.
void read_layers(const Value& parent, std::size_t depth, std::vector<TiledLayer>& layers, TiledMap& map) {
  for_each_in(parent, "layers", [&](const Value& child) {
    const std::string kind = text_of(child, "type").value_or("");
    if (kind == "imagelayer") return count_omission(map.omissions, tiled_omission::image_layer, child.place());
    if (kind != "tilelayer" && kind != "objectgroup" && kind != "group") {
      return count_omission(map.omissions, tiled_omission::unknown_layer, child.place());
    }
    count_omission(map.omissions, tiled_omission::custom_property, child.place(), count_properties(child));
    TiledLayer layer = tiled_layer_of(child, map.omissions);
    if (kind == "tilelayer") {
      read_tile_layer(child, layer, map);
    } else if (kind == "objectgroup") {
      for_each_in(child, "objects", [&](const Value& object) { layer.objects.push_back(object_of(object)); });
    } else {
      require_group_depth(depth + 1, child.file, child.offset());
      read_layers(child, depth + 1, layer.layers, map);
    }
    layers.push_back(std::move(layer));
  });
}

/// The kind of a file: as stated, or in older files, which do not state it, deduced from the content.
std::string kind_of(const JsonValue& root) {
  if (const std::optional<JsonValue> type = root.find("type"); type && type->kind() == JsonKind::text) {
    return std::string(type->text());
  }
  if (root.find("layers")) return "map";
  if (root.find("object")) return "template";
  if (root.find("tilewidth")) return "tileset";
  return "";
}

Value root_of(const TiledText& file, std::string_view needed, const JsonDocument& document) {
  const JsonValue root = document.root();
  if (root.kind() != JsonKind::object) {
    fail_at(file, root.offset(),
            fmt::format("the file holds {}, but a Tiled {} is an object", kind_name(root.kind()), needed));
  }
  const std::string kind = kind_of(root);
  if (kind != needed) fail_for_kind(file, root.offset(), kind, needed);
  return {file, root};
}

}  // namespace

TiledMap read_tiled_json_map(const TiledText& file) {
  return read_tiled_json_map(file, JsonDocument(file.text, file.name, 1, "data"));
}

TiledMap read_tiled_json_map(const TiledText& file, const JsonDocument& document) {
  const Value root = root_of(file, "map", document);
  TiledMap map;
  map.grid = tiled_grid_of(root);
  for_each_in(root, "tilesets", [&](const Value& tileset) { map.tilesets.push_back(tileset_of(tileset)); });
  count_omission(map.omissions, tiled_omission::custom_property, root.place(), count_properties(root));
  read_layers(root, 0, map.layers, map);
  return map;
}

TiledTileset read_tiled_json_tileset(const TiledText& file) {
  const JsonDocument document(file.text, file.name);
  return tileset_of(root_of(file, "tileset", document));
}

TiledTemplate read_tiled_json_template(const TiledText& file) {
  const JsonDocument document(file.text, file.name);
  const Value root = root_of(file, "template", document);
  TiledTemplate result;
  if (const auto tileset = field_of(root, "tileset", JsonKind::object)) result.tileset = tileset_of(*tileset);
  const std::optional<Value> object = field_of(root, "object", JsonKind::object);
  if (!object) fail_at(file, root.offset(), "this template holds no \"object\"");
  result.object = object_of(*object);
  return result;
}

}  // namespace graze::io
