// SPDX-License-Identifier: MIT
// Words and numbers of the mesh formats that are text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <graze/io/input_error.hpp>

namespace graze::io {

/// A word of a text and its position; both are empty and at the end if there is none.
struct MeshToken {
  std::string_view text;
  std::size_t offset = 0;
};

/// What a format allows between words.
enum class MeshSyntax {
  plain,     ///< Blanks.
  comments,  ///< Also comments, from a `#` at the start of a word to the end of the line.
  obj,       ///< Also lines that are continued by a backslash at their end.
};

/// Reads a text word by word. Words are separated by blanks and tabs; lines end with LF, CRLF or CR.
class MeshTokens {
 public:
  /// Refers to both, which must outlive this. Reading starts at `begin`.
  MeshTokens(std::string_view text, const std::string& source, MeshSyntax syntax, std::size_t begin = 0)
      : text_(text), source_(source), syntax_(syntax), at_(begin) {}

  /// The next word of the current line; empty at its end.
  MeshToken next_in_line();
  /// The next word in this line or a later one; empty at the end of the text.
  MeshToken next();
  /// Skips the rest of the current line and its end. Returns false at the end of the text.
  bool next_line();
  /// The rest of the current line without blanks around it; moves to its end. It may be any text: neither comments nor
  /// continued lines are known here.
  std::string_view rest_of_line();

  std::size_t offset() const { return at_; }

  /// The error "source: line 3, column 7: message".
  InputError error(std::size_t offset, std::string_view message) const;

  /// A finite number. `name` names it in messages: "x". Throws InputError, also for an empty token.
  double number(const MeshToken& token, std::string_view name) const;
  /// A whole number in decimal digits, at most 2^63 - 1 in size. Throws InputError likewise.
  std::int64_t whole(const MeshToken& token, std::string_view name) const;

 private:
  std::size_t line_end() const;
  /// The length of a backslash and the line end after it, in OBJ; else 0.
  std::size_t continuation() const;
  void skip_blanks();

  std::string_view text_;
  const std::string& source_;
  MeshSyntax syntax_;
  std::size_t at_;
};

}  // namespace graze::io
