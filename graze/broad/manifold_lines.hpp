// SPDX-License-Identifier: MIT
// The lines that bound a face over a face, as kernels number them, and what a corner on two of them lies on: the tables
// of query/obb_faces.hpp by both lines.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <graze/math/vec.hpp>
#include <graze/query/obb_faces.hpp>

namespace graze::detail {

/// 0 to 3 are the sides of the incident face, 4 to 7 those of the reference face, 8 is its plane: of two that meet, the
/// higher one has cut the other.
inline constexpr std::size_t clip_lines = 9;

/// The corner where one side ends and another starts, as a number that every type holds.
constexpr std::size_t line_pair(std::size_t ends, std::size_t starts) { return clip_lines * ends + starts; }
constexpr double line_pair_number(std::size_t ends, std::size_t starts) {
  return static_cast<double>(line_pair(ends, starts));
}

/// Where a corner is on the two faces, as features_of_faces lists it.
struct PlacesOnFaces {
  std::uint8_t on_reference;
  std::uint8_t on_incident;
};

#ifdef GRAZE_HAS_LANES

/// As LinesOfFaces has it.
constexpr std::uint32_t line_of_faces(std::size_t line) {
  return static_cast<std::uint32_t>(line == 8 ? 8 : (line + 4) % 8);
}

inline constexpr auto places_by_line_pair = [] {
  std::array<PlacesOnFaces, clip_lines * clip_lines> places{};
  for (std::size_t ends = 0; ends < clip_lines; ++ends) {
    for (std::size_t starts = 0; starts < clip_lines; ++starts) {
      // A corner of the incident face itself is named by the side that starts there.
      const bool is_own = ends < 4 && starts < 4;
      const std::size_t from = is_own ? starts : ends < starts ? ends : starts;
      const std::size_t cut_by = ends < starts ? starts : ends;
      if (from == 8) continue;
      const std::uint32_t cut = is_own ? LinesOfFaces::nothing : line_of_faces(cut_by);
      places[line_pair(ends, starts)] = {places_on_reference[line_of_faces(from)][cut],
                                         places_on_incident[line_of_faces(from)][cut]};
    }
  }
  return places;
}();

#endif

}  // namespace graze::detail
