// SPDX-License-Identifier: MIT
// What a Tiled map says about its objects, the same from XML and JSON, before anything is looked up or calculated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <graze/io/scene_file.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

/// A file's text, without byte order mark, with the name that messages call it by.
struct TiledText {
  std::string name;
  std::string_view text;
};

/// Throws InputError: "name: line 3, column 7: fact" for the byte at `offset`.
[[noreturn]] void fail_at(const TiledText& file, std::size_t offset, const std::string& fact);

/// How many groups may be inside each other: reading them needs stack.
inline constexpr std::size_t max_tiled_group_depth = 32;

/// Refuses the group at `offset` when it is the `depth`th inside each other and that is too deep.
void require_group_depth(std::size_t depth, const TiledText& file, std::size_t offset);

/// What outline an object asks for; an object that says nothing is a rectangle.
enum class TiledOutline { rectangle, ellipse, capsule, point, polygon, polyline, text };

/// An object as written: what is not said is empty, and may come from its template.
struct TiledObject {
  std::size_t offset = 0;  ///< Where in the file it begins.
  std::optional<std::string> name;
  std::optional<std::uint32_t> id;
  std::optional<double> x, y, width, height;  ///< Pixels.
  std::optional<double> rotation;             ///< Degrees, clockwise.
  std::optional<std::uint32_t> gid;           ///< The tile it shows, with the flip bits.
  std::optional<TiledOutline> outline;
  std::vector<Vec<2, double>> points;  ///< Of a polygon or polyline, from the object's place.
  std::string template_source;         ///< The template's file, or empty.
  std::size_t properties = 0;          ///< How many custom properties.
  bool has_class = false;
};

/// The point of a tile object that its x and y mean, as fractions of its size from the top left.
struct TiledAlignment {
  Vec<2, double> fraction = {0.0, 1.0};
};

/// The alignment of that name ("topleft" ... "bottomright"); none for "unspecified" and for names that Tiled does not
/// know.
std::optional<TiledAlignment> tiled_alignment(std::string_view name);

/// A tile that its tileset says something about.
struct TiledTile {
  std::optional<double> width, height;  ///< Of its own image.
  std::size_t shapes = 0;               ///< How many collision shapes were drawn on it.
};

struct TiledTileset {
  std::size_t offset = 0;       ///< Where in the file it begins.
  std::uint32_t first_gid = 1;  ///< As the map or template that uses the tileset numbers its tiles.
  std::string source;           ///< The file that holds the rest, or empty.
  std::optional<double> tile_width, tile_height;
  std::optional<std::uint32_t> tile_count;
  std::optional<TiledAlignment> alignment;
  bool is_collection = false;       ///< Every tile has its own image and must be listed.
  bool has_drawing_offset = false;  ///< Tiles are drawn beside their place.
  std::map<std::uint32_t, TiledTile> tiles;
};

struct TiledLayer {
  std::size_t offset = 0;
  std::string name;
  Vec<2, double> shift = {0.0, 0.0};  ///< The layer's own, in pixels.
  std::vector<TiledObject> objects;
  std::vector<TiledLayer> layers;  ///< Of a group, in drawing order.
};

struct TiledMap {
  std::string orientation = "orthogonal";
  std::vector<TiledTileset> tilesets;
  std::vector<TiledLayer> layers;   ///< Object layers and groups; what else there is, is counted.
  std::vector<Omission> omissions;  ///< What the file holds that has no place in this model.
};

/// A template: one object, and the tileset its tile is from.
struct TiledTemplate {
  std::optional<TiledTileset> tileset;
  TiledObject object;
};

/// Adds `count` to the omission of that kind; nothing when it is zero.
void count_omission(std::vector<Omission>& omissions, std::string_view what, std::size_t count = 1);

/// Refuses what no object can mean: a negative size, a polygon or polyline of fewer than two points.
void require_sound(const TiledObject& object, const TiledText& file);

/// Refuses a tileset whose tiles would have a negative size, or whose numbering does not start at 1 or above.
void require_sound(const TiledTileset& tileset, const TiledText& file);

/// Refuses a file of another kind than the one needed: `found` and `needed` are "map", "tileset", "template" or
/// unknown.
[[noreturn]] void fail_for_kind(const TiledText& file, std::size_t offset, std::string_view found,
                                std::string_view needed);

/// 'object "coin" (id 12)', as far as known, for messages.
std::string described(const TiledObject& object);

}  // namespace graze::io
