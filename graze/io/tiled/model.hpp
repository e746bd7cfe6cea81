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
#include <graze/io/tiled/projection.hpp>
#include <graze/io/tiled/text.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

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
  std::vector<TiledObject> shapes;      ///< The collision shapes that were drawn on it.
};

struct TiledTileset {
  std::size_t offset = 0;       ///< Where in the file it begins.
  std::uint32_t first_gid = 1;  ///< As the map or template that uses the tileset numbers its tiles.
  std::string source;           ///< The file that holds the rest, or empty.
  std::optional<double> tile_width, tile_height;
  std::optional<std::uint32_t> tile_count;
  std::optional<TiledAlignment> alignment;
  bool is_collection = false;                  ///< Every tile has its own image and must be listed.
  Vec<2, double> drawing_offset = {0.0, 0.0};  ///< How far beside their place tiles are drawn, in their own pixels.
  bool fills_grid = false;                     ///< In layers tiles are drawn as large as the map's cells.
  bool keeps_aspect = false;                   ///< ... and keep their proportions.
  TiledGrid grid;                              ///< What collision shapes are drawn on: orthogonal or isometric.
  std::map<std::uint32_t, TiledTile> tiles;
};

/// A rectangle of cells and the tiles in them: the whole of a tile layer, or a chunk of one.
struct TiledCells {
  std::int32_t x = 0, y = 0;  ///< The cell at the top left.
  std::uint32_t width = 0;
  std::vector<std::uint32_t> gids;  ///< Row by row, with the flip bits; 0 for none. The last row may be incomplete.
};

/// How many cells the packed tile layers of one map may have, all together: what a small file unpacks to has to end
/// somewhere.
inline constexpr std::uint64_t max_tiled_cells = std::uint64_t{1} << 26U;

struct TiledLayer {
  std::size_t offset = 0;
  std::string name;
  Vec<2, double> shift = {0.0, 0.0};  ///< The layer's own, in pixels of the screen.
  std::vector<TiledObject> objects;
  std::vector<TiledCells> cells;   ///< Of a tile layer.
  std::vector<TiledLayer> layers;  ///< Of a group, in drawing order.
};

struct TiledMap {
  TiledGrid grid;
  std::vector<TiledTileset> tilesets;
  std::vector<TiledLayer> layers;   ///< Layers of objects and tiles, and groups; what else there is, is counted.
  std::vector<Omission> omissions;  ///< What the file holds that has no place in this model.
  std::uint64_t cell_count = 0;     ///< Of all packed tile layers.
};

/// A template: one object, and the tileset its tile is from.
struct TiledTemplate {
  std::optional<TiledTileset> tileset;
  TiledObject object;
};

/// Counts the cells of one more packed rectangle, `width` by `height`; refuses more than `max_tiled_cells`.
void add_cells(TiledMap& map, std::uint64_t width, std::uint64_t height, const TiledPlace& place);

/// Refuses what no object can mean: a negative size, a polygon or polyline of fewer than two points.
void require_sound(const TiledObject& object, const TiledText& file);

/// The grid that a tileset's collision shapes are drawn on: that of the tileset if it is isometric, else an orthogonal
/// one, on which nothing is moved.
TiledGrid tiled_drawing_grid(std::string_view orientation, double width, double height);

/// Refuses a number that is no whole number of 32 bits: `field` names it.
void require_whole(double value, std::string_view field, const TiledPlace& place);

/// Refuses a map on whose grid nothing can be placed: sizes below 0, or of 0 where the projection divides by them.
void require_sound(const TiledGrid& grid, const TiledPlace& place);

/// Refuses a tileset whose tiles would have a negative size, or whose numbering does not start at 1 or above.
void require_sound(const TiledTileset& tileset, const TiledText& file);

/// Refuses a file of another kind than the one needed: `found` and `needed` are "map", "tileset", "template" or
/// unknown.
[[noreturn]] void fail_for_kind(const TiledText& file, std::size_t offset, std::string_view found,
                                std::string_view needed);

/// 'object "coin" (id 12)', as far as known, for messages.
std::string described(const TiledObject& object);

}  // namespace graze::io
