// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <graze/io/report/check.hpp>
#include <graze/io/text/printable.hpp>
#include <graze/io/text/quoting.hpp>

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

/// The names that the JavaScript module uses.
std::string_view status_name(Status status) { return status == Status::converged ? "converged" : "best_bound"; }

/// The penetration depth of two objects: that of their deepest contact.
double depth_of(const ReportedPair& pair) {
  double depth = 0;
  for (const ReportedContact& contact : pair.contacts) depth = std::max(depth, contact.depth);
  return depth;
}

/// JSON cannot represent infinity.
std::string json_number(double number) { return std::isfinite(number) ? fmt::format("{}", number) : "null"; }

std::string json_contacts(const ReportedPair& pair) {
  std::string text = fmt::format(R"(, "depth": {}, "normal": [{}], "contacts": [)", json_number(depth_of(pair)),
                                 fmt::join(pair.normal, ", "));
  for (std::size_t i = 0; i < pair.contacts.size(); ++i) {
    text += fmt::format(R"({}{{"point": [{}], "depth": {}}})", i == 0 ? "" : ", ",
                        fmt::join(pair.contacts[i].point, ", "), json_number(pair.contacts[i].depth));
  }
  return text + "]";
}

std::string json_pair(const ReportedPair& pair, PairDetail detail) {
  std::string text = fmt::format(R"({{"a": {}, "b": {}, "relation": "{}")", json_string(pair.a), json_string(pair.b),
                                 relation_name(pair.relation));
  if (detail == PairDetail::distance) text += fmt::format(R"(, "distance": {})", json_number(pair.distance));
  if (detail == PairDetail::contacts) text += json_contacts(pair);
  if (detail != PairDetail::none) {
    text += fmt::format(R"(, "status": "{}", "error": {})", status_name(pair.status), json_number(pair.error));
  }
  return text + "}";
}

class JsonReport final : public ReportWriter {
 public:
  JsonReport(std::ostream& out, const ReportHead& head) : out_(out), detail_(head.detail) {
    out_ << "{\n  \"schema\": \"graze.check/1\",\n  " << json_head(head) << ",\n  \"pairs\": [";
  }

  void write(const ReportedPair& pair) override {
    out_ << (first_ ? "\n    " : ",\n    ") << json_pair(pair, detail_);
    first_ = false;
  }

  void finish(const ReportSummary& summary) override {
    out_ << (first_ ? "]" : "\n  ]")
         << fmt::format(",\n  \"summary\": {{\"pairs\": {}, \"candidates\": {}, \"seconds\": {:.6f}}}\n}}\n",
                        summary.pairs, summary.candidates, summary.seconds);
  }

 private:
  std::ostream& out_;
  PairDetail detail_;
  bool first_ = true;
};

class NdjsonReport final : public ReportWriter {
 public:
  NdjsonReport(std::ostream& out, const ReportHead& head) : out_(out), detail_(head.detail) {
    for (const Omission& omission : missing_shapes(head.not_read)) out_ << omission_ndjson(omission);
  }

  void write(const ReportedPair& pair) override { out_ << json_pair(pair, detail_) << '\n'; }
  void finish(const ReportSummary&) override {}

 private:
  std::ostream& out_;
  PairDetail detail_;
};

class CsvReport final : public ReportWriter {
 public:
  CsvReport(std::ostream& out, const ReportHead& head) : out_(out), detail_(head.detail) {
    std::string columns = "a,b,relation";
    if (detail_ == PairDetail::distance) columns += ",distance";
    if (detail_ == PairDetail::contacts) {
      columns += head.dimension == 2 ? ",depth,x,y,normal_x,normal_y" : ",depth,x,y,z,normal_x,normal_y,normal_z";
    }
    if (detail_ != PairDetail::none) columns += ",status,error";
    out_ << columns << '\n';
    for (const Omission& omission : missing_shapes(head.not_read)) out_ << omission_csv(omission, columns, "relation");
  }

