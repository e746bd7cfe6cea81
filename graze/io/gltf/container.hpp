// SPDX-License-Identifier: MIT
// The binary container of glTF 2.0 (.glb): a header, then chunks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace graze::io {

inline constexpr std::size_t glb_head_bytes = 12;
inline constexpr std::size_t glb_chunk_head_bytes = 8;

/// The types of chunks.
inline constexpr std::uint32_t glb_json_chunk = 0x4E4F534A;    // "JSON"
inline constexpr std::uint32_t glb_binary_chunk = 0x004E4942;  // "BIN"

/// The chunks that have a meaning; others are skipped.
struct GlbChunks {
  std::string_view json;
  std::optional<std::string_view> binary;  ///< The buffer without a `uri`.
};

/// Splits a file that begins with "glTF". Throws InputError if it is cut off, has another version, or does not begin
/// with JSON.
GlbChunks read_glb(std::string_view bytes, const std::string& source);

}  // namespace graze::io
