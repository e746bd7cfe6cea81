// SPDX-License-Identifier: MIT
// What began to touch and what no longer does, frame by frame. The format is documented in docs/cli.md.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string_view>
#include <utility>
#include <vector>

namespace graze::io {

/// Two objects, by name.
using NamePair = std::pair<std::string_view, std::string_view>;

/// What became of touching from one frame to the next.
struct FrameReport {
  std::size_t frame = 0;
  double seconds = 0;        ///< Since frame 0.
  std::size_t touching = 0;  ///< Pairs that touch or overlap now.
  std::vector<NamePair> began;
  std::vector<NamePair> ended;
};

/// Writes a frame as a line of NDJSON.
void write_frame(std::ostream& out, const FrameReport& report);

}  // namespace graze::io
