// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fast_float/fast_float.h>
#include <fmt/format.h>
#include <pugixml.hpp>

#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/utf8.hpp>
#include <graze/io/tiled/data.hpp>
#include <graze/io/tiled/omissions.hpp>
#include <graze/io/tiled/tile_elements.hpp>
#include <graze/io/tiled/xml.hpp>
#include <graze/io/tiled/xml_check.hpp>

namespace graze::io {
namespace {

/// An element, with the file to name when it is wrong.
struct Element {
  const TiledText& file;
  pugi::xml_node node;

  std::string_view kind() const { return node.name(); }

  /// pugixml knows where the name begins; the element begins one before.
  std::size_t offset() const {
    const std::ptrdiff_t name = node.offset_debug();
    return name > 0 ? static_cast<std::size_t>(name) - 1 : 0;
  }

  TiledPlace place() const { return {file, offset()}; }

  Element child(const char* name) const { return {file, node.child(name)}; }

  explicit operator bool() const { return static_cast<bool>(node); }
};

/// Calls `visit(element)` for each element inside another, text and comments left out.
template <class Visit>
void for_each_child(const Element& parent, const Visit& visit) {
  for (const pugi::xml_node node : parent.node.children()) {
    if (node.type() == pugi::node_element) visit(Element{parent.file, node});
  }
}

std::size_t count_children(const Element& parent, const char* name) {
  std::size_t count = 0;
  for_each_child(parent, [&](const Element& child) { count += child.kind() == name ? 1 : 0; });
  return count;
}

std::optional<std::string> text_of(const Element& element, const char* name) {
  const pugi::xml_attribute attribute = element.node.attribute(name);
  if (!attribute) return std::nullopt;
  return std::string(attribute.value());
}

/// A decimal number that takes all of the text and is finite.
std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const fast_float::from_chars_result result = fast_float::from_chars(text.data(), end, value);
  if (result.ec == std::errc::invalid_argument || result.ptr != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<double> number_of(const Element& element, const char* name) {
  const pugi::xml_attribute attribute = element.node.attribute(name);
  if (!attribute) return std::nullopt;
  const std::optional<double> value = parse_number(attribute.value());
  if (!value) {
    fail_at(element.file, element.offset(),
            fmt::format("<{}> has {}={}, which is not a finite number", element.kind(), name,
                        in_quotes(attribute.value())));
  }
  return value;
}

std::optional<std::uint32_t> index_of(const Element& element, const char* name) {
  const pugi::xml_attribute attribute = element.node.attribute(name);
  if (!attribute) return std::nullopt;
  const std::string_view text = attribute.value();
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    fail_at(element.file, element.offset(),
            fmt::format("<{}> has {}={}, which is not a whole number from 0 to 4294967295", element.kind(), name,
                        in_quotes(text)));
  }
  return value;
}

/// A whole number that may be negative.
std::optional<std::int32_t> whole_of(const Element& element, const char* name) {
  const std::optional<double> value = number_of(element, name);
  if (!value) return std::nullopt;
  require_whole(*value, name, element.place());
  return static_cast<std::int32_t>(*value);
}

Vec<2, double> shift_of(const Element& layer) {
  return {number_of(layer, "offsetx").value_or(0), number_of(layer, "offsety").value_or(0)};
}

/// The points of "0,0 16,8 -3.5,2".
std::vector<Vec<2, double>> points_of(const Element& outline) {
  std::vector<Vec<2, double>> points;
  std::string_view rest = outline.node.attribute("points").value();
  constexpr std::string_view space = " \t\r\n";
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(space), rest.size()));
    if (rest.empty()) return points;
    const std::string_view point = rest.substr(0, rest.find_first_of(space));
    const std::size_t comma = std::min(point.find(','), point.size());
    const std::optional<double> x = parse_number(point.substr(0, comma));
    const std::optional<double> y = parse_number(point.substr(std::min(comma + 1, point.size())));
    if (!x || !y) {
      fail_at(outline.file, outline.offset(),
              fmt::format(
                  "point {} of the <{}> is {}; a point is two finite numbers with a comma between, as in \"8,-2.5\"",
                  points.size() + 1, outline.kind(), in_quotes(point)));
    }
    points.emplace_back(*x, *y);
    rest.remove_prefix(point.size());
  }
}

std::optional<TiledOutline> outline_named(std::string_view name) {
  if (name == "ellipse") return TiledOutline::ellipse;
  if (name == "capsule") return TiledOutline::capsule;
  if (name == "point") return TiledOutline::point;
  if (name == "polygon") return TiledOutline::polygon;
  if (name == "polyline") return TiledOutline::polyline;
  if (name == "text") return TiledOutline::text;
  return std::nullopt;
}

