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

/// The format of a layer's tiles, in the map's terms: encoding "csv" or "base64", compression "", "zlib", "gzip" or
/// "zstd".
struct TiledDataFormat {
  std::string encoding;
  std::string compression;
};

/// The gids in `text`, in that format; `count` are expected. None if graze, or this build of it, does not support the
/// format; this is counted as an omission. Throws InputError if the text is broken or contains more gids; fewer are
/// counted as an omission, in CSV only.
std::optional<std::vector<std::uint32_t>> tiled_gids(std::string_view text, const TiledDataFormat& format,
                                                     std::uint64_t count, const TiledPlace& place,
                                                     std::vector<Omission>& omissions);

/// Comma-separated numbers; a trailing comma is allowed. Throws InputError for anything else.
std::vector<std::uint32_t> tiled_gids_of_csv(std::string_view text, const TiledPlace& place);

/// Refuses `found` tiles if a layer or chunk has fewer cells, `count`; counts a layer that has more cells as an
/// omission.
void check_count(std::uint64_t found, std::uint64_t count, const TiledPlace& place, std::vector<Omission>& omissions);

}  // namespace graze::io
