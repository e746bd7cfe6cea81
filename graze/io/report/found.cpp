// SPDX-License-Identifier: MIT
#include <ostream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <graze/io/report/found.hpp>
#include <graze/io/text/printable.hpp>
#include <graze/io/text/quoting.hpp>
#include <graze/io/text/table.hpp>

namespace graze::io {
namespace {

std::string_view number_name(FoundDetail detail) {
  if (detail == FoundDetail::distance) return "distance";
  return detail == FoundDetail::contact ? "depth" : "t";
}

bool has_vectors(FoundDetail detail) { return detail != FoundDetail::none && detail != FoundDetail::distance; }

/// "1, 2.5, -3"
std::string listed(const std::vector<double>& numbers, std::string_view separator) {
  return fmt::format("{}", fmt::join(numbers, separator));
}

std::string json_object(const FoundReport& report, const FoundObject& object) {
  std::string text = fmt::format(R"({{"name": {}, "type": "{}")", json_string(object.name), object.type);
  if (report.detail != FoundDetail::none) {
    text += fmt::format(R"(, "{}": {})", number_name(report.detail), object.number);
  }
  if (has_vectors(report.detail)) {
    text += fmt::format(R"(, "point": [{}], "normal": [{}])", listed(object.point, ", "), listed(object.normal, ", "));
  }
  return text + "}";
}

void write_json(std::ostream& out, const FoundReport& report) {
  out << "{\n  \"schema\": \"graze.query/1\",\n  " << json_head(report.head) << ",\n  \"found\": [";
  bool is_first = true;
  for (const FoundObject& object : report.objects) {
    out << (is_first ? "\n    " : ",\n    ") << json_object(report, object);
    is_first = false;
  }
  out << (is_first ? "]" : "\n  ]")
      << fmt::format(",\n  \"summary\": {{\"found\": {}, \"seconds\": {:.6f}}}\n}}\n", report.objects.size(),
                     report.seconds);
}

void write_csv(std::ostream& out, const FoundReport& report) {
  const bool is_flat = report.head.dimension == 2;
  std::string columns = "name,type";
  if (report.detail != FoundDetail::none) columns += fmt::format(",{}", number_name(report.detail));
  if (has_vectors(report.detail)) {
    columns += is_flat ? ",x,y,normal_x,normal_y" : ",x,y,z,normal_x,normal_y,normal_z";
  }
  out << columns << '\n';
  for (const Omission& omission : missing_shapes(report.head.not_read)) out << omission_csv(omission, columns, "type");
  for (const FoundObject& object : report.objects) {
    out << csv_field(object.name) << ',' << object.type;
    if (report.detail != FoundDetail::none) out << fmt::format(",{}", object.number);
    if (has_vectors(report.detail)) out << ',' << listed(object.point, ",") << ',' << listed(object.normal, ",");
    out << '\n';
  }
}

TableRow head_row(FoundDetail detail) {
  if (detail == FoundDetail::none) return {{"NAME"}, {"TYPE"}};
  if (detail == FoundDetail::distance) return {{"NAME"}, {"TYPE"}, {"DISTANCE"}};
  return {{"NAME"}, {"TYPE"}, {detail == FoundDetail::contact ? "DEPTH" : "T"}, {"POINT"}, {"NORMAL"}};
}

TableRow row_of(const FoundReport& report, const FoundObject& object) {
  TableRow row{{printable(object.name)}, {std::string(object.type)}};
  if (report.detail != FoundDetail::none) row.push_back({short_number(object.number)});
  if (!has_vectors(report.detail)) return row;
  row.push_back({short_numbers(object.point)});
  row.push_back({short_numbers(object.normal)});
  return row;
}

void write_table(std::ostream& out, const FoundReport& report, Colours colours) {
  if (!report.objects.empty()) {
    std::vector<TableRow> rows;
    rows.reserve(report.objects.size());
    for (const FoundObject& object : report.objects) rows.push_back(row_of(report, object));
    write_table(out, head_row(report.detail), rows, colours);
    out << '\n';
  }
  for (const Omission& omission : missing_shapes(report.head.not_read)) {
    out << "not read: " << printable(omission_text(omission)) << '\n';
  }
  out << summary_line(report) << '\n';
}

}  // namespace

void write_found(std::ostream& out, ReportFormat format, const FoundReport& report, Colours colours) {
  switch (format) {
    case ReportFormat::json:
      return write_json(out, report);
    case ReportFormat::ndjson:
      for (const Omission& omission : missing_shapes(report.head.not_read)) out << omission_ndjson(omission);
      for (const FoundObject& object : report.objects) out << json_object(report, object) << '\n';
      return;
    case ReportFormat::csv:
      return write_csv(out, report);
    case ReportFormat::table:
      break;
  }
  write_table(out, report, colours);
}

std::string summary_line(const FoundReport& report) {
  return fmt::format("{} found; {} object{}, {:.3f} seconds", report.objects.size(), report.head.objects,
                     report.head.objects == 1 ? "" : "s", report.seconds);
}

}  // namespace graze::io
