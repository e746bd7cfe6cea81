// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>
#include <vector>

#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/suggestion.hpp>

namespace graze::io {
namespace {

char lower(char letter) { return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter; }

}  // namespace

// Optimal string alignment (Damerau 1964, Wagner and Fischer 1974): row i holds the distances between the first i
// letters of a and all prefixes of b; a swap uses the row before the last.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
  if (std::max(a.size(), b.size()) - std::min(a.size(), b.size()) > limit) return limit + 1;
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before_last, last);
    std::swap(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool equal = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (equal ? 0U : 1U)});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return std::min(row[b.size()], limit + 1);
}

std::optional<std::string_view> nearest_name(std::string_view name, std::span<const std::string_view> known) {
  std::optional<std::string_view> nearest;
  std::size_t least = 0;
  for (const std::string_view candidate : known) {
    const std::size_t limit = candidate.size() / 3 + 1;
    const std::size_t distance = edit_distance(name, candidate, limit);
    const bool unlike = distance > limit || distance >= candidate.size();
    if (unlike || (nearest && distance >= least)) continue;
    nearest = candidate;
    least = distance;
  }
  return nearest;
}

std::string did_you_mean(std::string_view name, std::span<const std::string_view> known) {
  if (const auto nearest = nearest_name(name, known)) return "; did you mean " + in_quotes(*nearest) + "?";
  if (known.empty()) return "";
  std::string result = "; known: ";
  for (std::size_t i = 0; i < known.size(); ++i) result += (i == 0 ? "" : ", ") + in_quotes(known[i]);
  return result;
}

}  // namespace graze::io
