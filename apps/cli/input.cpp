// SPDX-License-Identifier: MIT
#include "input.hpp"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include <graze/io/input_error.hpp>
#include <graze/io/whole_file.hpp>

#include "output.hpp"
#include "terminal.hpp"

namespace graze::cli {
namespace {

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

io::SceneFile read_input(const std::string& name) {
  if (!is_standard_stream(name)) return io::read_scene(name);
  io::SceneFile file = io::parse_scene(standard_input(), "standard input", std::filesystem::current_path());
  file.source = name;
  return file;
}

io::AnyQueryLog read_log(const std::string& name) {
  if (is_standard_stream(name)) return io::parse_query_log(standard_input(), "standard input");
  return io::parse_query_log(io::read_whole_file(name, "the log"), name);
}

void say_omissions(const io::SceneFile& file) {
  for (const io::Omission& omission : file.omissions)
    say(fmt::format("not read: {} x {}", omission.count, omission.what));
}

}  // namespace graze::cli
