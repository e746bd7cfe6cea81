// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <graze/io/tiled/omissions.hpp>
#include <graze/io/tiled/text.hpp>

namespace graze::io {

/// How the tiles of a layer are written, as a map names it: "csv" or "base64", and then "", "zlib", "gzip" or "zstd".
struct TiledDataFormat {
  std::string encoding;
  std::string compression;
};

/// The gids that `text` holds, `count` of them, in that format. None when graze, or this build of it, does not know the
/// format, which is counted. Throws InputError when the text is broken or holds more; of CSV, fewer are counted.
std::optional<std::vector<std::uint32_t>> tiled_gids(std::string_view text, const TiledDataFormat& format,
                                                     std::uint64_t count, const TiledPlace& place,
                                                     std::vector<Omission>& omissions);

/// Numbers with commas between; one more comma may stand at the end. Throws InputError where something else stands.
std::vector<std::uint32_t> tiled_gids_of_csv(std::string_view text, const TiledPlace& place);

/// Refuses `found` tiles where a layer or chunk has fewer cells, `count`; counts a layer that has more.
void check_count(std::uint64_t found, std::uint64_t count, const TiledPlace& place, std::vector<Omission>& omissions);

}  // namespace graze::io
