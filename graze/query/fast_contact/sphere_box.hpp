// SPDX-License-Identifier: MIT
// Fast contacts of spheres and 3D boxes, by sphere_box-inl.hpp. Include manifold.hpp.
#pragma once

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/fast_contact/fast_result.hpp>
#include <graze/query/fast_contact/one_pair.hpp>
#include <graze/query/fast_contact/oriented_box.hpp>
#include <graze/query/fast_contact/spheres_and_capsules.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::detail::one_pair {
#include <graze/query/fast_contact/sphere_box-inl.hpp>
}  // namespace graze::detail::one_pair

namespace graze::detail {

template <bool along, class T, class Box>
[[gnu::always_inline]] inline FastContact<3> look_at_sphere(const Sphere<3, T>& sphere, const Box& box, bool turns) {
  const auto numbers = one_pair::numbers_of(sphere);
  const Obb<3, double> seen = oriented_box_from(numbers.center, box);
  const one_pair::BoxNumbers<along> its_numbers{
      seen.center, seen.half_extents, {seen.axes[0], seen.axes[1], seen.axes[2]}};
  return fast_contact_of(one_pair::SphereOnBox<along>(numbers, its_numbers).run(), turns);
}

template <class T>
[[gnu::always_inline]] inline FastContact<3> find_fast_contact(const Sphere<3, T>& sphere, const Aabb<3, T>& box,
                                                               bool turns) {
  return look_at_sphere<true>(sphere, box, turns);
}
template <class T>
[[gnu::always_inline]] inline FastContact<3> find_fast_contact(const Sphere<3, T>& sphere, const Obb<3, T>& box,
                                                               bool turns) {
  return look_at_sphere<false>(sphere, box, turns);
}

}  // namespace graze::detail
