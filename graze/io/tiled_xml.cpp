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

#include <graze/io/in_quotes.hpp>
#include <graze/io/tiled_xml.hpp>
#include <graze/io/utf8.hpp>

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
      count_omission(omissions, "unknown element");
    }
  });
  require_sound(object, element.file);
  return object;
}

/// The size of a tile: of the part of the image that it shows, else of the whole image.
TiledTile tile_of(const Element& element) {
  TiledTile tile;
  const Element image = element.child("image");
  tile.width = number_of(element, "width");
  tile.height = number_of(element, "height");
  if (!tile.width) tile.width = number_of(image, "width");
  if (!tile.height) tile.height = number_of(image, "height");
  tile.shapes = count_children(element.child("objectgroup"), "object");
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
  const Element drawing_offset = element.child("tileoffset");
  tileset.has_drawing_offset =
      number_of(drawing_offset, "x").value_or(0) != 0 || number_of(drawing_offset, "y").value_or(0) != 0;
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
  count_omission(omissions, "custom property", count_children(layer.child("properties"), "property"));
  if (number_of(layer, "parallaxx").value_or(1) != 1 || number_of(layer, "parallaxy").value_or(1) != 1) {
    count_omission(omissions, "layer parallax");
  }
}

/// Reads the layers of a map or group; `depth` counts the groups around them.
void read_layers(const Element& parent, std::size_t depth, std::vector<TiledLayer>& layers,
                 std::vector<Omission>& omissions) {
  for_each_child(parent, [&](const Element& child) {
    const std::string_view kind = child.kind();
    if (kind == "objectgroup" || kind == "group") {
      TiledLayer layer;
      layer.offset = child.offset();
      layer.name = text_of(child, "name").value_or("");
      layer.shift = shift_of(child);
      count_layer_omissions(child, omissions);
      if (kind == "group") {
        require_group_depth(depth + 1, child.file, child.offset());
        read_layers(child, depth + 1, layer.layers, omissions);
      } else {
        for_each_child(child, [&](const Element& object) {
          if (object.kind() == "object") layer.objects.push_back(object_of(object, omissions));
          if (object.kind() != "object" && object.kind() != "properties") count_omission(omissions, "unknown element");
        });
      }
      layers.push_back(std::move(layer));
    } else if (kind == "layer") {
      count_omission(omissions, "tile layer");
    } else if (kind == "imagelayer") {
      count_omission(omissions, "image layer");
    } else if (kind != "tileset" && kind != "properties" && kind != "editorsettings") {
      count_omission(omissions, "unknown element");
    }
  });
}

/// The outermost element of a file, which must be of the kind needed. `document` holds it.
Element root_of(const TiledText& file, std::string_view needed, pugi::xml_document& document) {
  require_utf8(file.text, file.name);
  const pugi::xml_parse_result result =
      document.load_buffer(file.text.data(), file.text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result) {
    const auto offset = static_cast<std::size_t>(result.offset > 0 ? result.offset : 0);
    fail_at(file, offset, fmt::format("the XML is broken or cut off: {}", result.description()));
  }
  const Element root{file, document.document_element()};
  if (root.kind() != needed) fail_for_kind(file, root.offset(), root.kind(), needed);
  return root;
}

}  // namespace

TiledMap read_tiled_xml_map(const TiledText& file) {
  pugi::xml_document document;
  const Element root = root_of(file, "map", document);
  TiledMap map;
  map.orientation = text_of(root, "orientation").value_or(map.orientation);
  for_each_child(root, [&](const Element& child) {
    if (child.kind() == "tileset") map.tilesets.push_back(tileset_of(child));
  });
  count_omission(map.omissions, "custom property", count_children(root.child("properties"), "property"));
  read_layers(root, 0, map.layers, map.omissions);
  return map;
}

TiledTileset read_tiled_xml_tileset(const TiledText& file) {
  pugi::xml_document document;
  return tileset_of(root_of(file, "tileset", document));
}

TiledTemplate read_tiled_xml_template(const TiledText& file) {
  pugi::xml_document document;
  const Element root = root_of(file, "template", document);
  TiledTemplate result;
  if (const Element tileset = root.child("tileset")) result.tileset = tileset_of(tileset);
  const Element object = root.child("object");
  if (!object) fail_at(file, root.offset(), "this template holds no <object>");
  std::vector<Omission> unknown;  // of the template's file, not of the map
  result.object = object_of(object, unknown);
  return result;
}

}  // namespace graze::io
