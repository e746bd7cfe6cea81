// SPDX-License-Identifier: MIT
// What graze says about the contact of any two shapes: compiled once for each space, by contacts.cpp.in, because
// hundreds of pairs take their time.
#pragma once

#include <optional>

#include <graze/math/vec.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/cores/penetration.hpp>
#include <graze/shape/any_shape.hpp>

// Compiled there as well, for the other files of instances.
namespace graze {
extern template std::optional<detail::Penetration<2>> detail::penetration(const AnyShape<2, float>&,
                                                                          const AnyShape<2, float>&);
extern template std::optional<detail::Penetration<2>> detail::penetration(const AnyShape<2, double>&,
                                                                          const AnyShape<2, double>&);
extern template std::optional<detail::Penetration<3>> detail::penetration(const AnyShape<3, float>&,
                                                                          const AnyShape<3, float>&);
extern template std::optional<detail::Penetration<3>> detail::penetration(const AnyShape<3, double>&,
                                                                          const AnyShape<3, double>&);
}  // namespace graze

namespace graze::test {

/// contact(a, b).
template <Dim N, class T>
std::optional<Contact<N, T>> contact_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b);

/// What contact(a, b) rounds to T.
template <Dim N, class T>
std::optional<detail::Penetration<N>> penetration_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b);

}  // namespace graze::test
