// SPDX-License-Identifier: MIT
// Pairs that begin and end to touch, frame by frame. docs/cli.md documents the format.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string_view>
#include <utility>
#include <vector>

#include <graze/math/platform/export.hpp>

namespace graze::io {

/// Two objects, by name.
using NamePair = std::pair<std::string_view, std::string_view>;

/// The changes of contact from one frame to the next.
struct FrameReport {
  std::size_t frame = 0;
  double seconds = 0;        ///< Time since frame 0.
  std::size_t touching = 0;  ///< Pairs that touch or overlap now.
  std::vector<NamePair> began;
  std::vector<NamePair> ended;
};

/// Writes a frame as a line of NDJSON.
GRAZE_EXPORT void write_frame(std::ostream& out, const FrameReport& report);

}  // namespace graze::io
