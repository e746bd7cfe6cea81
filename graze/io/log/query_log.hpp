// SPDX-License-Identifier: MIT
/// @file
/// The calls on a scene with their results, as newline-delimited JSON for bug reports; docs/query_log.md documents the
/// format. RecordedScene writes logs, `replay` performs them again, `shrunk` reduces them.
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
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

/// The value of "schema" in the logs that this version reads and writes.
inline constexpr std::string_view query_log_schema = "graze.log/1";

/// The number type of a scene.
enum class NumberType : std::uint8_t { single_precision, double_precision };

/// The NumberType of float or double.
template <class T>
inline constexpr NumberType number_type_of = sizeof(T) == sizeof(float) ? NumberType::single_precision
                                                                        : NumberType::double_precision;

/// "float" or "double".
std::string_view name_of(NumberType numbers);

/// A call and its result.
template <Dim N>
struct LogEntry {
  LoggedCall<N> call;                  ///< The call with its arguments.
  std::optional<LoggedAnswer> answer;  ///< None for a last call in which the program ended.
  std::size_t line = 0;                ///< The line of the call in the log; 0 if it was not read from a log.
};

/// All calls on one scene, from its construction. Ids are those that the scene returned, with the owners
/// `logged_scene` and `other_scene`.
template <Dim N>
struct QueryLog {
  NumberType numbers = NumberType::double_precision;  ///< The number type of the scene.
  std::vector<LogEntry<N>> entries;                   ///< In the order of the calls.
};

/// A log of a 2D or a 3D scene.
using AnyQueryLog = std::variant<QueryLog<2>, QueryLog<3>>;

/// The first line of a log, without the newline.
std::string log_head(Dim dimension, NumberType numbers);

/// Reads a log; messages name it `source`. Throws InputError with the line if the text is not a log or has a newer
/// version, if a call is unknown, if arguments are invalid or do not fit the call, or if a call succeeded although it
/// uses an id that no earlier line returned.
GRAZE_EXPORT AnyQueryLog parse_query_log(std::string_view text, const std::string& source);

/// Writes a log; numbers survive the round trip bit for bit. Throws OutputError as `call_line` does. The caller checks
/// the state of `out`.
template <Dim N>
GRAZE_EXPORT void write_query_log(std::ostream& out, const QueryLog<N>& log);

}  // namespace graze::io
