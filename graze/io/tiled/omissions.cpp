// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <graze/io/text/position.hpp>
#include <graze/io/tiled/omissions.hpp>

namespace graze::io {

void count_omission(std::vector<Omission>& omissions, const OmissionKind& kind, const TiledPlace& place,
                    std::size_t count) {
  if (count == 0) return;
  const auto known = std::find_if(omissions.begin(), omissions.end(),
                                  [&](const Omission& omission) { return omission.what == kind.what; });
  if (known != omissions.end()) {
    known->count += count;
    return;
  }
  const TextPosition position = position_of(place.file.text, place.offset);
  omissions.push_back({std::string(kind.what), count, kind.loss,
                       fmt::format("{}, line {}, column {}", place.file.name, position.line, position.column),
                       std::string(kind.why)});
}

}  // namespace graze::io
