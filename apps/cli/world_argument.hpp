// SPDX-License-Identifier: MIT
// Generated worlds and integers on the command line.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include <graze/broad/scene_generators.hpp>
#include <graze/math/vec.hpp>

namespace graze::cli {

/// A generated world as given by the user: "brownian:1000000", "2d:heavy:100k".
struct WorldArgument {
  Dim dimension = 3;
  World world = World::brownian;
  std::size_t count = 0;  ///< At least 1.
};

/// Parses such a text. Throws UsageError with the fault and what is allowed.
WorldArgument read_world(const std::string& text);

/// The normalised text: without "3d:" and suffixes.
std::string text_of(const WorldArgument& world);

/// The range of an integer option.
struct NumberRange {
  std::uint64_t least = 0;
  std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
};

/// The number of frames that a recording, and thus a run, can have.
inline constexpr NumberRange frame_range{1, (std::uint64_t{1} << 31U) - 1};

/// An integer, also as "50k" or "1M". Throws UsageError that begins with `what`.
std::uint64_t read_number(const std::string& what, const std::string& text, const NumberRange& range);

}  // namespace graze::cli
