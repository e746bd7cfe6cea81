// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace graze::io {

/// Identifies a text that was given as a scene but has another format, and what to give instead: "this is a Godot
/// scene; ...". Empty for possible scenes and for unknown formats. Looks at the beginning only, so that reading scenes
/// costs nothing.
std::string foreign_format(std::string_view text);

}  // namespace graze::io
