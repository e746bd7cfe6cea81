// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace graze::io {

/// How many insertions, deletions, replacements and swaps of neighbours turn one word into the other, upper and lower
/// case counting as equal; anything above `limit` is given as `limit + 1`.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit);

/// The known name that a misspelt one was probably meant to be: at most a third of its letters, plus one, are wrong.
/// Of equally near ones the first.
std::optional<std::string_view> nearest_name(std::string_view name, std::span<const std::string_view> known);

/// The end of a message about an unknown name: `; did you mean "radius"?`, or where nothing is near `; known: "a",
/// "b"`.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> known);

}  // namespace graze::io
