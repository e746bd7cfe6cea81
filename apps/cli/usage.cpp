// SPDX-License-Identifier: MIT
#include "usage.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace graze::cli {
namespace {

bool is_option(std::string_view argument) { return argument.size() > 1 && argument.front() == '-'; }

UsageError unknown_option(const CLI::App& app, const std::string& argument) {
  const std::string name = argument.substr(0, argument.find('='));
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& long_name : option->get_lnames()) names.push_back("--" + long_name);
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  return UsageError(
      fmt::format("{} has no option {}{}", full_name(app), io::in_quotes(name), io::did_you_mean(name, known)));
}

UsageError unknown_command(const CLI::App& program, const std::string& argument) {
  std::vector<std::string_view> known;
  for (const CLI::App* command : program.get_subcommands({})) known.push_back(command->get_name());
  return UsageError(fmt::format("{} has no command {}{}", full_name(program), io::in_quotes(argument),
                                io::did_you_mean(argument, known)));
}

/// The first missing argument or required option.
std::string missing_argument(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_required() && option->count() == 0)
      return fmt::format("{} ({})", option->get_name(), option->get_description());
  }
  return "an argument";
}

}  // namespace

std::string full_name(const CLI::App& app) {
  return app.get_parent() == nullptr ? app.get_name() : app.get_parent()->get_name() + " " + app.get_name();
}

const CLI::App& called(const CLI::App& program) {
  const std::vector<CLI::App*> commands = program.get_subcommands();
  return commands.empty() ? program : *commands.front();
}

UsageError explained(const CLI::App& program, const CLI::ParseError& error) {
  // An unknown option is a likelier mistake than its consequences, a missing value or a surplus argument.
  const CLI::App& command = called(program);
  for (const CLI::App* app : {&program, &command}) {
    for (const std::string& argument : app->remaining()) {
      if (is_option(argument)) return unknown_option(*app, argument);
    }
  }
  const std::vector<std::string> extras = command.remaining();
  if (!extras.empty()) {
    if (&command == &program) return unknown_command(program, extras.front());
    return UsageError(
        fmt::format("{} takes no further argument {}", full_name(command), io::in_quotes(extras.front())));
  }
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    return UsageError(fmt::format("{} needs {}", full_name(command), missing_argument(command)));
  }
  return UsageError(fmt::format("{}: {}", full_name(command), error.what()));
}

}  // namespace graze::cli