TiledObject object_of(const Element& element, std::vector<Omission>& omissions) {
  TiledObject object;
  object.offset = element.offset();
  object.name = text_of(element, "name");
  object.id = index_of(element, "id");
  object.x = number_of(element, "x");
  object.y = number_of(element, "y");
  object.width = number_of(element, "width");
  object.height = number_of(element, "height");
  object.rotation = number_of(element, "rotation");
  object.gid = index_of(element, "gid");
  object.template_source = text_of(element, "template").value_or("");
  object.has_class = !text_of(element, "type").value_or("").empty() || !text_of(element, "class").value_or("").empty();
  object.properties = count_children(element.child("properties"), "property");
  for_each_child(element, [&](const Element& child) {
    if (const std::optional<TiledOutline> outline = outline_named(child.kind())) {
      object.outline = outline;
      object.points = points_of(child);
    } else if (child.kind() != "properties") {
      count_omission(omissions, tiled_omission::unknown_element, child.place());
    }
  });
  require_sound(object, element.file);
  return object;
}

/// The size of a tile, of the part of the image that it shows, else of the whole image; and its collision shapes.
TiledTile tile_of(const Element& element) {
  TiledTile tile;
  const Element image = element.child("image");
  tile.width = number_of(element, "width");
  tile.height = number_of(element, "height");
  if (!tile.width) tile.width = number_of(image, "width");
  if (!tile.height) tile.height = number_of(image, "height");
  std::vector<Omission> unknown;  // of the tileset's file, not of the map
  for_each_child(element.child("objectgroup"), [&](const Element& child) {
    if (child.kind() == "object") tile.shapes.push_back(object_of(child, unknown));
  });
  return tile;
}

TiledTileset tileset_of(const Element& element) {
  TiledTileset tileset;
  tileset.offset = element.offset();
  tileset.first_gid = index_of(element, "firstgid").value_or(1);
  tileset.source = text_of(element, "source").value_or("");
  tileset.tile_width = number_of(element, "tilewidth");
  tileset.tile_height = number_of(element, "tileheight");
  tileset.tile_count = index_of(element, "tilecount");
  tileset.alignment = tiled_alignment(text_of(element, "objectalignment").value_or(""));
  const Element offset = element.child("tileoffset");
  tileset.drawing_offset = {number_of(offset, "x").value_or(0), number_of(offset, "y").value_or(0)};
  tileset.fills_grid = text_of(element, "tilerendersize") == "grid";
  tileset.keeps_aspect = text_of(element, "fillmode") == "preserve-aspect-fit";
  if (const Element grid = element.child("grid")) {
    tileset.grid = tiled_drawing_grid(text_of(grid, "orientation").value_or(""), number_of(grid, "width").value_or(0),
                                      number_of(grid, "height").value_or(0));
  }
  const bool one_image = static_cast<bool>(element.child("image"));
  for_each_child(element, [&](const Element& child) {
    if (child.kind() != "tile") return;
    const std::optional<std::uint32_t> id = index_of(child, "id");
    if (!id) fail_at(child.file, child.offset(), "this <tile> has no id");
    if (child.child("image") && !one_image) tileset.is_collection = true;
    tileset.tiles.insert_or_assign(*id, tile_of(child));
  });
  require_sound(tileset, element.file);
  return tileset;
}

/// What a layer of any kind says that graze does not read.
void count_layer_omissions(const Element& layer, std::vector<Omission>& omissions) {
  count_omission(omissions, tiled_omission::custom_property, layer.place(),
                 count_children(layer.child("properties"), "property"));
  if (number_of(layer, "parallaxx").value_or(1) != 1 || number_of(layer, "parallaxy").value_or(1) != 1) {
    count_omission(omissions, tiled_omission::layer_parallax, layer.place());
  }
}

/// The gids of <tile> elements, or of the numbers that stand for them since shorten_tile_elements; there may be fewer
/// of them than cells.
std::vector<std::uint32_t> gids_of_elements(const Element& parent, std::uint64_t count) {
  std::vector<std::uint32_t> gids = tiled_gids_of_csv(parent.node.text().get(), parent.place());
  for_each_child(parent, [&](const Element& child) {
    if (child.kind() == "tile") gids.push_back(index_of(child, "gid").value_or(0));
  });
  std::vector<Omission> fewer_are_allowed;
  check_count(gids.size(), count, parent.place(), fewer_are_allowed);
  return gids;
}

/// Reads the cells that <data> or <chunk> holds, which begin at (x, y) and are as many as `sized` says.
void read_cells(const Element& data, const Element& sized, const TiledDataFormat& format, TiledLayer& layer,
                TiledMap& map) {
  TiledCells cells;
  cells.x = whole_of(sized, "x").value_or(0);
  cells.y = whole_of(sized, "y").value_or(0);
  cells.width = index_of(sized, "width").value_or(0);
  const std::uint64_t height = index_of(sized, "height").value_or(0);
  if (format.encoding == "base64") add_cells(map, cells.width, height, sized.place());
  const std::uint64_t count = cells.width * height;
  if (format.encoding.empty() && format.compression.empty()) {
    cells.gids = gids_of_elements(data, count);
  } else if (auto gids = tiled_gids(data.node.text().get(), format, count, data.place(), map.omissions)) {
    cells.gids = *std::move(gids);
  }
  if (!cells.gids.empty()) layer.cells.push_back(std::move(cells));
}

