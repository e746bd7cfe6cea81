// SPDX-License-Identifier: MIT
// A table of words for people, its columns as wide as their widest word.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace graze::io {

/// Whether text is coloured with terminal codes.
enum class Colours { off, on };

/// A word of a table, fit to be shown (see `printable`), and the terminal code of its colour, if it has one.
struct TableCell {
  std::string text;
  std::string_view colour = {};
};

/// A row of a table has a cell for every column.
using TableRow = std::vector<TableCell>;

/// Writes rows as they come. Columns are as wide as the head and the first `rows_for_widths` rows need; these are held
/// until there are so many, or `finish`, the others are not, and a wider word of theirs moves what is behind it.
class TableWriter {
 public:
  static constexpr std::size_t rows_for_widths = 10'000;

  /// `out` must outlive the writer.
  TableWriter(std::ostream& out, TableRow head, Colours colours)
      : out_(out), head_(std::move(head)), colours_(colours) {}

  void write(TableRow row);

  /// To be called once, after the last row.
  void finish();

  /// Whether there was no row.
  bool is_empty() const { return !has_begun_ && rows_.empty(); }

 private:
  void begin();
  void write_row(const TableRow& row);

  std::ostream& out_;
  TableRow head_;
  Colours colours_;
  std::vector<TableRow> rows_;       // until they are enough
  std::vector<std::size_t> widths_;  // from then on
  bool has_begun_ = false;
};

/// Writes the head, bold where there are colours, and the rows; the last column has no blanks behind it.
void write_table(std::ostream& out, const TableRow& head, const std::vector<TableRow>& rows, Colours colours);

/// A number as people read it: six digits.
std::string short_number(double number);

/// "1, 2.5, -3"
std::string short_numbers(std::span<const double> numbers);

}  // namespace graze::io
