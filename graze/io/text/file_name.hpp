// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace graze::io {

/// The last part of a path with slashes of either kind: what may be shown to others, who need not know of the folders.
/// The path itself where it ends in a slash.
std::string file_name(std::string_view path);

}  // namespace graze::io
