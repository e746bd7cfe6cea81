// SPDX-License-Identifier: MIT
// Decodes base64 and decompresses zlib, gzip and Zstandard data.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace graze::io {

/// Why bytes could not be unpacked, as text that continues "the data".
struct UnpackFault {
  std::string fact;
};

/// Bytes, or the reason why there are none.
struct Unpacked {
  std::string bytes;
  std::optional<UnpackFault> fault = std::nullopt;
};

/// Decodes base64 (RFC 4648). Blanks and line breaks are skipped; "=" may be missing at the end.
Unpacked decoded_base64(std::string_view text);

/// Compression formats.
enum class Packing { none, zlib, gzip, zstd };

/// True when this build can unpack that format.
bool can_unpack(Packing packing);

/// Decompresses data that must be exactly `size` bytes long. Never unpacks more, and allocates memory only as data
/// arrives.
Unpacked unpacked(std::string_view packed, Packing packing, std::size_t size);

}  // namespace graze::io
