// SPDX-License-Identifier: MIT
// A table of words for people, its columns as wide as their widest word.
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
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

/// Writes the head, bold where there are colours, and the rows; the last column has no blanks behind it.
void write_table(std::ostream& out, const TableRow& head, const std::vector<TableRow>& rows, Colours colours);

/// A number as people read it: six digits.
std::string short_number(double number);

/// "1, 2.5, -3"
std::string short_numbers(std::span<const double> numbers);

}  // namespace graze::io
