// SPDX-License-Identifier: MIT
// The header of PLY, which names the elements of the file and their properties.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace graze::io {

/// The types of numbers in their order of `ply_type_bytes`.
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// The bytes of a number in a binary file.
std::size_t ply_bytes(PlyType type);

/// A number, or a list of numbers after their count.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count_type = std::nullopt;  ///< Of lists.
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  std::size_t offset = 0;  ///< Of its line, for messages.

  /// The place of the property of that name.
  std::optional<std::size_t> find(std::string_view property) const;
  /// The fewest bytes that one of these takes: numbers as they are in a binary file, one digit and a blank as text.
  std::size_t least_bytes(bool is_text) const;
};

enum class PlyEncoding : std::uint8_t { text, little_endian, big_endian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::text;
  std::vector<PlyElement> elements;
  std::size_t end = 0;                ///< Where the first element begins.
  std::vector<std::string> warnings;  ///< Of lines that were skipped because their first word is unknown.
};

/// Reads the header of a file that begins with "ply" and a line end. Throws InputError.
PlyHeader read_ply_header(std::string_view bytes, const std::string& source);

}  // namespace graze::io
