// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/printable.hpp>
#include <graze/io/quoting.hpp>
#include <graze/io/report.hpp>

namespace graze::io {
namespace {

std::string_view relation_name(Relation relation) {
  switch (relation) {
    case Relation::apart:
      return "apart";
    case Relation::touching:
      return "touching";
    case Relation::overlapping:
      break;
  }
  return "overlapping";
}

std::string json_pair(const ReportedPair& pair) {
  return fmt::format(R"({{"a": {}, "b": {}, "relation": "{}"}})", json_string(pair.a), json_string(pair.b),
                     relation_name(pair.relation));
}

class JsonReport final : public ReportWriter {
 public:
  JsonReport(std::ostream& out, const ReportHead& head) : out_(out) {
    out_ << fmt::format(
        "{{\n  \"schema\": \"graze.check/1\",\n  \"scene\": {},\n  \"dimension\": {},\n  \"objects\": {},\n  "
        "\"pairs\": [",
        json_string(head.source), head.dimension, head.objects);
  }

  void write(const ReportedPair& pair) override {
    out_ << (first_ ? "\n    " : ",\n    ") << json_pair(pair);
    first_ = false;
  }

  void finish(const ReportSummary& summary) override {
    out_ << (first_ ? "]" : "\n  ]")
         << fmt::format(",\n  \"summary\": {{\"pairs\": {}, \"candidates\": {}, \"seconds\": {:.6f}}}\n}}\n",
                        summary.pairs, summary.candidates, summary.seconds);
  }

 private:
  std::ostream& out_;
  bool first_ = true;
};

class NdjsonReport final : public ReportWriter {
 public:
  explicit NdjsonReport(std::ostream& out) : out_(out) {}

  void write(const ReportedPair& pair) override { out_ << json_pair(pair) << '\n'; }
  void finish(const ReportSummary&) override {}

 private:
  std::ostream& out_;
};

class CsvReport final : public ReportWriter {
 public:
  explicit CsvReport(std::ostream& out) : out_(out) { out_ << "a,b,relation\n"; }

  void write(const ReportedPair& pair) override {
    out_ << csv_field(pair.a) << ',' << csv_field(pair.b) << ',' << relation_name(pair.relation) << '\n';
  }
  void finish(const ReportSummary&) override {}

 private:
  std::ostream& out_;
};

/// Bold for the head; cyan and yellow are told apart by the colour-blind as well.
struct Palette {
  std::string_view head;
  std::string_view touching;
  std::string_view overlapping;
  std::string_view end;
};

constexpr Palette no_colours{};
constexpr Palette terminal_colours{"\x1b[1m", "\x1b[36m", "\x1b[33m", "\x1b[0m"};

class TableReport final : public ReportWriter {
 public:
  TableReport(std::ostream& out, ReportHead head, const Palette& palette)
      : out_(out), head_(std::move(head)), palette_(palette) {}

  void write(const ReportedPair& pair) override { pairs_.push_back(pair); }

  void finish(const ReportSummary& summary) override {
    if (!pairs_.empty()) write_rows();
    out_ << summary_line(head_, summary) << '\n';
  }

 private:
  void write_rows() {
    std::size_t width_a = 1;
    std::size_t width_b = 1;
    for (const ReportedPair& pair : pairs_) {
      width_a = std::max(width_a, display_columns(printable(pair.a)));
      width_b = std::max(width_b, display_columns(printable(pair.b)));
    }
    out_ << palette_.head << padded("A", width_a) << padded("B", width_b) << "RELATION" << palette_.end << '\n';
    for (const ReportedPair& pair : pairs_) {
      const bool overlaps = pair.relation == Relation::overlapping;
      out_ << padded(printable(pair.a), width_a) << padded(printable(pair.b), width_b)
           << (overlaps ? palette_.overlapping : palette_.touching) << relation_name(pair.relation) << palette_.end
           << '\n';
    }
    out_ << '\n';
  }

  static std::string padded(std::string text, std::size_t width) {
    text.append(width + 2 - display_columns(text), ' ');
    return text;
  }

  std::ostream& out_;
  ReportHead head_;
  const Palette& palette_;
  std::vector<ReportedPair> pairs_;
};

std::string counted(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace

std::unique_ptr<ReportWriter> begin_report(std::ostream& out, ReportFormat format, const ReportHead& head,
                                           Colours colours) {
  switch (format) {
    case ReportFormat::json:
      return std::make_unique<JsonReport>(out, head);
    case ReportFormat::ndjson:
      return std::make_unique<NdjsonReport>(out);
    case ReportFormat::csv:
      return std::make_unique<CsvReport>(out);
    case ReportFormat::table:
      break;
  }
  return std::make_unique<TableReport>(out, head, colours == Colours::on ? terminal_colours : no_colours);
}

std::string summary_line(const ReportHead& head, const ReportSummary& summary) {
  return fmt::format("{}; {}, {}, {:.3f} seconds", counted(summary.pairs, "pair"), counted(head.objects, "object"),
                     counted(summary.candidates, "candidate"), summary.seconds);
}

}  // namespace graze::io
