// SPDX-License-Identifier: MIT
// Answers with a number in them, graze's and its rivals': a distance, the depth of a contact, where a ray hits. What a
// program said, and how often and by how much it was wrong.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "exam/tally.hpp"

namespace graze::exam {

/// The answers of one program to the same cases.
struct MeasureTally {
  std::size_t cases = 0;
  std::size_t false_yes = 0;
  std::size_t false_no = 0;
  std::size_t measured = 0;      ///< Rightly said to meet, so that there is a number to judge.
  std::size_t off = 0;           ///< Of those the ones farther off than `fair_share` of the shapes' size.
  std::size_t slightly_off = 0;  ///< The same with `fine_share`; only of distances.
  std::size_t points_off = 0;    ///< Of the measured ones those whose points are off by more than `fair_share`.
  std::size_t points = 0;        ///< Of all the measured ones together; only of manifolds.
  double worst = 0;              ///< The largest error, as a share of the size.

  MeasureTally& operator+=(const MeasureTally& other) {
    cases += other.cases;
    false_yes += other.false_yes;
    false_no += other.false_no;
    measured += other.measured;
    off += other.off;
    slightly_off += other.slightly_off;
    points_off += other.points_off;
    points += other.points;
    worst = std::max(worst, other.worst);
    return *this;
  }
};

/// What everybody is given: a thousandth of the shapes' own size, and what rounding the coordinates loses.
inline constexpr double fair_share = 1e-3;

/// What distances are also counted by: a millionth of it.
inline constexpr double fine_share = 1e-6;

/// graze's answers of one kind on one pair of types, or one type of shapes and rays, in one space.
struct MeasuredPair {
  SpaceName space{};
  std::string pair;
  std::size_t cases = 0;
  std::size_t hits = 0;
  std::size_t outside = 0;  ///< Beyond what is documented.
  std::size_t wrong = 0;
  std::size_t unfinished = 0;  ///< With a status that says so; only of impacts.
  double worst = 0;            ///< Of the number, in epsilon of T times the documented size.
  double worst_second = 0;  ///< Of a contact the overlap that is left after the move, in the same; of the others that
                            ///< have points the error of those.
  std::map<std::string_view, MeasureTally> rivals;  ///< By name, graze's own answers among them.
};

}  // namespace graze::exam
