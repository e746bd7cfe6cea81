// SPDX-License-Identifier: MIT
// Other programs that say when two shapes in space that move and turn first meet. Each is one file, rival_<name>.cpp.
// libccd and ODE have no such question.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>

#include "exam/cast_rival.hpp"
#include "query/times_of_impact.hpp"

namespace graze::exam {

/// The rival's opinion; none if it has no such test for these two types. Each shape turns about the middle of its
/// bounds, by no more than `most_turn`.
template <class T>
using ImpactAnswer = std::optional<Meeting> (*)(const test::Moving<3, T>& moving);

template <class T>
struct ImpactRival {
  std::string_view name;
  ImpactAnswer<T> answer;
};

/// Bullet turns bodies by an eighth of a turn at most.
inline constexpr double most_turn = 0.75;

/// Bullet's btContinuousConvexCollision, shapes without margin as in rival.hpp.
std::optional<Meeting> bullet_impact(const test::Moving<3, float>& moving);

/// fcl::continuousCollide by conservative advancement along its motions between two poses, which turn about the middle
/// of each shape, with FCL's own GJK; of what fcl_meeting has, in double alone, as it is built.
std::optional<Meeting> fcl_impact(const test::Moving<3, double>& moving);

inline constexpr std::array<ImpactRival<float>, 1> float_impact_rivals = {{{"Bullet", bullet_impact}}};
inline constexpr std::array<ImpactRival<double>, 1> double_impact_rivals = {{{"FCL", fcl_impact}}};

template <class T>
constexpr const auto& impact_rivals() {
  if constexpr (std::is_same_v<T, float>) {
    return float_impact_rivals;
  } else {
    return double_impact_rivals;
  }
}

}  // namespace graze::exam
