// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace graze::io {

/// The last component of a path with slashes of either kind, for output that should not reveal folders. The path itself
/// if it ends in a slash.
std::string file_name(std::string_view path);

}  // namespace graze::io
