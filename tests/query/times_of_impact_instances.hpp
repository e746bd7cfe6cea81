// SPDX-License-Identifier: MIT
// The definitions behind times_of_impact.hpp, for the files that instantiate them.
#pragma once

#include <optional>

#include <graze/query/time_of_impact.hpp>

#include "query/contacts.hpp"
#include "query/times_of_impact.hpp"

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
