// SPDX-License-Identifier: MIT
#include "terminal.hpp"

#include <cstdio>
#include <string>
#include <string_view>

#include <graze/io/text/printable.hpp>

namespace graze::cli {
bool has_cursor(Stream stream) { return is_terminal(stream) && environment("TERM") != "dumb"; }

io::Colours colours_for(Stream stream) {
  return has_cursor(stream) && environment("NO_COLOR").empty() ? io::Colours::on : io::Colours::off;
}

void say_text(const std::string& text) { std::fputs(text.c_str(), stderr); }

void say(std::string_view message) { say_text("graze: " + io::printable(message) + "\n"); }

void say_error(std::string_view message) {
  const bool coloured = colours_for(Stream::error) == io::Colours::on;
  say_text(std::string("graze: ") + (coloured ? "\x1b[1;31merror:\x1b[0m " : "error: ") + io::printable(message) +
           "\n");
}

}  // namespace graze::cli
