// SPDX-License-Identifier: MIT
// What the replay of a query log found, written for people or for programs. The formats are documented in docs/cli.md.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

#include <graze/io/log/query_log.hpp>
#include <graze/io/replay.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

enum class ReplayFormat { table, json };

/// What is written of a replay beside its report.
struct ReplayHead {
  std::string source;  ///< The log's name as the user gave it.
  double seconds = 0;  ///< To replay it, without reading and writing.
};

/// The sentence that closes a table: "2 of 25 answers differ; 2D float, 0.003 seconds".
template <Dim N>
std::string summary_line(const ReplayHead& head, const QueryLog<N>& log, const ReplayReport& report);

/// Writes what a replay of the log found; as a table the calls that differ, and the first of them in full.
template <Dim N>
void write_replay(std::ostream& out, ReplayFormat format, const ReplayHead& head, const QueryLog<N>& log,
                  const ReplayReport& report);

}  // namespace graze::io
