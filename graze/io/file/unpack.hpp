// SPDX-License-Identifier: MIT
// Bytes out of base64 text and out of what zlib, gzip or Zstandard have packed.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace graze::io {

/// Why bytes could not be unpacked, in words that go on after "the data".
struct UnpackFault {
  std::string fact;
};

/// Bytes, or why there are none.
struct Unpacked {
  std::string bytes;
  std::optional<UnpackFault> fault = std::nullopt;
};

/// The bytes of base64 text (RFC 4648), blanks and line breaks skipped; "=" may be missing at the end.
Unpacked decoded_base64(std::string_view text);

/// Formats of packed data.
enum class Packing { none, zlib, gzip, zstd };

/// True when this build can unpack that format.
bool can_unpack(Packing packing);

/// What was packed, which must be exactly `size` bytes: no more is ever unpacked, and room is made as bytes come.
Unpacked unpacked(std::string_view packed, Packing packing, std::size_t size);

}  // namespace graze::io
