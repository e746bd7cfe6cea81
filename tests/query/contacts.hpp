// SPDX-License-Identifier: MIT
// graze's contacts of any two shapes.
#pragma once

#include <optional>

#include <graze/math/vec.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/cores/penetration.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test {

/// contact(a, b).
template <Dim N, class T>
std::optional<Contact<N, T>> contact_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return contact(a, b);
}

/// contact(a, b) before it is rounded to T.
template <Dim N, class T>
std::optional<detail::Penetration<N>> penetration_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return detail::penetration(a, b);
}

}  // namespace graze::test
