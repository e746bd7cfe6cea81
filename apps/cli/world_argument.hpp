// SPDX-License-Identifier: MIT
// Made-up worlds and whole numbers on the command line.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include <graze/broad/scene_generators.hpp>
#include <graze/math/vec.hpp>

namespace graze::cli {

/// A world as a user asks for it: "brownian:1000000", "2d:heavy:100k".
struct WorldArgument {
  Dim dimension = 3;
  World world = World::brownian;
  std::size_t count = 0;  ///< At least 1.
};

/// Reads such a text. Throws UsageError with what is wrong and what would be right.
WorldArgument read_world(const std::string& text);

/// The same text in one spelling: no "3d:", no suffix.
std::string text_of(const WorldArgument& world);

/// Which whole numbers an option takes.
struct NumberRange {
  std::uint64_t least = 0;
  std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
};

/// How many frames a recording can have, and so a run.
inline constexpr NumberRange frame_range{1, (std::uint64_t{1} << 31U) - 1};

/// A whole number, also as "50k" or "1M". Throws UsageError that begins with `what`.
std::uint64_t read_number(const std::string& what, const std::string& text, const NumberRange& range);

}  // namespace graze::cli
