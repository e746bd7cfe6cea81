// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <ostream>

#include <fmt/format.h>

#include <graze/io/text/printable.hpp>
#include <graze/io/text/table.hpp>

namespace graze::io {
namespace {

constexpr std::string_view bold = "\x1b[1m";
constexpr std::string_view plain = "\x1b[0m";

}  // namespace

void TableWriter::write_row(const TableRow& row) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    const bool is_coloured = colours_ == Colours::on && !row[i].colour.empty();
    if (is_coloured) out_ << row[i].colour;
    out_ << row[i].text;
    if (is_coloured) out_ << plain;
    if (i + 1 == row.size()) continue;
    const std::size_t columns = display_columns(row[i].text);
    out_ << std::string(std::max(widths_[i], columns) + 2 - columns, ' ');
  }
}

void TableWriter::begin() {
  widths_.assign(head_.size(), 0);
  const auto widen = [this](const TableRow& row) {
    for (std::size_t i = 0; i < row.size(); ++i) widths_[i] = std::max(widths_[i], display_columns(row[i].text));
  };
  widen(head_);
  for (const TableRow& row : rows_) widen(row);
  has_begun_ = true;
  if (colours_ == Colours::on) out_ << bold;
  write_row(head_);
  if (colours_ == Colours::on) out_ << plain;
  out_ << '\n';
  for (const TableRow& row : std::exchange(rows_, {})) write(row);
}

void TableWriter::write(TableRow row) {
  if (!has_begun_) {
    rows_.push_back(std::move(row));
    if (rows_.size() == rows_for_widths) begin();
    return;
  }
  write_row(row);
  out_ << '\n';
}

void TableWriter::finish() {
  if (!has_begun_) begin();
}

void write_table(std::ostream& out, const TableRow& head, const std::vector<TableRow>& rows, Colours colours) {
  TableWriter table(out, head, colours);
  for (const TableRow& row : rows) table.write(row);
  table.finish();
}

std::string short_number(double number) { return fmt::format("{:.6g}", number); }

std::string short_numbers(std::span<const double> numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + short_number(number);
  return text;
}

}  // namespace graze::io
