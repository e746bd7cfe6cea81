// SPDX-License-Identifier: MIT
// Messages about wrong command lines.
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

/// A command line that is not valid. The message names the argument and what is allowed.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Describes an error that CLI11 found and suggests the nearest known option or command.
UsageError explained(const CLI::App& program, const CLI::ParseError& error);

/// The subcommand that was called, or the program if there was none.
const CLI::App& called(const CLI::App& program);

/// "graze check", or "graze" for the program itself.
std::string full_name(const CLI::App& app);

/// The meaning of an option's value. Throws UsageError with the nearest allowed value, or all of them.
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