  void write(const ReportedPair& pair) override {
    const std::string names =
        fmt::format("{},{},{}", csv_field(pair.a), csv_field(pair.b), relation_name(pair.relation));
    if (detail_ == PairDetail::none) out_ << names << '\n';
    const std::string end = fmt::format("{},{}\n", status_name(pair.status), pair.error);
    if (detail_ == PairDetail::distance) out_ << fmt::format("{},{},{}", names, pair.distance, end);
    if (detail_ != PairDetail::contacts) return;
    for (const ReportedContact& contact : pair.contacts) {
      out_ << fmt::format("{},{},{},{},{}", names, contact.depth, fmt::join(contact.point, ","),
                          fmt::join(pair.normal, ","), end);
    }
  }
  void finish(const ReportSummary&) override {}

 private:
  std::ostream& out_;
  PairDetail detail_;
};

/// People with colour blindness can tell cyan from yellow.
std::string_view colour_of(Relation relation) {
  if (relation == Relation::apart) return "";
  return relation == Relation::overlapping ? "\x1b[33m" : "\x1b[36m";
}

/// A distance or depth as shown in a table.
std::string measured(double number, const ReportedPair& pair) {
  if (pair.status == Status::converged) return short_number(number);
  return fmt::format("{} +- {}", short_number(number), short_number(pair.error));
}

class TableReport final : public ReportWriter {
 public:
  TableReport(std::ostream& out, ReportHead head, Colours colours)
      : out_(out), head_(std::move(head)), table_(out, columns_of(head_.detail), colours) {}

  void write(const ReportedPair& pair) override {
    TableRow row{{printable(pair.a)},
                 {printable(pair.b)},
                 {std::string(relation_name(pair.relation)), colour_of(pair.relation)}};
    if (head_.detail == PairDetail::distance) row.push_back({measured(pair.distance, pair)});
    if (head_.detail != PairDetail::contacts) return table_.write(std::move(row));
    for (const ReportedContact& contact : pair.contacts) {
      TableRow whole = row;
      whole.push_back({measured(contact.depth, pair)});
      whole.push_back({short_numbers(contact.point)});
      whole.push_back({short_numbers(pair.normal)});
      table_.write(std::move(whole));
    }
  }

  void finish(const ReportSummary& summary) override {
    if (!table_.is_empty()) {
      table_.finish();
      out_ << '\n';
    }
    for (const Omission& omission : missing_shapes(head_.not_read)) {
      out_ << "not read: " << printable(omission_text(omission)) << '\n';
    }
    out_ << summary_line(head_, summary) << '\n';
  }

 private:
  static TableRow columns_of(PairDetail detail) {
    TableRow columns{{"A"}, {"B"}, {"RELATION"}};
    if (detail == PairDetail::distance) columns.push_back({"DISTANCE"});
    if (detail == PairDetail::contacts) columns.insert(columns.end(), {{"DEPTH"}, {"POINT"}, {"NORMAL"}});
    return columns;
  }

  std::ostream& out_;
  ReportHead head_;
  TableWriter table_;
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
      return std::make_unique<NdjsonReport>(out, head);
    case ReportFormat::csv:
      return std::make_unique<CsvReport>(out, head);
    case ReportFormat::table:
      break;
  }
  return std::make_unique<TableReport>(out, head, colours);
}

std::string json_head(const ReportHead& head) {
  return fmt::format("\"scene\": {},\n  \"dimension\": {},\n  \"objects\": {},\n  \"not_read\": {}",
                     json_string(head.source), head.dimension, head.objects, omissions_json(head.not_read));
}

std::string summary_line(const ReportHead& head, const ReportSummary& summary) {
  const std::string open = summary.not_converged == 0 ? "" : fmt::format(", {} not converged", summary.not_converged);
  return fmt::format("{}{}; {}, {}, {:.3f} seconds", counted(summary.pairs, "pair"), open,
                     counted(head.objects, "object"), counted(summary.candidates, "candidate"), summary.seconds);
}

}  // namespace graze::io
