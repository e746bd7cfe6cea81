// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <ostream>

#include <fmt/format.h>

#include <graze/io/printable.hpp>
#include <graze/io/text_table.hpp>

namespace graze::io {
namespace {

constexpr std::string_view bold = "\x1b[1m";
constexpr std::string_view plain = "\x1b[0m";

void write_row(std::ostream& out, const TableRow& row, const std::vector<std::size_t>& widths, Colours colours) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    const bool is_coloured = colours == Colours::on && !row[i].colour.empty();
    if (is_coloured) out << row[i].colour;
    out << row[i].text;
    if (is_coloured) out << plain;
    if (i + 1 < row.size()) out << std::string(widths[i] + 2 - display_columns(row[i].text), ' ');
  }
}

}  // namespace

void write_table(std::ostream& out, const TableRow& head, const std::vector<TableRow>& rows, Colours colours) {
  std::vector<std::size_t> widths(head.size(), 0);
  const auto widen = [&widths](const TableRow& row) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], display_columns(row[i].text));
  };
  widen(head);
  for (const TableRow& row : rows) widen(row);
  if (colours == Colours::on) out << bold;
  write_row(out, head, widths, colours);
  if (colours == Colours::on) out << plain;
  out << '\n';
  for (const TableRow& row : rows) {
    write_row(out, row, widths, colours);
    out << '\n';
  }
}

std::string short_number(double number) { return fmt::format("{:.6g}", number); }

std::string short_numbers(std::span<const double> numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + short_number(number);
  return text;
}

}  // namespace graze::io
