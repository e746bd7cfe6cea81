// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include <graze/io/log/query_log.hpp>
#include <graze/io/mesh_file.hpp>
#include <graze/io/scene_file.hpp>

namespace graze::cli {

/// Reads a scene from a file, or for "-" from the standard input; then relative references are resolved from the
/// working directory. Throws InputError.
io::SceneFile read_input(const std::string& name, const io::SceneReading& reading = {});

/// Reads the meshes of a file, or for "-" of the standard input. Throws InputError.
io::MeshFile read_mesh_input(const std::string& name);

/// Reads a query log from a file, or for "-" from the standard input. Throws InputError.
io::AnyQueryLog read_log(const std::string& name);

/// The name of the file in messages.
std::string name_of(const io::SceneFile& file);

/// Throws InputError if not everything in the file was read or something about it is suspicious, as required by
/// --strict.
void refuse_omissions(const io::SceneFile& file);

/// Prints the warnings about the file to the error stream.
void say_warnings(const io::SceneFile& file);

/// Prints omissions and warnings to the error stream. If `strict` (the option --strict), throws InputError for them
/// instead.
void tell_omissions(const io::SceneFile& file, bool strict);

/// Adds the option --solid.
void add_solid(CLI::App& app, io::SceneReading& reading);

/// Adds the option --strict.
void add_strict(CLI::App& app, bool& strict);

}  // namespace graze::cli
