// SPDX-License-Identifier: MIT
// What a check of a scene found, written for people or for programs. The formats are documented in docs/cli.md.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <graze/io/omission.hpp>
#include <graze/io/text/table.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/status.hpp>

namespace graze::io {

enum class ReportFormat { table, json, ndjson, csv };

/// What is told of each pair beside its relation.
enum class PairDetail {
  none,
  contacts,  ///< Along which normal, how deep and where.
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

/// A point at which two objects touch, and how deep they are in each other there: infinitely, if nothing parts them.
struct ReportedContact {
  std::vector<double> point;
  double depth = 0;
};

/// Two objects by name. Vectors have as many coordinates as the scene.
struct ReportedPair {
  std::string_view a;
  std::string_view b;
  Relation relation = Relation::touching;
  double distance = 0;                         ///< For PairDetail::distance.
  std::vector<double> normal = {};             ///< For PairDetail::contacts: from a to b, or zero.
  std::vector<ReportedContact> contacts = {};  ///< For PairDetail::contacts: at least one.
  Status status = Status::converged;           ///< How the search for the distance, or the depth, ended.
  double error = 0;                            ///< How far that may be off.
};

/// What is known after the last pair.
struct ReportSummary {
  std::size_t pairs = 0;          ///< Pairs reported.
  std::size_t candidates = 0;     ///< Pairs tested exactly, because their boxes overlap.
  double seconds = 0;             ///< The search, without reading and writing.
  std::size_t not_converged = 0;  ///< Of the pairs reported.
};

/// Writes one report: `write` for every pair in order, then `finish` once. Pairs are written as they come, and none is
/// kept; a table holds the first ones back until it knows how wide its columns are. In a table and in CSV a pair has a
/// row for each of its contacts. Names are quoted or escaped as the format needs it, whatever bytes they hold, and
/// numbers are as short as they can be read back, but for those of a table. Where more is told than a relation, JSON
/// and CSV always tell the status and the error; a table tells the error of what has not converged. What was not read
/// of the scene is a field in JSON; where shapes are missing by it, the first lines of NDJSON, the first rows of CSV
/// and a line over the summary of a table say so. Virtual because the format is chosen at run time; a call per pair is
/// nothing beside the test of the pair.
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

/// Begins a report on `out`, which must outlive the writer. Only a table has colours.
std::unique_ptr<ReportWriter> begin_report(std::ostream& out, ReportFormat format, const ReportHead& head,
                                           Colours colours = Colours::off);

/// The fields of a JSON document that say what it is about, each but the first on a line of its own.
std::string json_head(const ReportHead& head);

/// The sentence that closes a table: "2 pairs; 5 objects, 3 candidates, 0.001 seconds", or "2 pairs, 1 not converged;
/// ...".
std::string summary_line(const ReportHead& head, const ReportSummary& summary);

}  // namespace graze::io
