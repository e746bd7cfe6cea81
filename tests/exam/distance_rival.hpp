// SPDX-License-Identifier: MIT
// Other programs that say how far apart two shapes in space are, and where they are nearest. Each is one file,
// rival_<name>.cpp. libccd and ODE have no such question: they tell whether shapes meet, and how deep.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>

#include <graze/math/vec.hpp>

#include "exam/rival.hpp"

namespace graze::exam {

/// What a program says of two shapes.
struct Separation {
  bool meets = false;
  double distance = 0;                           ///< Only where they do not; NaN if it gave up.
  Vec<3, double> point_a = Vec<3, double>(0.0);  ///< Of a, nearest to b.
  Vec<3, double> point_b = Vec<3, double>(0.0);
};

/// The rival's opinion; none if it has no such test for these two types.
template <class T>
using SeparationAnswer = std::optional<Separation> (*)(const Solid3<T>& a, const Solid3<T>& b);

template <class T>
struct DistanceRival {
  std::string_view name;
  SeparationAnswer<T> answer;
};

/// Bullet's btGjkPairDetector with EPA behind it, as in rival.hpp.
std::optional<Separation> bullet_separation(const Solid3<float>& a, const Solid3<float>& b);

/// What fcl::distance asks for two shapes, with nearest points, by FCL's own GJK; of triangles its tests for them. Not
/// of planes and half-spaces, which its GJK has no supports of.
std::optional<Separation> fcl_separation(const Solid3<float>& a, const Solid3<float>& b);
std::optional<Separation> fcl_separation(const Solid3<double>& a, const Solid3<double>& b);

/// The same by the GJK that FCL has built on parts of libccd, which is its default. In float alone: in double, as
/// Debian builds it, an assertion of that GJK ends the program among these cases.
std::optional<Separation> fcl_separation_by_libccd(const Solid3<float>& a, const Solid3<float>& b);

inline constexpr std::array<DistanceRival<float>, 3> float_distance_rivals = {
    {{"Bullet", bullet_separation}, {"FCL", fcl_separation}, {"FCL, libccd", fcl_separation_by_libccd}}};
inline constexpr std::array<DistanceRival<double>, 1> double_distance_rivals = {{{"FCL", fcl_separation}}};

template <class T>
constexpr const auto& distance_rivals() {
  if constexpr (std::is_same_v<T, float>) {
    return float_distance_rivals;
  } else {
    return double_distance_rivals;
  }
}

}  // namespace graze::exam
