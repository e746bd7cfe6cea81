// SPDX-License-Identifier: MIT
// A text table for display, with columns as wide as their widest cell.
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

/// A table cell, already `printable`, and the terminal code of its colour, if it has one.
struct TableCell {
  std::string text;
  std::string_view colour = {};
};

/// A row has one cell for every column.
using TableRow = std::vector<TableCell>;

/// Writes rows as they arrive. The header and the first `rows_for_widths` rows determine the column widths; these rows
/// are buffered until then or until `finish`. A wider cell in a later row shifts the rest of its row.
class TableWriter {
 public:
  static constexpr std::size_t rows_for_widths = 10'000;

  /// `out` must outlive the writer.
  TableWriter(std::ostream& out, TableRow head, Colours colours)
      : out_(out), head_(std::move(head)), colours_(colours) {}

  void write(TableRow row);

  /// Call once, after the last row.
  void finish();

  /// Whether there was no row.
  bool is_empty() const { return !has_begun_ && rows_.empty(); }

 private:
  void begin();
  void write_row(const TableRow& row);

  std::ostream& out_;
  TableRow head_;
  Colours colours_;
  std::vector<TableRow> rows_;       // buffered rows
  std::vector<std::size_t> widths_;  // set when buffering ends
  bool has_begun_ = false;
};

/// Writes the header, bold with colours, and the rows; no blanks after the last column.
void write_table(std::ostream& out, const TableRow& head, const std::vector<TableRow>& rows, Colours colours);

/// A number for display: six significant digits.
std::string short_number(double number);

/// "1, 2.5, -3"
std::string short_numbers(std::span<const double> numbers);

}  // namespace graze::io
