// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace graze::cli {

/// The extension of a file's name with its dot, in lower case: ".json"; empty if there is none.
std::string file_ending(const std::string& name);

}  // namespace graze::cli
