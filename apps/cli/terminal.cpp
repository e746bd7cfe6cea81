// SPDX-License-Identifier: MIT
#include "terminal.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

#include <graze/io/text/printable.hpp>

namespace graze::cli {
namespace {

/// The value of an environment variable; empty if it is not set.
std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

}  // namespace

bool is_terminal(Stream stream) { return isatty(static_cast<int>(stream)) == 1; }

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

void claim_standard_streams() {
  // Opened in the wrong direction: reading from the input and writing to the others must fail, as on closed streams.
  constexpr std::array<int, 3> modes{O_WRONLY, O_RDONLY, O_RDONLY};
  for (int number = 0; number < 3; ++number) {
    const bool closed = fcntl(number, F_GETFD) == -1 && errno == EBADF;
    if (closed && open("/dev/null", modes[static_cast<std::size_t>(number)]) != number) return;
  }
}

}  // namespace graze::cli
