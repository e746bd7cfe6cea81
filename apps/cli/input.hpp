// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <graze/io/query_log.hpp>
#include <graze/io/scene_file.hpp>

namespace graze::cli {

/// Reads a scene from a file, or for "-" from all of the standard input; there, relative references are looked up from
/// the working directory. Throws InputError.
io::SceneFile read_input(const std::string& name);

/// Reads a query log from a file, or for "-" from all of the standard input. Throws InputError.
io::AnyQueryLog read_log(const std::string& name);

/// Says on the error stream what the file holds and was not read.
void say_omissions(const io::SceneFile& file);

}  // namespace graze::cli
