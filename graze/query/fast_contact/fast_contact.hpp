// SPDX-License-Identifier: MIT
// fast_contact(a, b): a fast contact of two shapes, in any order, if there is one for their types.
#pragma once

#include <graze/query/fast_contact/boxes_2d.hpp>
#include <graze/query/fast_contact/capsule_box.hpp>
#include <graze/query/fast_contact/fast_result.hpp>
#include <graze/query/fast_contact/half_space.hpp>
#include <graze/query/fast_contact/sphere_2d.hpp>
#include <graze/query/fast_contact/sphere_box.hpp>
#include <graze/query/fast_contact/sphere_triangle.hpp>
#include <graze/query/fast_contact/spheres_and_capsules.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// Whether there is a fast contact of two shapes in this order.
template <class A, class B>
concept HasFastContact = requires(const A& a, const B& b) {
  find_fast_contact(a, b, false);
};

template <class A, class B>
inline constexpr bool has_fast_contact = HasFastContact<A, B> || HasFastContact<B, A>;

/// A FastContact, or a class derived from it, with the normal from the first shape to the second.
template <class A, class B>
requires has_fast_contact<A, B>
auto fast_contact(const A& a, const B& b) {
  if constexpr (HasFastContact<A, B>) {
    return find_fast_contact(a, b, false);
  } else {
    return find_fast_contact(b, a, true);
  }
}

}  // namespace graze::detail
