// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace graze::io {

/// What a text is that is given as a scene and is none, and what to give instead: "this is a Godot scene; ...". Empty
/// for what may be a scene, and for what it does not know. It looks at the beginning only, so that a scene costs
/// nothing.
std::string foreign_format(std::string_view text);

}  // namespace graze::io
