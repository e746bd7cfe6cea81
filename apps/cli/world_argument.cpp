// SPDX-License-Identifier: MIT
#include "world_argument.hpp"

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "usage.hpp"

namespace graze::cli {
namespace {

/// Pairs refer to boxes by 32-bit indexes.
constexpr NumberRange count_range{1, std::numeric_limits<std::uint32_t>::max()};

World read_name(const std::string& name) {
  if (const std::optional<World> world = world_named(name)) return *world;
  std::vector<std::string_view> known;
  for (const World world : all_worlds()) known.push_back(name_of(world));
  throw UsageError(fmt::format("the world {} is not known{}", io::in_quotes(name), io::did_you_mean(name, known)));
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char letter : text) {
    if (letter == ':') {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

/// The factor of a suffix; 0 if it is unknown.
std::uint64_t factor_of(std::string_view suffix) {
  if (suffix.empty()) return 1;
  if (suffix == "k" || suffix == "K") return 1000;
  return suffix == "M" ? 1000000 : 0;
}

}  // namespace

WorldArgument read_world(const std::string& text) {
  std::vector<std::string> parts = split(text);
  WorldArgument argument;
  const bool has_dimension = parts.size() > 1 && !world_named(parts.front()) && parts.front().size() == 2;
  if (has_dimension) {
    if (parts.front() != "2d" && parts.front() != "3d") {
      throw UsageError(fmt::format("the dimension {} of {} is not known; write 2d: or 3d:; 3d is the default",
                                   io::in_quotes(parts.front()), io::in_quotes(text)));
    }
    argument.dimension = parts.front() == "2d" ? 2 : 3;
    parts.erase(parts.begin());
  }
  argument.world = read_name(parts.front());
  if (parts.size() != 2) {
    throw UsageError(fmt::format("the world {} needs a number of boxes and nothing else, such as {}:100k",
                                 io::in_quotes(text), parts.front()));
  }
  argument.count = read_number("the number of boxes", parts.back(), count_range);
  return argument;
}

std::string text_of(const WorldArgument& world) {
  return fmt::format("{}{}:{}", world.dimension == 2 ? "2d:" : "", name_of(world.world), world.count);
}

std::uint64_t read_number(const std::string& what, const std::string& text, const NumberRange& range) {
  std::uint64_t number = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::uint64_t factor = factor_of({end, text.data() + text.size()});
  const bool is_digits = end != text.data() && factor != 0;
  if (!is_digits || (status != std::errc() && status != std::errc::result_out_of_range)) {
    throw UsageError(
        fmt::format("{} is {}, which is not a whole number such as 7, 50k or 1M", what, io::in_quotes(text)));
  }
  const bool is_countable = status == std::errc() && number <= std::numeric_limits<std::uint64_t>::max() / factor;
  if (!is_countable || number * factor < range.least || number * factor > range.most) {
    throw UsageError(fmt::format("{} is {}; it must be from {} to {}", what, text, range.least, range.most));
  }
  return number * factor;
}

}  // namespace graze::cli
