// SPDX-License-Identifier: MIT
// Fast contacts of spheres and 2D boxes, by sphere_2d-inl.hpp. Include manifold.hpp.
#pragma once

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/fast_contact/cores_2d.hpp>
#include <graze/query/fast_contact/fast_result.hpp>
#include <graze/query/fast_contact/one_pair.hpp>
#include <graze/query/fast_contact/spheres_and_capsules.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::detail::one_pair {
#include <graze/query/fast_contact/sphere_2d-inl.hpp>
}  // namespace graze::detail::one_pair

namespace graze::detail {

template <class T, class Box>
[[gnu::always_inline]] inline FastContact<2> look_at_sphere_2d(const Sphere<2, T>& sphere, const Box& box, bool turns) {
  const auto numbers = one_pair::numbers_of(sphere);
  const auto core = one_pair::core_2d(one_pair::numbers_of(box), numbers.center);
  return fast_contact_of(one_pair::SphereOnBox2d(numbers, core).run(), turns);
}

template <class T>
[[gnu::always_inline]] inline FastContact<2> find_fast_contact(const Sphere<2, T>& sphere, const Aabb<2, T>& box,
                                                               bool turns) {
  return look_at_sphere_2d(sphere, box, turns);
}
template <class T>
[[gnu::always_inline]] inline FastContact<2> find_fast_contact(const Sphere<2, T>& sphere, const Obb<2, T>& box,
                                                               bool turns) {
  return look_at_sphere_2d(sphere, box, turns);
}

}  // namespace graze::detail
