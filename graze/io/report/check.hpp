// SPDX-License-Identifier: MIT
// The result of checking a scene, written for people or programs. docs/cli.md documents the formats.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <graze/io/omission.hpp>
#include <graze/io/text/table.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/status.hpp>

namespace graze::io {

enum class ReportFormat { table, json, ndjson, csv };

/// What is reported for each pair in addition to its relation.
enum class PairDetail {
  none,
  contacts,  ///< Normal, depth and position of contacts.
  distance,
};

/// What is known before the first pair.
struct ReportHead {
  std::string source;
  Dim dimension = 2;
  std::size_t objects = 0;
  PairDetail detail = PairDetail::none;
  std::vector<Omission> not_read = {};
};

/// A point at which two objects touch, and their depth there; infinite if no translation separates them.
struct ReportedContact {
  std::vector<double> point;
  double depth = 0;
};

/// Two objects by name. Vectors have as many coordinates as the scene has dimensions.
struct ReportedPair {
  std::string_view a;
  std::string_view b;
  Relation relation = Relation::touching;
  double distance = 0;                         ///< For PairDetail::distance.
  std::vector<double> normal = {};             ///< For PairDetail::contacts: from a to b, or zero.
  std::vector<ReportedContact> contacts = {};  ///< For PairDetail::contacts: at least one.
  Status status = Status::converged;           ///< How the search for the distance or depth ended.
  double error = 0;                            ///< Bound on the error of the distance or depth.
};

/// What is known after the last pair.
struct ReportSummary {
  std::size_t pairs = 0;          ///< Pairs reported.
  std::size_t candidates = 0;     ///< Pairs whose boxes overlap, and which were therefore tested exactly.
  double seconds = 0;             ///< Time of the search, without reading and writing.
  std::size_t not_converged = 0;  ///< Number of reported pairs without convergence.
};

/// Writes one report: call `write` for every pair in order, then `finish` once. Pairs are written as they arrive and
/// not stored; only a table buffers the first ones to find its column widths. Tables and CSV have one row for each
/// contact. Names are quoted or escaped as the format requires, whatever bytes they contain. Numbers are the shortest
/// that parse to the same value, except in tables. If more than the relation is reported, JSON and CSV always include
/// status and error; a table shows the error only where the search did not converge. What was not read of the scene is
/// a field in JSON; if shapes are missing because of it, NDJSON and CSV begin with lines or rows that say so, and a
/// table has a line above the summary. Virtual because the format is chosen at run time; one virtual call is nothing
/// compared to the test of a pair.
class ReportWriter {
 public:
  virtual ~ReportWriter() = default;
  virtual void write(const ReportedPair& pair) = 0;
  virtual void finish(const ReportSummary& summary) = 0;

 protected:
  ReportWriter() = default;
  ReportWriter(const ReportWriter&) = delete;
  ReportWriter& operator=(const ReportWriter&) = delete;
};

/// Begins a report on `out`, which must outlive the writer. Only tables use colours.
GRAZE_EXPORT std::unique_ptr<ReportWriter> begin_report(std::ostream& out, ReportFormat format, const ReportHead& head,
                                                        Colours colours = Colours::off);

/// The header fields of a JSON document, each but the first on its own line.
std::string json_head(const ReportHead& head);

/// The last line of a table: "2 pairs; 5 objects, 3 candidates, 0.001 seconds", or "2 pairs, 1 not converged; ...".
GRAZE_EXPORT std::string summary_line(const ReportHead& head, const ReportSummary& summary);

}  // namespace graze::io
