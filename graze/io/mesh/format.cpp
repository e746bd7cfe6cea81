// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include <graze/io/mesh/bytes.hpp>
#include <graze/io/mesh/format.hpp>
#include <graze/io/off/header.hpp>
#include <graze/io/stl/layout.hpp>
#include <graze/io/text/utf8.hpp>

namespace graze::io {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";
constexpr std::size_t start_bytes = 4096;  // enough for comments before the first statement

bool is_blank_or_end(std::string_view text, std::size_t at) {
  return at >= text.size() || blanks.find(text[at]) != std::string_view::npos;
}

/// The text from its first statement on: without blank lines and lines that begin with #.
std::string_view without_comments(std::string_view text) {
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    if (!text.starts_with('#')) return text;
    text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
  }
}

/// True for bytes that no text contains: zero bytes, and control characters except blanks.
bool has_binary_bytes(std::string_view bytes) {
  return std::any_of(bytes.begin(), bytes.end(), [](char byte) {
    return static_cast<unsigned char>(byte) < 0x20 && blanks.find(byte) == std::string_view::npos;
  });
}

/// Whether the size is that of the triangles that the header promises. A text is longer by far: its bytes at that place
/// are a number beyond 10^8. A binary file that is cut off or too long is known by bytes that no text contains and by
/// the number of its first triangle's coordinates that could be lengths.
bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < stl_head_bytes) return false;
  const auto count = number_at<std::uint32_t>(bytes.data() + stl_name_bytes);
  const std::uint64_t needed = stl_head_bytes + std::uint64_t{stl_triangle_bytes} * count;
  if (needed == bytes.size()) return true;
  if (count == 0 || bytes.size() < stl_head_bytes + stl_triangle_bytes || !has_binary_bytes(bytes.substr(0, 512))) {
    return false;
  }
  for (std::size_t i = 0; i < 12; ++i) {
    const double value = std::fabs(number_at<float>(bytes.data() + stl_head_bytes + 4 * i));
    if (!(value == 0 || (value > 1e-20 && value < 1e20))) return false;
  }
  return true;
}

bool is_stl_text(std::string_view text) {
  constexpr std::string_view solid = "solid";
  const std::string_view content = text.substr(std::min(text.find_first_not_of(blanks), text.size()));
  if (!content.starts_with(solid) || !is_blank_or_end(content, solid.size())) return false;
  const std::string_view start = content.substr(0, start_bytes);
  return start.find("facet") != std::string_view::npos || start.find("endsolid") != std::string_view::npos;
}

/// The mark, and after it the version, whose bytes are not text; so a binary STL may be called "glTF".
bool is_glb(std::string_view bytes) {
  constexpr std::string_view mark = "glTF";
  if (!bytes.starts_with(mark)) return false;
  if (bytes.size() < mark.size() + 4) return true;  // cut off
  const auto version = number_at<std::uint32_t>(bytes.data() + mark.size());
  return 0 < version && version < 0x100;
}

/// A statement of OBJ: its keyword, and whether a number or a slash must follow.
struct Statement {
  std::string_view keyword;
  bool has_numbers;
};

constexpr std::array statements = {Statement{"v", true},  Statement{"vn", true},      Statement{"vt", true},
                                   Statement{"vp", true}, Statement{"f", true},       Statement{"l", true},
                                   Statement{"p", true},  Statement{"o", false},      Statement{"g", false},
                                   Statement{"s", false}, Statement{"mtllib", false}, Statement{"usemtl", false},
                                   Statement{"mg", true}, Statement{"cstype", false}};

/// OBJ has no mark of its own: it is a text whose first statement is one of OBJ.
bool is_obj(std::string_view text) {
  const std::string_view start = without_comments(text);
  const std::string_view word = start.substr(0, start.find_first_of(blanks));
  const auto* const known =
      std::find_if(statements.begin(), statements.end(), [word](const Statement& one) { return one.keyword == word; });
  if (known == statements.end() || word.size() == start.size()) return false;
  if (!known->has_numbers) return true;
  const std::size_t number = start.find_first_not_of(" \t", word.size());
  return number != std::string_view::npos &&
         std::string_view("+-.0123456789").find(start[number]) != std::string_view::npos;
}

}  // namespace

std::optional<MeshFormat> mesh_format_of(std::string_view bytes) {
  if (is_glb(bytes)) return MeshFormat::glb;
  if (is_binary_stl(bytes)) return MeshFormat::stl_binary;
  const std::string_view text = without_byte_order_mark(bytes);
  if (text.starts_with("ply") && text.size() > 3 && (text[3] == '\n' || text[3] == '\r')) return MeshFormat::ply;
  if (is_stl_text(text)) return MeshFormat::stl_text;
  if (off_header_of(without_comments(text))) return MeshFormat::off;
  if (is_obj(text)) return MeshFormat::obj;
  return std::nullopt;
}

}  // namespace graze::io
