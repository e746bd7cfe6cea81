// SPDX-License-Identifier: MIT
// Fast contacts of spheres and capsules, by spheres_and_capsules-inl.hpp. Include manifold.hpp.
#pragma once

#include <type_traits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/fast_contact/fast_result.hpp>
#include <graze/query/fast_contact/one_pair.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::detail::one_pair {
#include <graze/query/fast_contact/spheres_and_capsules-inl.hpp>

template <Dim N, class T>
[[gnu::always_inline]] inline SphereNumbers<Vec<N, double>> numbers_of(const Sphere<N, T>& sphere) {
  return {wide<N, T>(sphere.center), static_cast<double>(sphere.radius)};
}
template <Dim N, class T>
[[gnu::always_inline]] inline CapsuleNumbers<Vec<N, double>> numbers_of(const Capsule<N, T>& capsule) {
  return {wide<N, T>(capsule.a), wide<N, T>(capsule.b), static_cast<double>(capsule.radius)};
}
}  // namespace graze::detail::one_pair

namespace graze::detail {

/// What was calculated from the first to the second, or from the second to the first if it turns.
template <class P>
[[gnu::always_inline]] inline FastContact<vec_dimension<P>> fast_contact_of(const one_pair::RoundContact<P>& contact,
                                                                            bool turns) {
  FastContact<vec_dimension<P>> result;
  result.is_known = contact.is_apart || contact.meets;
  result.meets = contact.meets;
  result.is_single = contact.is_single;
  result.set(contact.normal, contact.depth, contact.on_first, contact.on_second, turns);
  result.feature_a = one_pair::feature_of(turns ? contact.of_second : contact.of_first);
  result.feature_b = one_pair::feature_of(turns ? contact.of_first : contact.of_second);
  result.found.error = contact.error;
  return result;
}

template <Dim N, class T>
FastContact<N> find_fast_contact(const Sphere<N, T>& a, const Sphere<N, T>& b, bool turns) {
  return fast_contact_of(one_pair::contact_of(one_pair::numbers_of(a), one_pair::numbers_of(b)), turns);
}
template <Dim N, class T>
FastContact<N> find_fast_contact(const Sphere<N, T>& sphere, const Capsule<N, T>& capsule, bool turns) {
  return fast_contact_of(one_pair::contact_of(one_pair::numbers_of(sphere), one_pair::numbers_of(capsule)), turns);
}
template <class T>
FastContact<3> find_fast_contact(const Capsule<3, T>& a, const Capsule<3, T>& b, bool turns) {
  const bool is_first = is_in_order(a, b);
  const Capsule<3, T>& first = is_first ? a : b;
  const Capsule<3, T>& second = is_first ? b : a;
  return fast_contact_of(one_pair::contact_of(one_pair::numbers_of(first), one_pair::numbers_of(second)),
                         turns == is_first);
}

}  // namespace graze::detail
