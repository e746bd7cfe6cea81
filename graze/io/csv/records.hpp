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
  std::size_t offset = 0;  ///< Its position in the file, including the opening quote.
};

/// The separator of a text's fields, by its first line: whichever of comma, semicolon and tab occurs first outside
/// quotes; a comma if there is none.
char csv_separator(std::string_view text);

/// The text without leading and trailing blanks and tabs.
std::string_view without_blanks(std::string_view text);

/// Reads comma-separated values (RFC 4180), or with another separator, record by record, lines ended by CRLF or LF.
/// Blank lines are skipped. Refers to the given text, which must outlive this.
class CsvRecords {
 public:
  /// `source` names the text in messages.
  CsvRecords(std::string_view text, std::string_view source, char separator = ',')
      : text_(text), source_(source), separator_(separator) {}

  /// Moves to the next record; false at the end. Throws InputError for unmatched quotes.
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
