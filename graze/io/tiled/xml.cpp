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
#include <graze/io/tiled/fields.hpp>
#include <graze/io/tiled/omissions.hpp>
#include <graze/io/tiled/tile_elements.hpp>
#include <graze/io/tiled/xml.hpp>
#include <graze/io/tiled/xml_check.hpp>

namespace graze::io {
namespace {

/// An element, and its file for error messages.
struct Element {
  const TiledText& file;
  pugi::xml_node node;

  std::string_view kind() const { return node.name(); }

  /// pugixml gives the position of the name; the element begins one byte before.
  std::size_t offset() const {
    const std::ptrdiff_t name = node.offset_debug();
    return name > 0 ? static_cast<std::size_t>(name) - 1 : 0;
  }

  TiledPlace place() const { return {file, offset()}; }

  Element child(const char* name) const { return {file, node.child(name)}; }

  explicit operator bool() const { return static_cast<bool>(node); }
};

/// Calls `visit(element)` for each child element, skipping text and comments.
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

/// A finite decimal number that spans the whole text.
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
  TiledObject object = tiled_object_of(element);
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

/// The size of a tile (of the shown part of the image, otherwise of the whole image) and its collision shapes.
TiledTile tile_of(const Element& element) {
  TiledTile tile;
  const Element image = element.child("image");
  tile.width = number_of(element, "width");
  tile.height = number_of(element, "height");
  if (!tile.width) tile.width = number_of(image, "width");
  if (!tile.height) tile.height = number_of(image, "height");
  std::vector<Omission> unknown;  // belongs to the tileset's file, not to the map
  for_each_child(element.child("objectgroup"), [&](const Element& child) {
    if (child.kind() == "object") tile.shapes.push_back(object_of(child, unknown));
  });
  return tile;
}

TiledTileset tileset_of(const Element& element) {
  TiledTileset tileset = tiled_tileset_of(element);
  tileset.drawing_offset = tiled_vector_of(element.child("tileoffset"), "x", "y");
  if (const Element grid = element.child("grid")) tileset.grid = tiled_drawing_grid_of(grid);
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

/// The gids of <tile> elements, or of the numbers that shorten_tile_elements puts in their place; there may be fewer of
/// them than cells.
std::vector<std::uint32_t> gids_of_elements(const Element& parent, std::uint64_t count) {
  std::vector<std::uint32_t> gids = tiled_gids_of_csv(parent.node.text().get(), parent.place());
  for_each_child(parent, [&](const Element& child) {
    if (child.kind() == "tile") gids.push_back(index_of(child, "gid").value_or(0));
  });
  std::vector<Omission> fewer_are_allowed;
  check_count(gids.size(), count, parent.place(), fewer_are_allowed);
  return gids;
}

/// Reads the cells of a <data> or <chunk> that begin at (x, y), as many as `sized` says.
void read_cells(const Element& data, const Element& sized, const TiledDataFormat& format, TiledLayer& layer,
                TiledMap& map) {
  TiledCells cells = tiled_cells_of(sized);
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

/// Reads the layers of a map or group; `depth` is the number of enclosing groups.
void read_layers(const Element& parent, std::size_t depth, std::vector<TiledLayer>& layers, TiledMap& map) {
  for_each_child(parent, [&](const Element& child) {
    const std::string_view kind = child.kind();
    if (kind == "imagelayer") return count_omission(map.omissions, tiled_omission::image_layer, child.place());
    if (kind == "tileset" || kind == "properties" || kind == "editorsettings") return;
    if (kind != "layer" && kind != "objectgroup" && kind != "group") {
      return count_omission(map.omissions, tiled_omission::unknown_element, child.place());
    }
    count_omission(map.omissions, tiled_omission::custom_property, child.place(),
                   count_children(child.child("properties"), "property"));
    TiledLayer layer = tiled_layer_of(child, map.omissions);
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

/// A file's elements, and the text that contains them.
struct ParsedXml {
  std::string buffer;
  pugi::xml_document document;
};

/// The root element of a file, which must be of the kind needed. `parsed` owns it.
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
  map.grid = tiled_grid_of(root);
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
  std::vector<Omission> unknown;  // belongs to the template's file, not to the map
  result.object = object_of(object, unknown);
  return result;
}

}  // namespace graze::io
