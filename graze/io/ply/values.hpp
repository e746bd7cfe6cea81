// SPDX-License-Identifier: MIT
// The numbers after the header of PLY.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <graze/io/input_error.hpp>
#include <graze/io/mesh/tokens.hpp>
#include <graze/io/ply/header.hpp>

namespace graze::io {

/// Reads the numbers of a file in turn, from text or from bytes.
class PlyValues {
 public:
  /// Refers to all three.
  PlyValues(std::string_view bytes, const std::string& source, const PlyHeader& header);

  /// A finite number. Throws InputError, naming it as `name`.
  double number(PlyType type, std::string_view name);
  /// A whole number. Throws InputError likewise.
  std::int64_t whole(PlyType type, std::string_view name);
  /// The length of a list, which the rest of the file can hold. Throws InputError.
  std::size_t length(const PlyProperty& list);
  void skip(const PlyProperty& property);

  /// Where the last number was.
  std::size_t offset() const { return offset_; }
  std::size_t bytes_left() const { return bytes_.size() - at(); }
  bool is_text() const { return encoding_ == PlyEncoding::text; }

  /// The error "source: line 3, column 7: message", in a binary file "source: byte 70: message".
  InputError error(std::size_t offset, std::string_view message) const;

 private:
  std::size_t at() const { return is_text() ? tokens_.offset() : at_; }
  /// The next number of a binary file.
  double binary(PlyType type, std::string_view name);

  std::string_view bytes_;
  const std::string& source_;
  PlyEncoding encoding_;
  MeshTokens tokens_;
  std::size_t at_;
  std::size_t offset_;
};

}  // namespace graze::io
