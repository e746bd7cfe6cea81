// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <graze/math/platform/export.hpp>

namespace graze::io {

/// The last component of a path with slashes of either kind, for output that should not reveal folders. The path itself
/// if it ends in a slash.
GRAZE_EXPORT std::string file_name(std::string_view path);

}  // namespace graze::io
