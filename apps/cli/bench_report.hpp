// SPDX-License-Identifier: MIT
// What a benchmark found, written for people or for programs. The formats are documented in docs/cli.md.
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
  std::string_view chosen;           ///< The method it used in the last frame.
  std::vector<double> milliseconds;  ///< One for each frame.
  std::size_t bytes = 0;             ///< Memory held beside boxes and pairs, after the last frame.
};

/// A method that was not run, and why.
struct SkippedMethod {
  std::string_view method;
  std::string reason;
};

struct BenchReport {
  std::string source;                 ///< The file's name or the world.
  std::optional<std::uint64_t> seed;  ///< Of a world.
  Dim dimension = 3;
  std::string_view scalar;
  std::size_t boxes = 0;
  std::size_t frames = 0;
  std::string_view order;
  std::size_t threads = 1;
  std::vector<std::size_t> pairs;     ///< One number for each frame, on which all methods agree.
  std::vector<double> floor;          ///< Milliseconds, one for each frame (see MemoryFloor).
  std::vector<MethodResult> methods;  ///< In the order in which they were asked for.
  std::vector<SkippedMethod> skipped;
};

void write_bench_report(std::ostream& out, BenchFormat format, const BenchReport& report, io::Colours colours);

}  // namespace graze::cli
