// SPDX-License-Identifier: MIT
#pragma once

#include <graze/io/tiled/model.hpp>

namespace graze::io {

/// Reads a map in Tiled's XML (.tmx). Throws InputError with the position of the fault.
TiledMap read_tiled_xml_map(const TiledText& file);

/// Reads a tileset in Tiled's XML (.tsx). Throws InputError.
TiledTileset read_tiled_xml_tileset(const TiledText& file);

/// Reads a template in Tiled's XML (.tx). Throws InputError.
TiledTemplate read_tiled_xml_template(const TiledText& file);

}  // namespace graze::io
