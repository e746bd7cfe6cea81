// SPDX-License-Identifier: MIT
// What a user got wrong on the command line, in words that help.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/suggestion.hpp>

namespace graze::cli {

/// A command line that cannot be followed. The message names the argument and what would be allowed.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Says what CLI11 did not like, naming the nearest known option or command.
UsageError explained(const CLI::App& program, const CLI::ParseError& error);

/// The subcommand that was called, or the program when none was.
const CLI::App& called(const CLI::App& program);

/// "graze check", or "graze" for the program itself.
std::string full_name(const CLI::App& app);

/// What the value of an option stands for. Throws UsageError with the nearest of the choices, or all of them.
template <class Value, std::size_t Count>
Value chosen(const std::string& option, std::string_view word,
             const std::array<std::pair<std::string_view, Value>, Count>& choices) {
  std::array<std::string_view, Count> known;
  for (std::size_t i = 0; i < Count; ++i) {
    if (choices[i].first == word) return choices[i].second;
    known[i] = choices[i].first;
  }
  throw UsageError(option + " " + io::in_quotes(word) + " is not known" + io::did_you_mean(word, known));
}

}  // namespace graze::cli
