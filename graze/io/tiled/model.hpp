// SPDX-License-Identifier: MIT
// A Tiled map as written, the same for XML and JSON, before references are resolved or anything is calculated.
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

/// How deeply groups may be nested, because reading them uses the stack.
inline constexpr std::size_t max_tiled_group_depth = 32;

/// Refuses the group at `offset` if its nesting level `depth` is too deep.
void require_group_depth(std::size_t depth, const TiledText& file, std::size_t offset);

/// The outline of an object; the default is a rectangle.
enum class TiledOutline { rectangle, ellipse, capsule, point, polygon, polyline, text };

/// An object as written; missing fields are empty and may come from its template.
struct TiledObject {
  std::size_t offset = 0;  ///< Its position in the file.
  std::optional<std::string> name;
  std::optional<std::uint32_t> id;
  std::optional<double> x, y, width, height;  ///< Pixels.
  std::optional<double> rotation;             ///< Degrees, clockwise.
  std::optional<std::uint32_t> gid;           ///< The tile of the object, with the flip bits.
  std::optional<TiledOutline> outline;
  std::vector<Vec<2, double>> points;  ///< The points of a polygon or polyline, relative to the object's position.
  std::string template_source;         ///< The template's file, or empty.
  std::size_t properties = 0;          ///< Number of custom properties.
  bool has_class = false;
};

/// The point of a tile object at its x and y, as fractions of its size from the top left.
struct TiledAlignment {
  Vec<2, double> fraction = {0.0, 1.0};
};

/// The alignment of that name ("topleft" ... "bottomright"); none for "unspecified" and names unknown to Tiled.
std::optional<TiledAlignment> tiled_alignment(std::string_view name);

/// A tile that its tileset lists.
struct TiledTile {
  std::optional<double> width, height;  ///< The size of its own image.
  std::vector<TiledObject> shapes;      ///< Its collision shapes.
};

struct TiledTileset {
  std::size_t offset = 0;       ///< Its position in the file.
  std::uint32_t first_gid = 1;  ///< In the numbering of the map or template that uses the tileset.
  std::string source;           ///< The file that contains the rest, or empty.
  std::optional<double> tile_width, tile_height;
  std::optional<std::uint32_t> tile_count;
  std::optional<TiledAlignment> alignment;
  bool is_collection = false;                  ///< Every tile has its own image and must be listed.
  Vec<2, double> drawing_offset = {0.0, 0.0};  ///< Offset of drawn tiles, in their own pixels.
  bool fills_grid = false;                     ///< In layers, tiles are drawn as large as the map's cells.
  bool keeps_aspect = false;                   ///< ... and keep their proportions.
  TiledGrid grid;                              ///< The grid of collision shapes: orthogonal or isometric.
  std::map<std::uint32_t, TiledTile> tiles;
};

/// A rectangle of cells and their tiles: a complete tile layer, or a chunk of one.
struct TiledCells {
  std::int32_t x = 0, y = 0;  ///< The cell at the top left.
  std::uint32_t width = 0;
  std::vector<std::uint32_t> gids;  ///< Row by row, with the flip bits; 0 for none. The last row may be incomplete.
};

/// How many cells the compressed tile layers of one map may have in total: limits what a small file can expand to.
inline constexpr std::uint64_t max_tiled_cells = std::uint64_t{1} << 26U;

struct TiledLayer {
  std::size_t offset = 0;
  std::string name;
  Vec<2, double> shift = {0.0, 0.0};  ///< The layer's own offset, in screen pixels.
  std::vector<TiledObject> objects;
  std::vector<TiledCells> cells;   ///< The cells of a tile layer.
  std::vector<TiledLayer> layers;  ///< The layers of a group, in drawing order.
};

struct TiledMap {
  TiledGrid grid;
  std::vector<TiledTileset> tilesets;
  std::vector<TiledLayer> layers;   ///< Layers of objects and tiles, and groups; others are counted as omissions.
  std::vector<Omission> omissions;  ///< What the file contains that this model cannot represent.
  std::uint64_t cell_count = 0;     ///< Cells of all compressed tile layers.
};

/// A template: one object, and the tileset of its tile.
struct TiledTemplate {
  std::optional<TiledTileset> tileset;
  TiledObject object;
};

/// Adds the cells of another compressed rectangle, `width` by `height`; refuses a total above `max_tiled_cells`.
void add_cells(TiledMap& map, std::uint64_t width, std::uint64_t height, const TiledPlace& place);

/// Refuses impossible objects: a negative size, a polygon or polyline of fewer than two points.
void require_sound(const TiledObject& object, const TiledText& file);

/// The grid of a tileset's collision shapes: the tileset's own if it is isometric, otherwise an orthogonal one, whose
/// projection is the identity.
TiledGrid tiled_drawing_grid(std::string_view orientation, double width, double height);

/// Refuses a number that is not a 32-bit integer: `field` names it.
void require_whole(double value, std::string_view field, const TiledPlace& place);

/// Refuses a map whose grid cannot be used: sizes below 0, or of 0 where the projection divides by them.
void require_sound(const TiledGrid& grid, const TiledPlace& place);

/// Refuses a tileset with a negative tile size, or a numbering that begins below 1.
void require_sound(const TiledTileset& tileset, const TiledText& file);

/// Refuses a file of the wrong kind: `found` and `needed` are "map", "tileset", "template" or unknown.
[[noreturn]] void fail_for_kind(const TiledText& file, std::size_t offset, std::string_view found,
                                std::string_view needed);

/// 'object "coin" (id 12)' for messages, with what is known.
std::string described(const TiledObject& object);

}  // namespace graze::io
