// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include <graze/io/log/query_log.hpp>
#include <graze/io/scene_file.hpp>

namespace graze::cli {

/// Reads a scene from a file, or for "-" from all of the standard input; there, relative references are looked up from
/// the working directory. Throws InputError.
io::SceneFile read_input(const std::string& name);

/// Reads a query log from a file, or for "-" from all of the standard input. Throws InputError.
io::AnyQueryLog read_log(const std::string& name);

/// What messages call the file.
std::string name_of(const io::SceneFile& file);

/// Throws InputError if the file holds what was not read, or something about it is doubtful: what --strict asks.
void refuse_omissions(const io::SceneFile& file);

/// Says on the error stream what is doubtful about the file.
void say_warnings(const io::SceneFile& file);

/// Says on the error stream what was not read and what is doubtful. With --strict, which is `strict`, both are errors:
/// throws InputError.
void tell_omissions(const io::SceneFile& file, bool strict);

/// Adds the option --strict.
void add_strict(CLI::App& app, bool& strict);

}  // namespace graze::cli