/// Reads the cells of a tile layer: one rectangle, or the chunks of an infinite map.
void read_tile_layer(const Element& element, TiledLayer& layer, TiledMap& map) {
  const Element data = element.child("data");
  if (!data) return;
  const TiledDataFormat format{text_of(data, "encoding").value_or(""), text_of(data, "compression").value_or("")};
  if (!data.child("chunk")) return read_cells(data, element, format, layer, map);
  for_each_child(data, [&](const Element& chunk) {
    if (chunk.kind() == "chunk") read_cells(chunk, chunk, format, layer, map);
  });
}

void read_objects(const Element& element, TiledLayer& layer, TiledMap& map) {
  for_each_child(element, [&](const Element& child) {
    if (child.kind() == "object") {
      layer.objects.push_back(object_of(child, map.omissions));
    } else if (child.kind() != "properties") {
      count_omission(map.omissions, tiled_omission::unknown_element, child.place());
    }
  });
}

/// Reads the layers of a map or group; `depth` counts the groups around them.
void read_layers(const Element& parent, std::size_t depth, std::vector<TiledLayer>& layers, TiledMap& map) {
  for_each_child(parent, [&](const Element& child) {
    const std::string_view kind = child.kind();
    if (kind == "imagelayer") return count_omission(map.omissions, tiled_omission::image_layer, child.place());
    if (kind == "tileset" || kind == "properties" || kind == "editorsettings") return;
    if (kind != "layer" && kind != "objectgroup" && kind != "group") {
      return count_omission(map.omissions, tiled_omission::unknown_element, child.place());
    }
    TiledLayer layer;
    layer.offset = child.offset();
    layer.name = text_of(child, "name").value_or("");
    layer.shift = shift_of(child);
    count_layer_omissions(child, map.omissions);
    if (kind == "layer") {
      read_tile_layer(child, layer, map);
    } else if (kind == "objectgroup") {
      read_objects(child, layer, map);
    } else {
      require_group_depth(depth + 1, child.file, child.offset());
      read_layers(child, depth + 1, layer.layers, map);
    }
    layers.push_back(std::move(layer));
  });
}

TiledGrid grid_of(const Element& map) {
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

/// A file's elements, and the text that they lie in.
struct ParsedXml {
  std::string buffer;
  pugi::xml_document document;
};

/// The outermost element of a file, which must be of the kind needed. `parsed` holds it.
Element root_of(const TiledText& file, std::string_view needed, ParsedXml& parsed) {
  require_utf8(file.text, file.name);
  parsed.buffer = file.text;
  shorten_tile_elements(parsed.buffer);
  const pugi::xml_parse_result result = parsed.document.load_buffer_inplace(parsed.buffer.data(), parsed.buffer.size(),
                                                                            pugi::parse_default, pugi::encoding_utf8);
  if (!result) {
    const auto offset = static_cast<std::size_t>(result.offset > 0 ? result.offset : 0);
    fail_at(file, offset, fmt::format("the XML is broken or cut off: {}", result.description()));
  }
  require_well_formed_xml(file.text, file.name);
  const Element root{file, parsed.document.document_element()};
  if (root.kind() != needed) fail_for_kind(file, root.offset(), root.kind(), needed);
  return root;
}

}  // namespace

TiledMap read_tiled_xml_map(const TiledText& file) {
  ParsedXml parsed;
  const Element root = root_of(file, "map", parsed);
  TiledMap map;
  map.grid = grid_of(root);
  for_each_child(root, [&](const Element& child) {
    if (child.kind() == "tileset") map.tilesets.push_back(tileset_of(child));
  });
  count_omission(map.omissions, tiled_omission::custom_property, root.place(),
                 count_children(root.child("properties"), "property"));
  read_layers(root, 0, map.layers, map);
  return map;
}

TiledTileset read_tiled_xml_tileset(const TiledText& file) {
  ParsedXml parsed;
  return tileset_of(root_of(file, "tileset", parsed));
}

TiledTemplate read_tiled_xml_template(const TiledText& file) {
  ParsedXml parsed;
  const Element root = root_of(file, "template", parsed);
  TiledTemplate result;
  if (const Element tileset = root.child("tileset")) result.tileset = tileset_of(tileset);
  const Element object = root.child("object");
  if (!object) fail_at(file, root.offset(), "this template holds no <object>");
  std::vector<Omission> unknown;  // of the template's file, not of the map
  result.object = object_of(object, unknown);
  return result;
}

}  // namespace graze::io
