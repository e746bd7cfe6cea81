// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include <graze/io/text/foreign_format.hpp>
#include <graze/io/text/printable.hpp>
#include <graze/io/text/utf8.hpp>

namespace graze::io {
namespace {

constexpr std::string_view write_shapes =
    "write its collision shapes as graze's JSON or CSV, which docs/scene_format.md describes";
constexpr std::string_view export_mesh = "export it as glTF (.glb), STL, OBJ, PLY or OFF";
constexpr std::string_view give_map = "give the map (.tmx or .tmj) that uses it";
constexpr std::string_view no_comments =
    "remove it: no scene that graze reads (its own JSON, CSV and Tiled maps) has comments at its start";
constexpr std::string_view export_map = "give the map itself (.tmx), or export it as JSON (.tmj)";

/// A format, how to recognise it, and what to do about it.
struct KnownFormat {
  std::string_view sign;
  std::string_view what;
  std::string_view remedy;
};

/// Recognised by the first bytes.
constexpr std::array beginnings = {
    KnownFormat{"[gd_scene", "a Godot scene", write_shapes},
    KnownFormat{"[gd_resource", "a Godot resource", write_shapes},
    KnownFormat{"%YAML", "YAML, as Unity writes its scenes", write_shapes},
    KnownFormat{"BLENDER", "a Blender file", export_mesh},
    KnownFormat{"Kaydara FBX", "a mesh in FBX", export_mesh},
    KnownFormat{"; FBX", "a mesh in FBX", export_mesh},
    KnownFormat{"#usda", "a scene in USD", export_mesh},
    KnownFormat{"# .PCD", "a point cloud in PCD", write_shapes},
    KnownFormat{"ISO-10303-21", "a CAD model in STEP", export_mesh},
    KnownFormat{"0\nSECTION", "a drawing in DXF", write_shapes},
    KnownFormat{"0\r\nSECTION", "a drawing in DXF", write_shapes},
    KnownFormat{"(function(name,data)", "a map that Tiled exported as JavaScript", export_map},
    KnownFormat{"return {", "Lua, as Tiled exports its maps", export_map},
    KnownFormat{"POLYGON (", "geometry in WKT", write_shapes},
    KnownFormat{"POLYGON(", "geometry in WKT", write_shapes},
    KnownFormat{"POINT (", "geometry in WKT", write_shapes},
    KnownFormat{"POINT(", "geometry in WKT", write_shapes},
    KnownFormat{"LINESTRING", "geometry in WKT", write_shapes},
    KnownFormat{"MULTIPOLYGON", "geometry in WKT", write_shapes},
    KnownFormat{"GEOMETRYCOLLECTION", "geometry in WKT", write_shapes},
    KnownFormat{"//", "text that begins with a comment (//)", no_comments},
    KnownFormat{"/*", "text that begins with a comment (/*)", no_comments},
    KnownFormat{"%PDF", "a PDF document", write_shapes},
    KnownFormat{"\x89PNG", "a picture (PNG)", write_shapes},
    KnownFormat{"\xff\xd8\xff", "a picture (JPEG)", write_shapes},
    KnownFormat{"\x1f\x8b", "compressed by gzip", "unpack it first: gzip -dc FILE | graze check -"},
    KnownFormat{"\x28\xb5\x2f\xfd", "compressed by zstd", "unpack it first: zstd -dc FILE | graze check -"},
    KnownFormat{"PK\x03\x04", "a ZIP archive", "unpack it first and give the scene inside"},
    KnownFormat{"A  ", "a report of graze check", "give the scene itself"},
    KnownFormat{"a,b,relation", "a report of graze check", "give the scene itself"},
    KnownFormat{"name,type", "output of graze query", "give the scene itself"}};

/// Recognised by the root element of XML.
constexpr std::array roots = {KnownFormat{"tileset", "a Tiled tileset", give_map},
                              KnownFormat{"template", "a Tiled template, a single object", give_map},
                              KnownFormat{"robot", "a robot in URDF", write_shapes},
                              KnownFormat{"sdf", "a robot or world in SDF", write_shapes},
                              KnownFormat{"mujoco", "a MuJoCo model", write_shapes},
                              KnownFormat{"COLLADA", "a mesh in COLLADA", export_mesh},
                              KnownFormat{"X3D", "a mesh in X3D", export_mesh},
                              KnownFormat{"svg", "an SVG picture", write_shapes},
                              KnownFormat{"html", "a web page", "give the scene file itself"},
                              KnownFormat{"kml", "a map in KML", write_shapes},
                              KnownFormat{"gpx", "a track in GPX", write_shapes},
                              KnownFormat{"osm", "an OpenStreetMap file", write_shapes}};

/// Recognised by this text near the beginning of a JSON document; blanks are ignored.
constexpr std::array json_signs = {
    KnownFormat{R"("type":"tileset")", "a Tiled tileset", give_map},
    KnownFormat{R"("type":"template")", "a Tiled template, a single object", give_map},
    KnownFormat{R"("type":"world")", "a Tiled world", "give one of the maps that it names"},
    KnownFormat{R"("schema":"graze.log/)", "a query log",
                "run it with graze replay, or query it with graze query --log"},
    KnownFormat{R"("schema":"graze.check/)", "a report of graze check", "give the scene itself"},
    KnownFormat{R"("schema":"graze.query/)", "output of graze query", "give the scene itself"},
    KnownFormat{R"("schema":"graze.info/)", "output of graze info", "give the scene itself"},
    KnownFormat{R"("schema":"graze.bench/)", "output of graze bench", "give the scene itself"},
    KnownFormat{R"("schema":"graze.replay/)", "output of graze replay", "give the scene itself"},
    KnownFormat{R"({"frame":0,"seconds":)", "a report of graze simulate", "give the scene itself"},
    KnownFormat{R"("relation":")", "a report of graze check", "give the scene itself"},
    KnownFormat{R"("tilecount":)", "a Tiled tileset", give_map},
    KnownFormat{R"("type":"FeatureCollection")", "GeoJSON", write_shapes},
    KnownFormat{R"("__header__":{"fileType":"LDtk)", "an LDtk project", write_shapes},
    KnownFormat{R"("ogmoVersion":)", "an Ogmo level or project", write_shapes},
    KnownFormat{R"("automappingRulesFile":)", "a Tiled project", "give one of its maps (.tmx or .tmj)"},
    KnownFormat{R"({"classname""worldspawn")", "a Quake map", write_shapes}};

std::string sentence(const KnownFormat& format) { return fmt::format("this is {}; {}", format.what, format.remedy); }

/// The name of the first element after declarations, comments and document types.
std::string_view root_name(std::string_view text) {
  for (std::size_t at = text.find('<'); at < text.size(); at = text.find('<', at + 1)) {
    const std::string_view rest = text.substr(at + 1);
    if (rest.starts_with("!--")) {
      at = std::min(text.find("-->", at), text.size() - 1);
    } else if (!rest.starts_with("!") && !rest.starts_with("?")) {
      const std::string_view name = rest.substr(0, rest.find_first_of(" \t\r\n/>"));
      return name.substr(name.rfind(':') + 1);  // without its namespace prefix
    }
  }
  return {};
}

/// The beginning of JSON without blanks, which may differ between writers.
std::string without_blanks_between(std::string_view text) {
  constexpr std::size_t enough = 600;
  std::string result;
  for (const char character : text.substr(0, enough)) {
    if (std::string_view(" \t\r\n").find(character) == std::string_view::npos) result.push_back(character);
  }
  return result;
}

std::string xml_format(std::string_view text) {
  const std::string_view root = root_name(text);
  const auto* const known =
      std::find_if(roots.begin(), roots.end(), [root](const KnownFormat& format) { return format.sign == root; });
  if (known != roots.end()) return sentence(*known);
  if (root.empty() || root == "map") return "";
  return fmt::format(
      "this is XML whose root is <{}>; the only XML that graze reads are Tiled maps (.tmx), whose root "
      "is <map>",
      printable(root.substr(0, 40)));
}

std::string json_format(std::string_view text) {
  const std::string start = without_blanks_between(text);
  const bool is_scene = start.find(R"("schema":"graze.scene/)") != std::string::npos ||
                        start.find(R"("type":"map")") != std::string::npos ||
                        (start.find(R"("layers":[)") != std::string::npos && start.find("ogmo") == std::string::npos);
  if (is_scene) return "";
  const auto* const known = std::find_if(json_signs.begin(), json_signs.end(), [&start](const KnownFormat& format) {
    return start.find(format.sign) != std::string::npos;
  });
  return known == json_signs.end() ? "" : sentence(*known);
}

/// "[section]" on a line of its own begins INI and TOML files, which would otherwise be reported as broken JSON.
bool is_section(std::string_view text) {
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  const std::size_t end = line.find(']');
  if (!line.starts_with('[') || end == std::string_view::npos || end == 1) return false;
  const std::string_view name = line.substr(1, end - 1);
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-. ";
  if (name.find_first_not_of(letters) != std::string_view::npos || name == "true" || name == "false") return false;
  return name != "null" && name.find_first_not_of("0123456789-. eE") != std::string_view::npos;
}

}  // namespace

std::string foreign_format(std::string_view text) {
  const std::string_view encoding = other_encoding(text);
  if (!encoding.empty()) return fmt::format("this is {}; save it as UTF-8", encoding);
  const std::string_view content = text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (content.starts_with('<')) return xml_format(content);
  if (content.starts_with('{')) return json_format(content);
  const auto* const known = std::find_if(beginnings.begin(), beginnings.end(), [content](const KnownFormat& format) {
    return content.starts_with(format.sign);
  });
  if (known != beginnings.end()) return sentence(*known);
  if (is_section(content)) return sentence({"[", "INI or TOML", write_shapes});
  // In many formats a comment; OBJ and OFF, which may begin with one, are recognised before.
  return content.starts_with('#') ? sentence({"#", "text that begins with a comment (#)", no_comments}) : "";
}

}  // namespace graze::io
