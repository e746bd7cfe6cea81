// SPDX-License-Identifier: MIT
#pragma once

#include <graze/io/json/document.hpp>
#include <graze/io/tiled/model.hpp>

namespace graze::io {

/// Reads a map in Tiled's JSON (.tmj). Throws InputError with the position of the fault.
TiledMap read_tiled_json_map(const TiledText& file);

/// The same from the file's text, parsed with the packed field "data".
TiledMap read_tiled_json_map(const TiledText& file, const JsonDocument& document);

/// Reads a tileset in Tiled's JSON (.tsj). Throws InputError.
TiledTileset read_tiled_json_tileset(const TiledText& file);

/// Reads a template in Tiled's JSON (.tj). Throws InputError.
TiledTemplate read_tiled_json_template(const TiledText& file);

}  // namespace graze::io
