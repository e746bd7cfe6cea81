// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace graze::io {

/// One field of a record, unquoted.
struct CsvField {
  std::string_view text;
  std::size_t offset = 0;  ///< Where it begins in the file, its quote included.
};

/// The character that separates the fields of a text, by its first line: whichever of comma, semicolon and tab comes
/// first outside of quotes; a comma where there is none.
char csv_separator(std::string_view text);

/// The text without blanks and tabs around it.
std::string_view without_blanks(std::string_view text);

/// Reads comma-separated values (RFC 4180), or with another separator, record by record, lines ended by CRLF or LF.
/// Blank lines are passed over. Refers to the text given, which must outlive it.
class CsvRecords {
 public:
  /// `source` names the text in messages.
  CsvRecords(std::string_view text, std::string_view source, char separator = ',')
      : text_(text), source_(source), separator_(separator) {}

  /// Goes to the next record; false at the end. Throws InputError where quotes do not match.
  bool next();

  /// The current record's fields; valid until `next`.
  const std::vector<CsvField>& fields() const { return fields_; }

 private:
  void skip_blank_lines();
  void read_field();
  void read_quoted_field();

  std::string_view text_;
  std::string_view source_;
  char separator_;
  std::size_t at_ = 0;
  std::vector<CsvField> fields_;
  std::deque<std::string> unescaped_;  // a deque, because fields_ points into its elements
};

}  // namespace graze::io
