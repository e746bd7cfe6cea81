// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <graze/math/platform/export.hpp>

namespace graze::io {

/// The number of insertions, deletions, replacements and swaps of adjacent letters that turn one word into the other,
/// ignoring case; `limit + 1` if it is more than `limit`.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit);

/// The known name that a misspelt one probably means: at most a third of its letters, plus one, are wrong. If several
/// are equally near, the first.
std::optional<std::string_view> nearest_name(std::string_view name, std::span<const std::string_view> known);

/// The end of a message about an unknown name: `; did you mean "radius"?`, or if no name is near, `; known: "a", "b"`.
GRAZE_EXPORT std::string did_you_mean(std::string_view name, std::span<const std::string_view> known);

}  // namespace graze::io
