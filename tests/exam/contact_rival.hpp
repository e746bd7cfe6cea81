// SPDX-License-Identifier: MIT
// Other programs that say how deep two shapes in space are in each other. Each is one file, rival_<name>.cpp.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>

#include <graze/math/vec.hpp>

#include "exam/rival.hpp"

namespace graze::exam {

/// What a program says of two shapes.
struct Parting {
  bool meets = false;
  double depth = 0;
  Vec<3, double> normal = Vec<3, double>(0.0);  ///< From a to b, of length 1; only where they meet.
  bool is_either_way = false;                   ///< It gives the normal in no certain direction: the better one counts.
};

/// The rival's opinion; none if it has no such test for these two types.
template <class T>
using PartingAnswer = std::optional<Parting> (*)(const Solid3<T>& a, const Solid3<T>& b);

template <class T>
struct ContactRival {
  std::string_view name;
  PartingAnswer<T> answer;
};

/// Bullet's btGjkPairDetector with EPA behind it, as in rival.hpp.
std::optional<Parting> bullet_parting(const Solid3<float>& a, const Solid3<float>& b);

/// fcl::collide with contacts; of triangles the test for shapes, but not the one for two of them, whose depth is over
/// their planes alone. Where its own GJK answers, depths come with either sign, and so do normals: they are taken
/// without.
std::optional<Parting> fcl_parting(const Solid3<float>& a, const Solid3<float>& b);
std::optional<Parting> fcl_parting(const Solid3<double>& a, const Solid3<double>& b);

/// libccd's ccdGJKPenetration.
std::optional<Parting> libccd_parting(const Solid3<double>& a, const Solid3<double>& b);

/// The deepest of the contacts that ODE's dCollide gives.
std::optional<Parting> ode_parting(const Solid3<double>& a, const Solid3<double>& b);

/// The formulas of textbook_depth.hpp.
std::optional<Parting> textbook_parting(const Solid3<float>& a, const Solid3<float>& b);
std::optional<Parting> textbook_parting(const Solid3<double>& a, const Solid3<double>& b);

inline constexpr std::array<ContactRival<float>, 3> float_contact_rivals = {
    {{"textbook", textbook_parting}, {"Bullet", bullet_parting}, {"FCL", fcl_parting}}};
inline constexpr std::array<ContactRival<double>, 4> double_contact_rivals = {
    {{"textbook", textbook_parting}, {"FCL", fcl_parting}, {"libccd", libccd_parting}, {"ODE", ode_parting}}};

template <class T>
constexpr const auto& contact_rivals() {
  if constexpr (std::is_same_v<T, float>) {
    return float_contact_rivals;
  } else {
    return double_contact_rivals;
  }
}

}  // namespace graze::exam
