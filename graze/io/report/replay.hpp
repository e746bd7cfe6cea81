// SPDX-License-Identifier: MIT
// The result of replaying a query log, written for people or programs. docs/cli.md documents the formats.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

#include <graze/io/log/query_log.hpp>
#include <graze/io/replay.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

enum class ReplayFormat { table, json };

/// What a report contains in addition to the differences.
struct ReplayHead {
  std::string source;  ///< The log's file name as the user gave it.
  double seconds = 0;  ///< Time of the replay, without reading and writing.
};

/// The last line of a table: "2 of 25 answers differ; 2D float, 0.003 seconds".
template <Dim N>
GRAZE_EXPORT std::string summary_line(const ReplayHead& head, const QueryLog<N>& log, const ReplayReport& report);

/// Writes the result of a replay. A table lists the calls that differ and shows the first of them in full.
template <Dim N>
GRAZE_EXPORT void write_replay(std::ostream& out, ReplayFormat format, const ReplayHead& head, const QueryLog<N>& log,
                               const ReplayReport& report);

}  // namespace graze::io
