// SPDX-License-Identifier: MIT
// Other programs that say when a shape in space that moves along a vector meets another. Each is one file,
// rival_<name>.cpp. libccd and ODE have no such question.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>

#include <graze/math/vec.hpp>

#include "exam/rival.hpp"

namespace graze::exam {

/// What a program says of a motion.
struct Meeting {
  bool hits = false;
  double t = 0;  ///< From 0 to 1, only if it hits; NaN if it gave up.
};

/// The rival's opinion; none if it has no such test for these two types.
template <class T>
using MeetingAnswer = std::optional<Meeting> (*)(const Solid3<T>& a, const Vec<3, T>& motion, const Solid3<T>& b);

template <class T>
struct CastRival {
  std::string_view name;
  MeetingAnswer<T> answer;
};

/// Bullet's btContinuousConvexCollision, which its world's sweeps use, shapes without margin as in rival.hpp.
std::optional<Meeting> bullet_meeting(const Solid3<float>& a, const Vec<3, float>& motion, const Solid3<float>& b);

/// fcl::continuousCollide by conservative advancement, with FCL's own GJK; not of triangles, which it has in meshes
/// alone, nor of planes and half-spaces. In double alone, as it is built: of float it would have to be compiled whole.
std::optional<Meeting> fcl_meeting(const Solid3<double>& a, const Vec<3, double>& motion, const Solid3<double>& b);

inline constexpr std::array<CastRival<float>, 1> float_cast_rivals = {{{"Bullet", bullet_meeting}}};
inline constexpr std::array<CastRival<double>, 1> double_cast_rivals = {{{"FCL", fcl_meeting}}};

template <class T>
constexpr const auto& cast_rivals() {
  if constexpr (std::is_same_v<T, float>) {
    return float_cast_rivals;
  } else {
    return double_cast_rivals;
  }
}

}  // namespace graze::exam
