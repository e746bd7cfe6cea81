// SPDX-License-Identifier: MIT
// What a Tiled map can contain that the resulting scene lacks or approximates.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include <graze/io/scene_file.hpp>
#include <graze/io/tiled/text.hpp>

namespace graze::io {

/// A kind of omission: what is counted, what the scene lacks because of it, and why.
struct OmissionKind {
  std::string_view what;
  Loss loss = Loss::none;
  std::string_view why;
};

/// Adds `count` to the omission of that kind; does nothing for zero. The first call determines where: `place`.
void count_omission(std::vector<Omission>& omissions, const OmissionKind& kind, const TiledPlace& place,
                    std::size_t count = 1);

namespace tiled_omission {

inline constexpr OmissionKind custom_property{"custom property", Loss::none, "a scene cannot store it"};
inline constexpr OmissionKind object_class{"object class", Loss::none, "a scene cannot store it"};
inline constexpr OmissionKind text_object{"text object", Loss::none, "its extent depends on a font"};
inline constexpr OmissionKind image_layer{"image layer", Loss::none, "a picture has no shape"};
inline constexpr OmissionKind layer_parallax{"layer parallax", Loss::precision,
                                             "its apparent position depends on the camera; its own position is read"};
inline constexpr OmissionKind unknown_element{"unknown element", Loss::shape, "graze does not support it"};
inline constexpr OmissionKind unknown_layer{"unknown layer", Loss::shape, "graze does not support this kind of layer"};
inline constexpr OmissionKind ellipse{"ellipse drawn as a 64-gon", Loss::precision,
                                      "it is read up to 0.12 % of its radius smaller"};
inline constexpr OmissionKind capsule{"capsule drawn as a polygon", Loss::precision,
                                      "the map's projection distorts it"};
inline constexpr OmissionKind large_polygon{"polygon of more than 10000 corners", Loss::shape,
                                            "cutting it would take too long; draw it as several polygons"};
inline constexpr OmissionKind wild_polygon{"polygon that crosses itself too often", Loss::shape,
                                           "cutting it would take too long; draw it as several polygons"};
inline constexpr OmissionKind object_collision{"collision shape of a tile object", Loss::precision,
                                               "the tile object's whole rectangle is read"};
inline constexpr OmissionKind tile_without_size{"collision shape of a tile without size", Loss::shape,
                                                "neither its picture nor its tileset has a width and a height"};
inline constexpr OmissionKind missing_tileset{"missing tileset", Loss::none, "its file cannot be read"};
inline constexpr OmissionKind short_layer{"tile layer with fewer tiles than cells", Loss::shape,
                                          "the rest of its cells is read as empty; is the file cut off?"};
inline constexpr OmissionKind plain_tile{
    "tile without collision shape", Loss::none,
    "a picture has no shape; draw one in Tiled's tile collision editor for tiles that others can touch"};
inline constexpr OmissionKind lost_tile{"tile of a missing tileset", Loss::shape, "its tileset's file cannot be read"};
inline constexpr OmissionKind stray_tile{"tile that no tileset holds", Loss::shape, "its gid is beyond all tilesets"};

}  // namespace tiled_omission

}  // namespace graze::io
