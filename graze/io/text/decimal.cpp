// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <string_view>
#include <system_error>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <graze/io/text/decimal.hpp>
#include <graze/io/text/in_quotes.hpp>

namespace graze::io {
namespace {

/// Skips a leading plus sign, which some programs write.
std::string_view without_plus(std::string_view number) {
  const bool has_plus = number.size() > 1 && number[0] == '+' && number[1] != '-' && number[1] != '+';
  return has_plus ? number.substr(1) : number;
}

}  // namespace

Decimal decimal_of(std::string_view text) {
  const std::string_view digits = without_plus(text);
  double value = 0;
  const auto [end, status] = fast_float::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool is_complete = end == digits.data() + digits.size() && !digits.empty();
  if (is_complete && status == std::errc() && std::isfinite(value)) return {value};
  const bool is_infinite =
      is_complete && std::isinf(value) && digits.find_first_of("0123456789") != std::string_view::npos;
  if (is_infinite) return {0, fmt::format("is {}; the largest number is about 1.8e308", in_quotes(text))};
  if (is_complete && !std::isfinite(value)) {
    return {0, fmt::format("is {}; it must be a finite number", in_quotes(text))};
  }
  const bool has_comma = digits.find(',') != std::string_view::npos;
  return {0, fmt::format("is {}, which is not a number{}", in_quotes(text),
                         has_comma ? "; write decimals with a point" : "")};
}

}  // namespace graze::io
