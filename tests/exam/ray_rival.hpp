// SPDX-License-Identifier: MIT
// Other programs that say where a ray hits a shape in space. Each is one file, rival_<name>.cpp.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>

#include <graze/math/vec.hpp>

#include "exam/rival.hpp"

namespace graze::exam {

/// What a program says of a ray.
struct RayVerdict {
  bool hits = false;
  double distance = 0;  ///< From the origin, only if it hits.
};

/// The rival's opinion, of the ray up to a length of `reach` if it has to have an end; none if it has no such test for
/// this type.
template <class T>
using SightAnswer = std::optional<RayVerdict> (*)(const Solid3<T>& shape, const Ray<3, T>& ray, double reach);

template <class T>
struct RayRival {
  std::string_view name;
  SightAnswer<T> answer;
};

/// Bullet's btCollisionWorld::rayTestSingle, shapes without margin as in rival.hpp.
std::optional<RayVerdict> bullet_sight(const Solid3<float>& shape, const Ray<3, float>& ray, double reach);

/// ODE's dCollide of a ray: spheres, boxes, capsules.
std::optional<RayVerdict> ode_sight(const Solid3<double>& shape, const Ray<3, double>& ray, double reach);

/// The formulas of textbook_ray.hpp.
std::optional<RayVerdict> textbook_sight(const Solid3<float>& shape, const Ray<3, float>& ray, double reach);
std::optional<RayVerdict> textbook_sight(const Solid3<double>& shape, const Ray<3, double>& ray, double reach);

inline constexpr std::array<RayRival<float>, 2> float_ray_rivals = {
    {{"textbook", textbook_sight}, {"Bullet", bullet_sight}}};
inline constexpr std::array<RayRival<double>, 2> double_ray_rivals = {
    {{"textbook", textbook_sight}, {"ODE", ode_sight}}};

template <class T>
constexpr const auto& ray_rivals() {
  if constexpr (std::is_same_v<T, float>) {
    return float_ray_rivals;
  } else {
    return double_ray_rivals;
  }
}

}  // namespace graze::exam
