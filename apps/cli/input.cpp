// SPDX-License-Identifier: MIT
#include "input.hpp"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <graze/io/file/utf8_path.hpp>
#include <graze/io/file/whole_file.hpp>
#include <graze/io/input_error.hpp>

#include "output.hpp"
#include "terminal.hpp"

namespace graze::cli {
namespace {

constexpr std::string_view standard_input_name = "standard input";

std::string standard_input() {
  std::string text;
  std::array<char, 65536> block{};
  for (;;) {
    const std::size_t count = std::fread(block.data(), 1, block.size(), stdin);
    text.append(block.data(), count);
    if (count < block.size()) break;
  }
  if (std::ferror(stdin) != 0) {
    throw io::InputError(fmt::format("the standard input cannot be read: {}", std::strerror(errno)));
  }
  return text;
}

}  // namespace

io::SceneFile read_input(const std::string& name, const io::SceneReading& reading) {
  if (!is_standard_stream(name)) return io::read_scene(io::path_from_utf8(name), reading);
  io::SceneFile file =
      io::parse_scene(standard_input(), std::string(standard_input_name), std::filesystem::current_path(), reading);
  file.source = name;
  return file;
}

io::MeshFile read_mesh_input(const std::string& name) {
  if (!is_standard_stream(name)) return io::read_meshes(io::path_from_utf8(name));
  return io::parse_meshes(standard_input(), std::string(standard_input_name), std::filesystem::current_path());
}

io::AnyQueryLog read_log(const std::string& name) {
  if (is_standard_stream(name)) return io::parse_query_log(standard_input(), "standard input");
  return io::parse_query_log(io::read_whole_file(io::path_from_utf8(name), "the log"), name);
}

std::string name_of(const io::SceneFile& file) {
  return is_standard_stream(file.source) ? std::string(standard_input_name) : file.source;
}

void refuse_omissions(const io::SceneFile& file) {
  std::vector<std::string> facts = file.warnings;
  for (const io::Omission& omission : file.omissions) facts.push_back("not read: " + io::omission_text(omission));
  if (facts.empty()) return;
  throw io::InputError(fmt::format("{}: refused because of --strict: {}", name_of(file), fmt::join(facts, "; ")));
}

void say_warnings(const io::SceneFile& file) {
  for (const std::string& warning : file.warnings) say("warning: " + warning);
}

void tell_omissions(const io::SceneFile& file, bool strict) {
  if (strict) refuse_omissions(file);
  say_warnings(file);
  for (const io::Omission& omission : file.omissions) say("not read: " + io::omission_text(omission));
}

void add_solid(CLI::App& app, io::SceneReading& reading) {
  app.add_flag_callback(
      "--solid", [&reading] { reading.meshes = MeshKind::solid; },
      "Closed meshes of a mesh file are solids, not surfaces");
}

void add_strict(CLI::App& app, bool& strict) {
  app.add_flag("--strict", strict, "Refuse a scene that is not read completely");
}

}  // namespace graze::cli
