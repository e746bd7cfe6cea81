// SPDX-License-Identifier: MIT
#include <ostream>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <graze/io/report/replay.hpp>
#include <graze/io/text/printable.hpp>
#include <graze/io/text/quoting.hpp>
#include <graze/io/text/table.hpp>

namespace graze::io {
namespace {

std::string_view from_whom(const ReplayDifference& difference) {
  if (!difference.is_from_judge) return "the log";
  return difference.is_from_record ? "the log and brute force" : "brute force";
}

template <Dim N>
std::string json_difference(const ReplayDifference& difference, const LogEntry<N>& entry) {
  std::string text =
      fmt::format(R"({{"line": {}, "call": {}, "given": {}, "brute_force": {})", entry.line, call_line(entry.call),
                  answer_line(difference.given), answer_line(difference.expected));
  if (difference.recorded) text += fmt::format(R"(, "log": {})", answer_line(*difference.recorded));
  return text + fmt::format(R"(, "differs_from_brute_force": {}, "differs_from_log": {}}})", difference.is_from_judge,
                            difference.is_from_record);
}

template <Dim N>
void write_json(std::ostream& out, const ReplayHead& head, const QueryLog<N>& log, const ReplayReport& report) {
  out << fmt::format(
      "{{\n  \"schema\": \"graze.replay/1\",\n  \"log\": {},\n  \"dimension\": {},\n  \"numbers\": \"{}\",\n  "
      "\"differences\": [",
      json_string(head.source), N, name_of(log.numbers));
  bool is_first = true;
  for (const ReplayDifference& each : report.first) {
    out << (is_first ? "\n    " : ",\n    ") << json_difference(each, log.entries[each.entry]);
    is_first = false;
  }
  out << (is_first ? "]" : "\n  ]")
      << fmt::format(",\n  \"summary\": {{\"calls\": {}, \"differing\": {}, \"seconds\": {:.6f}}}\n}}\n", report.calls,
                     report.differing, head.seconds);
}

template <Dim N>
void write_first(std::ostream& out, const ReplayDifference& difference, const LogEntry<N>& entry) {
  out << fmt::format("line {}: {}\n", entry.line, printable(call_line(entry.call)));
  out << "  given        " << printable(answer_line(difference.given)) << '\n';
  out << "  brute force  " << printable(answer_line(difference.expected)) << '\n';
  if (difference.recorded) out << "  the log      " << printable(answer_line(*difference.recorded)) << '\n';
}

template <Dim N>
void write_as_table(std::ostream& out, const ReplayHead& head, const QueryLog<N>& log, const ReplayReport& report) {
  if (!report.first.empty()) {
    std::vector<TableRow> rows;
    for (const ReplayDifference& each : report.first) {
      const LogEntry<N>& entry = log.entries[each.entry];
      rows.push_back({{fmt::format("{}", entry.line)},
                      {std::string(form_of(entry.call.kind).name)},
                      {std::string(from_whom(each))}});
    }
    write_table(out, {{"LINE"}, {"CALL"}, {"DIFFERS FROM"}}, rows, Colours::off);
    out << '\n';
    write_first(out, report.first.front(), log.entries[report.first.front().entry]);
    out << '\n';
  }
  out << summary_line(head, log, report) << '\n';
}

}  // namespace

template <Dim N>
std::string summary_line(const ReplayHead& head, const QueryLog<N>& log, const ReplayReport& report) {
  const std::string differing = report.differing == 0 ? "none" : fmt::format("{}", report.differing);
  return fmt::format("{} of {} answer{} differ{}; {}D {}, {:.3f} seconds", differing, report.calls,
                     report.calls == 1 ? "" : "s", report.differing == 1 ? "s" : "", N, name_of(log.numbers),
                     head.seconds);
}

template <Dim N>
void write_replay(std::ostream& out, ReplayFormat format, const ReplayHead& head, const QueryLog<N>& log,
                  const ReplayReport& report) {
  if (format == ReplayFormat::json) return write_json(out, head, log, report);
  write_as_table(out, head, log, report);
}

template std::string summary_line(const ReplayHead&, const QueryLog<2>&, const ReplayReport&);
template std::string summary_line(const ReplayHead&, const QueryLog<3>&, const ReplayReport&);
template void write_replay(std::ostream&, ReplayFormat, const ReplayHead&, const QueryLog<2>&, const ReplayReport&);
template void write_replay(std::ostream&, ReplayFormat, const ReplayHead&, const QueryLog<3>&, const ReplayReport&);

}  // namespace graze::io
