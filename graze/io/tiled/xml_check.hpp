// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace graze::io {

/// Throws InputError for text that is not well-formed XML although pugixml accepts it: a second root element, text
/// outside the root, attributes that are duplicate or not separated by blanks, "<" in a value, entities that XML does
/// not define itself, and control characters. It may accept text that pugixml refuses, so use both.
void require_well_formed_xml(std::string_view text, const std::string& source);

}  // namespace graze::io
