// SPDX-License-Identifier: MIT
// The definitions behind times_of_impact.hpp, for the files that instantiate them.
#pragma once

#include <optional>

#include <graze/query/time_of_impact.hpp>

#include "query/times_of_impact.hpp"

// Compiled in contacts_*.cpp.
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

template <Dim N, class T>
std::optional<Impact<N, T>> impact_of(const Moving<N, T>& moving) {
  return time_of_impact(moving.a, moving.motion_a, moving.b, moving.motion_b);
}

template <Dim N, class T>
std::optional<detail::Strike<N>> strike_of(const Moving<N, T>& moving) {
  return detail::strike_in_motion(moving.a, detail::wide_motion(moving.motion_a), moving.b,
                                  detail::wide_motion(moving.motion_b));
}

}  // namespace graze::test
