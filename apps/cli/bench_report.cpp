// SPDX-License-Identifier: MIT
#include "bench_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <graze/io/text/printable.hpp>

namespace graze::cli {
namespace {

using Json = nlohmann::ordered_json;

double median(std::vector<double> numbers) {
  if (numbers.empty()) return 0;
  std::sort(numbers.begin(), numbers.end());
  return (numbers[(numbers.size() - 1) / 2] + numbers[numbers.size() / 2]) / 2;
}

/// The results of a method, as shown in every format.
struct Row {
  std::string_view method;
  std::string_view chosen;
  double median;
  double fastest;
  double slowest;
  std::size_t pairs;  ///< The mean over all frames, rounded.
  std::size_t bytes;
  std::optional<double> per_box;   ///< Nanoseconds; none without boxes.
  std::optional<double> to_floor;  ///< None if the floor is too short to measure.
};

std::size_t mean_pairs(const BenchReport& report) {
  std::size_t sum = 0;
  for (const std::size_t pairs : report.pairs) sum += pairs;
  const std::size_t frames = std::max<std::size_t>(1, report.pairs.size());
  return (sum + frames / 2) / frames;
}

std::vector<Row> rows_of(const BenchReport& report) {
  const double floor = median(report.floor);
  std::vector<Row> rows;
  for (const MethodResult& result : report.methods) {
    const double middle = median(result.milliseconds);
    const auto [fastest, slowest] = std::minmax_element(result.milliseconds.begin(), result.milliseconds.end());
    Row row{result.method, result.chosen, middle, *fastest, *slowest, mean_pairs(report), result.bytes, {}, {}};
    if (report.boxes > 0) row.per_box = middle * 1e6 / static_cast<double>(report.boxes);
    if (floor > 0) row.to_floor = middle / floor;
    rows.push_back(row);
  }
  return rows;
}

std::string counted(std::size_t count, std::string_view noun, std::string_view plural) {
  return fmt::format("{} {}", count, count == 1 ? noun : plural);
}

/// The line above the table.
std::string title_of(const BenchReport& report) {
  const std::string seed = report.seed ? fmt::format(", seed {}", *report.seed) : "";
  return fmt::format("{}{}: {}D {}, {}, {}, order {}, {}", io::printable(report.source), seed, report.dimension,
                     report.scalar, counted(report.boxes, "box", "boxes"), counted(report.frames, "frame", "frames"),
                     report.order, counted(report.threads, "thread", "threads"));
}

/// A number with the given number of decimals, or a dash.
std::string number(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

using Cells = std::array<std::string, 9>;

Cells cells_of(const Row& row) {
  return {std::string(row.method),      std::string(row.chosen), number(row.median, 3),
          number(row.fastest, 3),       number(row.slowest, 3),  fmt::format("{}", row.pairs),
          fmt::format("{}", row.bytes), number(row.per_box, 1),  number(row.to_floor, 1)};
}

/// Words are left-aligned, numbers right-aligned.
void write_line(std::ostream& out, const Cells& cells, const std::array<std::size_t, 9>& columns) {
  constexpr std::size_t words = 2;
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) line += "  ";
    line += i < words ? fmt::format("{:<{}}", cells[i], columns[i]) : fmt::format("{:>{}}", cells[i], columns[i]);
  }
  out << line;
}

void write_table(std::ostream& out, const BenchReport& report, io::Colours colours) {
  const Cells head{"METHOD", "CHOSEN", "MEDIAN ms", "FASTEST ms", "SLOWEST ms",
                   "PAIRS",  "BYTES",  "ns/BOX",    "TIMES FLOOR"};
  std::vector<Cells> lines;
  for (const Row& row : rows_of(report)) lines.push_back(cells_of(row));
  std::array<std::size_t, 9> columns{};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    columns[i] = head[i].size();
    for (const Cells& cells : lines) columns[i] = std::max(columns[i], cells[i].size());
  }
  const bool coloured = colours == io::Colours::on;
  out << title_of(report) << "\n\n" << (coloured ? "\x1b[1m" : "");
  write_line(out, head, columns);
  out << (coloured ? "\x1b[0m" : "") << '\n';
  for (const Cells& cells : lines) {
    write_line(out, cells, columns);
    out << '\n';
  }
  out << fmt::format("\nfloor: {:.3f} ms to read the boxes and write the pairs once, on one thread\n",
                     median(report.floor));
}

void write_csv(std::ostream& out, const BenchReport& report) {
  out << "method,chosen,median_ms,fastest_ms,slowest_ms,pairs,bytes,ns_per_box,floor_ms,times_floor\n";
  const auto or_nothing = [](const std::optional<double>& value) { return value ? number(value, 3) : std::string(); };
  for (const Row& row : rows_of(report)) {
    out << fmt::format("{},{},{:.6f},{:.6f},{:.6f},{},{},{},{:.6f},{}\n", row.method, row.chosen, row.median,
                       row.fastest, row.slowest, row.pairs, row.bytes, or_nothing(row.per_box), median(report.floor),
                       or_nothing(row.to_floor));
  }
}

/// Rounded to a millionth: of milliseconds that is a nanosecond.
double rounded(double value) { return std::round(value * 1e6) / 1e6; }

Json rounded(const std::optional<double>& value) { return value ? Json(rounded(*value)) : Json(nullptr); }

Json json_methods(const BenchReport& report) {
  Json methods = Json::array();
  const std::vector<Row> rows = rows_of(report);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Json times = Json::array();
    for (const double time : report.methods[i].milliseconds) times.push_back(rounded(time));
    methods.push_back({{"method", rows[i].method},
                       {"chosen", rows[i].chosen},
                       {"median_ms", rounded(rows[i].median)},
                       {"fastest_ms", rounded(rows[i].fastest)},
                       {"slowest_ms", rounded(rows[i].slowest)},
                       {"pairs", rows[i].pairs},
                       {"bytes", rows[i].bytes},
                       {"ns_per_box", rounded(rows[i].per_box)},
                       {"times_floor", rounded(rows[i].to_floor)},
                       {"frames_ms", times}});
  }
  return methods;
}

void write_json(std::ostream& out, const BenchReport& report) {
  Json skipped = Json::array();
  for (const SkippedMethod& one : report.skipped) skipped.push_back({{"method", one.method}, {"reason", one.reason}});
  const Json document = {{"schema", "graze.bench/1"},
                         {"source", report.source},
                         {"seed", report.seed ? Json(*report.seed) : Json(nullptr)},
                         {"dimension", report.dimension},
                         {"scalar", report.scalar},
                         {"boxes", report.boxes},
                         {"frames", report.frames},
                         {"order", report.order},
                         {"threads", report.threads},
                         {"pairs", report.pairs},
                         {"floor_ms", rounded(median(report.floor))},
                         {"methods", json_methods(report)},
                         {"skipped", skipped}};
  out << document.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace

void write_bench_report(std::ostream& out, BenchFormat format, const BenchReport& report, io::Colours colours) {
  if (format == BenchFormat::table) write_table(out, report, colours);
  if (format == BenchFormat::json) write_json(out, report);
  if (format == BenchFormat::csv) write_csv(out, report);
}

}  // namespace graze::cli
