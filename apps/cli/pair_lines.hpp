// SPDX-License-Identifier: MIT
// Pairs of boxes as text. `graze pairs` and `graze-mpi pairs` write the same bytes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "world_argument.hpp"

namespace graze::cli {

enum class PairFormat { csv, json };

inline constexpr std::array<std::pair<std::string_view, PairFormat>, 2> pair_formats{
    {{"csv", PairFormat::csv}, {"json", PairFormat::json}}};

/// A world and the frame of it whose pairs are wanted.
struct PairWorld {
  WorldArgument world;
  std::uint64_t seed = 1;
  std::uint64_t frame = 0;  ///< How often the boxes have moved.
};

/// Two boxes by their numbers in the world.
struct NumberedPair {
  std::uint64_t a;
  std::uint64_t b;
};

/// What precedes all pairs.
std::string head_of_pairs(PairFormat format, const PairWorld& world);

/// Appends lines. `is_first` tells whether no pairs precede them.
void append_pairs(std::string& text, PairFormat format, std::span<const NumberedPair> pairs, bool is_first);

/// What follows all pairs.
std::string tail_of_pairs(PairFormat format);

}  // namespace graze::cli
