// SPDX-License-Identifier: MIT
#include "pair_lines.hpp"

#include <iterator>

#include <fmt/format.h>

namespace graze::cli {

std::string head_of_pairs(PairFormat format, const PairWorld& world) {
  if (format == PairFormat::csv) return "a,b\n";
  return fmt::format("{{\"schema\": \"graze.pairs/1\", \"world\": \"{}\", \"seed\": {}, \"frame\": {},\n\"pairs\": [",
                     text_of(world.world), world.seed, world.frame);
}

void append_pairs(std::string& text, PairFormat format, std::span<const NumberedPair> pairs, bool is_first) {
  for (const auto& [a, b] : pairs) {
    if (format == PairFormat::csv) {
      fmt::format_to(std::back_inserter(text), "{},{}\n", a, b);
    } else {
      fmt::format_to(std::back_inserter(text), "{}\n[{}, {}]", is_first ? "" : ",", a, b);
    }
    is_first = false;
  }
}

std::string tail_of_pairs(PairFormat format) { return format == PairFormat::csv ? "" : "]}\n"; }

}  // namespace graze::cli
