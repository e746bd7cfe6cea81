// SPDX-License-Identifier: MIT
// Other programs that say whether two shapes in space meet. Each is one file, rival_<name>.cpp.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::exam {

template <class T>
using Solid3 = AnyShape<3, T>;

/// Whether a and b share a point, in the rival's opinion; none if it has no test for these two types.
template <class T>
using Answer = std::optional<bool> (*)(const Solid3<T>& a, const Solid3<T>& b);

template <class T>
struct Rival {
  std::string_view name;
  Answer<T> answer;
};

/// Bullet's narrow phase for convex pairs: btGjkPairDetector with EPA behind it, in float. Boxes, triangles and hulls
/// without margin, so that they are no larger than they should be; the radius of spheres and capsules is theirs.
std::optional<bool> bullet_answer(const Solid3<float>& a, const Solid3<float>& b);

/// FCL's fcl::collide with its own GJK; of triangles the tests that it uses for meshes.
std::optional<bool> fcl_answer(const Solid3<float>& a, const Solid3<float>& b);
std::optional<bool> fcl_answer(const Solid3<double>& a, const Solid3<double>& b);

/// libccd's ccdGJKIntersect, which Debian builds for double.
std::optional<bool> libccd_answer(const Solid3<double>& a, const Solid3<double>& b);

/// ODE's dCollide, which Debian builds for double: spheres, boxes, capsules, and half-spaces, which it calls planes.
std::optional<bool> ode_answer(const Solid3<double>& a, const Solid3<double>& b);

/// The formulas of textbook.hpp.
std::optional<bool> textbook_answer(const Solid3<float>& a, const Solid3<float>& b);
std::optional<bool> textbook_answer(const Solid3<double>& a, const Solid3<double>& b);

inline constexpr std::array<Rival<float>, 3> float_rivals = {
    {{"textbook", textbook_answer}, {"Bullet", bullet_answer}, {"FCL", fcl_answer}}};
inline constexpr std::array<Rival<double>, 4> double_rivals = {
    {{"textbook", textbook_answer}, {"FCL", fcl_answer}, {"libccd", libccd_answer}, {"ODE", ode_answer}}};

template <class T>
constexpr const auto& rivals() {
  if constexpr (std::is_same_v<T, float>) {
    return float_rivals;
  } else {
    return double_rivals;
  }
}

/// A gap or depth that each must get right, relative to the largest coordinate of the shapes and of their differences:
/// 8 epsilon in float, 4500 in double.
template <class T>
inline constexpr double fair_gap = std::is_same_v<T, float> ? 1e-6 : 1e-12;

}  // namespace graze::exam
