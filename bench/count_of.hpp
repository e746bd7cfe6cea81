// SPDX-License-Identifier: MIT
#pragma once

#include <cctype>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace bench {

/// The number that a text such as "5000", "10k" or "1M" stands for. Throws std::invalid_argument unless it is from 8 to
/// 100M; `what` names what is counted.
inline std::size_t count_of(const std::string& text, const std::string& what) {
  std::size_t digits = 0;
  while (digits < text.size() && digits < 9 && std::isdigit(static_cast<unsigned char>(text[digits])) != 0) ++digits;
  const std::string suffix = text.substr(digits);
  const std::size_t factor = suffix.empty() ? 1 : suffix == "k" ? 1'000 : suffix == "M" ? 1'000'000 : 0;
  const std::size_t number = digits == 0 ? 0 : std::stoul(text.substr(0, digits));
  const std::size_t count = number * factor;
  if (count < 8 || count > 100'000'000) {
    throw std::invalid_argument("\"" + text + "\" is no number of " + what + "; write 8, 10k or 1M, up to 100M");
  }
  return count;
}

}  // namespace bench
