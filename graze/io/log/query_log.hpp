// SPDX-License-Identifier: MIT
// The calls on a scene and what it answered, as newline-delimited JSON that a bug report can carry; the format is
// documented in docs/query_log.md. RecordedScene writes logs, replay performs them again, shrunk makes them small.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/logged_call.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

/// What "schema" says in the logs that this version reads and writes.
inline constexpr std::string_view query_log_schema = "graze.log/1";

/// The type that a scene keeps its numbers in.
enum class NumberType : std::uint8_t { single_precision, double_precision };

template <class T>
inline constexpr NumberType number_type_of = sizeof(T) == sizeof(float) ? NumberType::single_precision
                                                                        : NumberType::double_precision;

/// "float" or "double"
std::string_view name_of(NumberType numbers);

/// A call and what came of it.
template <Dim N>
struct LogEntry {
  LoggedCall<N> call;
  std::optional<LoggedAnswer> answer;  ///< None for the last call of a program that did not survive it.
  std::size_t line = 0;                ///< Of the call in the log; 0 if it was not read.
};

/// Everything that happened to one scene, from its beginning. Ids are those that the scene gave, with owners as
/// logged_call.hpp has them.
template <Dim N>
struct QueryLog {
  NumberType numbers = NumberType::double_precision;
  std::vector<LogEntry<N>> entries;
};

using AnyQueryLog = std::variant<QueryLog<2>, QueryLog<3>>;

/// The first line of a log, without an end of line.
std::string log_head(Dim dimension, NumberType numbers);

/// Reads a log. `source` names it in messages. Throws InputError, which names the line, for what is no log or one of a
/// newer version, a call that is not known, arguments that are no valid shapes or do not fit the call, and calls that
/// were answered although they name ids that no line before gave out.
AnyQueryLog parse_query_log(std::string_view text, const std::string& source);

/// Writes a log: numbers survive the round trip bit for bit. Throws OutputError like `call_line`. The state of `out` is
/// the caller's to check.
template <Dim N>
void write_query_log(std::ostream& out, const QueryLog<N>& log);

}  // namespace graze::io
