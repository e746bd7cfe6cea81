// SPDX-License-Identifier: MIT
// Other programs that say where two shapes in space lie on each other: all the points of their contact. Each is one
// file, rival_<name>.cpp. libccd gives one point, whatever the shapes.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include <graze/math/vec.hpp>

#include "exam/rival.hpp"

namespace graze::exam {

/// One point of a contact.
struct PatchPoint {
  Vec<3, double> place = Vec<3, double>(0.0);  ///< Of one of the shapes, or between them.
  double depth = 0;
};

/// What a program says of two shapes; no points if they are apart.
using ContactPatch = std::vector<PatchPoint>;

/// The rival's opinion; none if it has no such test for these two types.
template <class T>
using PatchAnswer = std::optional<ContactPatch> (*)(const Solid3<T>& a, const Solid3<T>& b);

template <class T>
struct ManifoldRival {
  std::string_view name;
  PatchAnswer<T> answer;
};

/// Bullet's btBoxBoxDetector for two boxes; of others the one point of btGjkPairDetector. Bullet gathers more of those
/// from step to step.
std::optional<ContactPatch> bullet_patch(const Solid3<float>& a, const Solid3<float>& b);

/// All contacts of fcl::collide, up to eight, as in contact_rival.hpp.
std::optional<ContactPatch> fcl_patch(const Solid3<float>& a, const Solid3<float>& b);
std::optional<ContactPatch> fcl_patch(const Solid3<double>& a, const Solid3<double>& b);

/// All contacts of ODE's dCollide, up to eight.
std::optional<ContactPatch> ode_patch(const Solid3<double>& a, const Solid3<double>& b);

inline constexpr std::array<ManifoldRival<float>, 2> float_manifold_rivals = {
    {{"Bullet", bullet_patch}, {"FCL", fcl_patch}}};
inline constexpr std::array<ManifoldRival<double>, 2> double_manifold_rivals = {
    {{"FCL", fcl_patch}, {"ODE", ode_patch}}};

template <class T>
constexpr const auto& manifold_rivals() {
  if constexpr (std::is_same_v<T, float>) {
    return float_manifold_rivals;
  } else {
    return double_manifold_rivals;
  }
}

}  // namespace graze::exam
