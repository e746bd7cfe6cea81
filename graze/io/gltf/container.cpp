// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include <graze/io/gltf/container.hpp>
#include <graze/io/input_error.hpp>
#include <graze/io/mesh/bytes.hpp>

namespace graze::io {
namespace {

InputError glb_error(const std::string& source, std::size_t at, const std::string& message) {
  return InputError(fmt::format("{}: byte {}: {}", source, at, message));
}

}  // namespace

GlbChunks read_glb(std::string_view bytes, const std::string& source) {
  if (bytes.size() < glb_head_bytes) throw glb_error(source, bytes.size(), "the header is cut off; it has 12 bytes");
  const auto version = number_at<std::uint32_t>(bytes.data() + 4);
  if (version != 2) {
    throw glb_error(source, 4, fmt::format("this is glTF {}; graze reads glTF 2.0, so export it as that", version));
  }
  const auto length = number_at<std::uint32_t>(bytes.data() + 8);
  if (length > bytes.size() || length < glb_head_bytes) {
    throw glb_error(
        source, 8,
        fmt::format("the header promises {} bytes, but the file has {}; is it cut off?", length, bytes.size()));
  }
  GlbChunks chunks;
  std::size_t number = 0;
  for (std::size_t at = glb_head_bytes; at < length; ++number) {
    const std::size_t left = length - at;
    if (left < glb_chunk_head_bytes) throw glb_error(source, at, fmt::format("chunk {} is cut off", number));
    const auto size = number_at<std::uint32_t>(bytes.data() + at);
    const auto type = number_at<std::uint32_t>(bytes.data() + at + 4);
    at += glb_chunk_head_bytes;
    if (size > left - glb_chunk_head_bytes) {
      throw glb_error(source, at - glb_chunk_head_bytes,
                      fmt::format("chunk {} promises {} bytes, but {} follow; is the file cut off?", number, size,
                                  left - glb_chunk_head_bytes));
    }
    if (number == 0) {
      if (type != glb_json_chunk) throw glb_error(source, at - 4, "the first chunk must be JSON");
      chunks.json = bytes.substr(at, size);
    } else if (number == 1 && type == glb_binary_chunk) {
      chunks.binary = bytes.substr(at, size);
    }
    at += size;
  }
  while (chunks.json.ends_with('\0')) chunks.json.remove_suffix(1);  // padding must be blanks, but may be this
  if (number == 0) throw glb_error(source, glb_head_bytes, "there is no chunk; the first one must be JSON");
  return chunks;
}

}  // namespace graze::io
