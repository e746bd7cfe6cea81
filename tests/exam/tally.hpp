// SPDX-License-Identifier: MIT
// What the exam has seen: plain counts, which the report turns into tables.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "query/case_maker.hpp"

namespace graze::exam {

/// One of the four spaces.
struct SpaceName {
  int dimension;
  std::string_view scalar;  ///< "float" or "double".
};

template <Dim N, class T>
constexpr SpaceName space_name() {
  return {static_cast<int>(N), std::is_same_v<T, float> ? "float" : "double"};
}

/// "3D float".
inline std::string label(const SpaceName& space) {
  return std::to_string(space.dimension) + "D " + std::string(space.scalar);
}

/// "sphere, obb", by places in AnyShape.
inline std::string pair_name(std::size_t a, std::size_t b) {
  return std::string(shape_type_names[a]) + ", " + std::string(shape_type_names[b]);
}

/// The answers of one program to the same cases.
struct RivalTally {
  std::size_t cases = 0;
  std::size_t false_yes = 0;
  std::size_t false_no = 0;
  std::size_t touching = 0;         ///< Cases that touch exactly.
  std::size_t touching_missed = 0;  ///< Of those the ones called apart.
  std::array<std::size_t, test::case_kind_count> cases_of_kind{};
  std::array<std::size_t, test::case_kind_count> wrong_of_kind{};

  RivalTally& operator+=(const RivalTally& other) {
    cases += other.cases;
    false_yes += other.false_yes;
    false_no += other.false_no;
    touching += other.touching;
    touching_missed += other.touching_missed;
    for (std::size_t kind = 0; kind < test::case_kind_count; ++kind) {
      cases_of_kind[kind] += other.cases_of_kind[kind];
      wrong_of_kind[kind] += other.wrong_of_kind[kind];
    }
    return *this;
  }
};

/// graze's verdicts on one pair of types in one space.
struct PairTally {
  SpaceName space{};
  std::string pair;
  std::size_t cases = 0;
  std::size_t certified = 0;  ///< Judged by a certificate; the others by the oracle.
  std::size_t hits = 0;
  std::size_t in_band = 0;  ///< Called touching within the documented band, though apart or overlapping.
  std::size_t outside = 0;  ///< Beyond what is documented: numbers that squares cannot hold, almost parallel rays.
  std::size_t wrong = 0;
  double worst = 0;  ///< The largest gap or depth called touching, in epsilon of double times the pair's size.
  std::map<std::string_view, RivalTally> rivals;  ///< By name, graze's own answers among them.
};

/// The errors of one point query, in ulp: epsilon of T times the largest coordinate of shape, point and answer.
struct PointTally {
  SpaceName space{};
  std::string shape;
  std::size_t cases = 0;
  std::size_t held = 0;
  std::size_t wrong = 0;  ///< Any answer beyond its bound, or one that the shape does not contain.
  double forgiven = 0;    ///< Of the distance of points that are outside, but contained.
  double distance = 0;    ///< Of the others.
  double closest = 0;     ///< Of needles, divided by how many times longer than thick they are; so `boundary`.
  double boundary = 0;
  double needle = 0;  ///< The larger of both, of needles, not divided.
};

}  // namespace graze::exam
