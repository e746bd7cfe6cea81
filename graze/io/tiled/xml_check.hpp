// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace graze::io {

/// Throws InputError for what makes a text no well-formed XML although pugixml accepts it: a second root element, text
/// outside the root, an attribute that is given twice or not set apart, "<" in a value, an entity that XML does not
/// define by itself, and control characters. Of a text that pugixml refuses it may find nothing: ask pugixml, too.
void require_well_formed_xml(std::string_view text, const std::string& source);

}  // namespace graze::io
