// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace graze::io {

/// The relative path of a URI, with %20 and the like decoded. None if it could lead out of the folder: if it is
/// absolute, has a scheme, a drive or "..", or contains a backslash or a zero byte; also if it is empty.
std::optional<std::string> file_of_gltf_uri(std::string_view uri);

}  // namespace graze::io
