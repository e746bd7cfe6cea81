// SPDX-License-Identifier: MIT
// What the commands of the program have in common, and the functions that add them.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace graze::cli {

/// The exit codes of the program. docs/cli.md documents them.
enum ExitCode : int {
  done = 0,
  contact_found = 1,   ///< Only with --fail-on-contact.
  answers_differ = 1,  ///< When replaying a log.
  usage_error = 2,
  bad_input = 3,  ///< Or an output that cannot be written.
  internal_error = 70,
};

/// A subcommand: its options, and the function to call once they have been parsed.
struct Command {
  CLI::App* app = nullptr;
  std::function<ExitCode()> run;
};

/// Each function adds its subcommand to the program.
Command add_check(CLI::App& program);
Command add_view(CLI::App& program);
Command add_query(CLI::App& program);
Command add_simulate(CLI::App& program);
Command add_replay(CLI::App& program);
Command add_info(CLI::App& program);
Command add_convert(CLI::App& program);
Command add_bench(CLI::App& program);
Command add_generate(CLI::App& program);
Command add_pairs(CLI::App& program);

}  // namespace graze::cli
