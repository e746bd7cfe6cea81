// SPDX-License-Identifier: MIT
// Any text as a query log: it is rejected with a message, or read; what was read can be written and read again, and its
// replay gives the answers of querying every object.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <variant>

#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/logged_call.hpp>
#include <graze/io/log/query_log.hpp>
#include <graze/io/log/scene_after.hpp>
#include <graze/io/log/side_by_side.hpp>
#include <graze/io/replay.hpp>
#include <graze/io/report/replay.hpp>
#include <graze/io/shrink.hpp>

#include "fuzz/input.hpp"
#include "fuzz/texts.hpp"

using namespace graze;
using test::fuzz::read_again;
using test::fuzz::read_or_refuse;
using test::fuzz::require;

namespace {

constexpr std::size_t most_calls = 64;
constexpr std::size_t most_calls_to_shrink = 6;

template <Dim N>
std::string written(const io::QueryLog<N>& log) {
  std::ostringstream out;
  io::write_query_log(out, log);
  return out.str();
}

template <Dim N>
io::QueryLog<N> parsed(const std::string& text) {
  return std::get<io::QueryLog<N>>(
      read_again(text, [](const std::string& of) { return io::parse_query_log(of, "log"); }));
}

template <Dim N>
bool same_entry(const io::LogEntry<N>& a, const io::LogEntry<N>& b) {
  const auto same_shape = [](const auto& one, const auto& other) {
    return io::bits_of<N>(one) == io::bits_of<N>(other);
  };
  return a.call.kind == b.call.kind &&
         std::equal(a.call.shapes.begin(), a.call.shapes.end(), b.call.shapes.begin(), b.call.shapes.end(),
                    same_shape) &&
         a.answer.has_value() == b.answer.has_value() && (!a.answer || io::say_the_same(*a.answer, *b.answer));
}

template <Dim N>
bool comes_back(const io::QueryLog<N>& log) {
  return std::all_of(log.entries.begin(), log.entries.end(), [](const io::LogEntry<N>& entry) {
    return std::all_of(entry.call.shapes.begin(), entry.call.shapes.end(),
                       [](const AnyShape<N, double>& shape) { return test::fuzz::comes_back<N>(shape); });
  });
}

template <Dim N>
void check_survival(const io::QueryLog<N>& log) {
  const std::string text = written(log);
  const io::QueryLog<N> again = parsed<N>(text);
  if (!comes_back(log)) return;
  require(log.numbers == again.numbers && std::equal(log.entries.begin(), log.entries.end(), again.entries.begin(),
                                                     again.entries.end(), same_entry<N>),
          [&](std::ostream& out) {
            out << "calls and answers must be unchanged after writing and reading, except in\n" << text;
          });
  require(written(again) == text, [&](std::ostream& out) {
    out << "what was read back must be written identically, except\n" << text;
  });
}

template <Dim N>
io::ReplayReport replayed(const io::QueryLog<N>& log) {
  return io::replay(log, io::library_targets<N>(log.numbers));
}

template <Dim N>
void check_replay(const io::QueryLog<N>& log) {
  const io::ReplayReport report = replayed(log);
  for (const io::ReplayDifference& each : report.first) {
    require(!each.is_from_judge, [&](std::ostream& out) {
      out << "the scene must agree with its objects, but does not for " << io::call_line(log.entries[each.entry].call)
          << "\ngiven    " << io::answer_line(each.given) << "\nexpected " << io::answer_line(each.expected) << "\nin\n"
          << written(log);
    });
  }
  std::ostringstream out;
  for (const io::ReplayFormat format : {io::ReplayFormat::table, io::ReplayFormat::json}) {
    io::write_replay(out, format, {"log", 0}, log, report);
  }
  if (log.entries.size() > most_calls_to_shrink) return;
  const std::optional<io::QueryLog<N>> small = io::shrunk(log, io::library_targets<N>(log.numbers));
  require(small.has_value() == (report.differing > 0), [&](std::ostream& stream) {
    stream << "exactly the failing logs can be shrunk, except\n" << written(log);
  });
  if (!small) return;
  const std::string text = written(*small);
  require(replayed(parsed<N>(text)).differing > 0, [&](std::ostream& stream) {
    stream << "the shrunk log must still fail, but does not:\n" << text << "of\n" << written(log);
  });
}

template <Dim N>
void check(const io::QueryLog<N>& log) {
  check_survival(log);
  if (log.entries.size() > most_calls) return;
  check_replay(log);
  const auto scene = read_or_refuse([&] { return io::scene_after(log, "log"); });
  if (!scene) return;
  const std::string text = test::fuzz::written(io::SceneFile{*scene, "log", "graze.log/1", io::YAxis::up, {}});
  const io::SceneFile file = read_again(text, [](const std::string& of) { return io::parse_json_scene(of, "again"); });
  if (!test::fuzz::comes_back(*scene)) return;
  test::fuzz::require_same_scene(*scene, std::get<Scene<N, double>>(file.scene), text);
  test::fuzz::require_survival(file);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = test::fuzz::Input(data, size).rest();
  const auto log = read_or_refuse([&] { return io::parse_query_log(text, "log"); });
  if (log) std::visit([](const auto& read) { check(read); }, *log);
  return 0;
}
