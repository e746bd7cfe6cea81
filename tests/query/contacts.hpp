// SPDX-License-Identifier: MIT
// graze's contacts of any two shapes: compiled once for each space, by contacts.cpp.in, because hundreds of pairs take
// long to compile.
#pragma once

#include <optional>

#include <graze/math/vec.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/cores/penetration.hpp>
#include <graze/shape/any_shape.hpp>

// Also compiled there, for the other files of instances.
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

/// contact(a, b) before it is rounded to T.
template <Dim N, class T>
std::optional<detail::Penetration<N>> penetration_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b);

}  // namespace graze::test
