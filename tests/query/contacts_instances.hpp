// SPDX-License-Identifier: MIT
// The definitions behind contacts.hpp, for the files that instantiate them.
#pragma once

#include <graze/query/contact.hpp>

#include "query/contacts.hpp"

namespace graze::test {

template <Dim N, class T>
std::optional<Contact<N, T>> contact_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return contact(a, b);
}

template <Dim N, class T>
std::optional<detail::Penetration<N>> penetration_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return detail::penetration(a, b);
}

}  // namespace graze::test
