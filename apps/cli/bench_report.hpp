// SPDX-License-Identifier: MIT
// The result of a benchmark, written for people or programs. docs/cli.md documents the formats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <graze/io/report/check.hpp>
#include <graze/math/vec.hpp>

namespace graze::cli {

enum class BenchFormat { table, json, csv };

/// One method over all frames.
struct MethodResult {
  std::string_view method;
  std::string_view chosen;           ///< The method that it used in the last frame.
  std::vector<double> milliseconds;  ///< One for each frame.
  std::size_t bytes = 0;             ///< Memory held in addition to boxes and pairs, after the last frame.
};

/// A method that was not run, and the reason.
struct SkippedMethod {
  std::string_view method;
  std::string reason;
};

struct BenchReport {
  std::string source;                 ///< The name of the file or generated world.
  std::optional<std::uint64_t> seed;  ///< The seed of a generated world.
  Dim dimension = 3;
  std::string_view scalar;
  std::size_t boxes = 0;
  std::size_t frames = 0;
  std::string_view order;
  std::size_t threads = 1;
  std::vector<std::size_t> pairs;     ///< One number for each frame, the same for all methods.
  std::vector<double> floor;          ///< Milliseconds, one for each frame (see MemoryFloor).
  std::vector<MethodResult> methods;  ///< In the order in which they were requested.
  std::vector<SkippedMethod> skipped;
};

void write_bench_report(std::ostream& out, BenchFormat format, const BenchReport& report, io::Colours colours);

}  // namespace graze::cli
