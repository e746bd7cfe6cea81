// SPDX-License-Identifier: MIT
// The definitions behind shape_casts.hpp, for the files that instantiate them.
#pragma once

#include <graze/query/shape_cast.hpp>

#include "query/contacts.hpp"
#include "query/shape_casts.hpp"

namespace graze::test {

template <Dim N, class T>
std::optional<Impact<N, T>> impact_of(const AnyShape<N, T>& a, const Vec<N, T>& motion, const AnyShape<N, T>& b) {
  return detail::impact_of(a, motion, b);
}

template <Dim N, class T>
std::optional<detail::Strike<N>> strike_of(const AnyShape<N, T>& a, const Vec<N, T>& motion, const AnyShape<N, T>& b) {
  if (const auto contact = detail::penetration(a, b)) return detail::strike_at_start(*contact);
  return max_abs(motion) == T(0) ? std::nullopt : detail::strike(a, wide<N, T>(motion), b);
}

}  // namespace graze::test
