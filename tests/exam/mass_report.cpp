// SPDX-License-Identifier: MIT
#include "exam/mass_report.hpp"

#include <string>
#include <vector>

#include "exam/table.hpp"

namespace graze::exam {

std::string mass_table(const std::vector<MassTally>& tallies) {
  if (tallies.empty()) return "";
  std::string text =
      "### Mass properties\n\n"
      "The shapes of the cases above, beside sums of simplices in rational numbers. *Wrong*: farther off than "
      "promised.\n"
      "The largest errors of volume, centroid times volume and inertia are in epsilon of double of those of a box that "
      "is\n"
      "as large as the shape, or as far from the origin.\n\n";
  text += head({"space", "shape", "cases", "with volume", "wrong", "volume", "centroid", "inertia"});
  for (const MassTally& tally : tallies) {
    text += row({label(tally.space), tally.shape, std::to_string(tally.cases), std::to_string(tally.solid),
                 std::to_string(tally.wrong), rounded(tally.volume), rounded(tally.centroid), rounded(tally.inertia)});
  }
  return text + "\n";
}

}  // namespace graze::exam
