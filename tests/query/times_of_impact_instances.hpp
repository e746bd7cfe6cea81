// SPDX-License-Identifier: MIT
// The definitions behind times_of_impact.hpp, for the files that instantiate them.
#pragma once

#include <variant>

#include <graze/query/time_of_impact.hpp>

#include "query/times_of_impact.hpp"

namespace graze::test {

template <class A, class B>
inline constexpr bool have_time = requires(const A& a, const B& b, const MotionIn<A>& motion) {
  time_of_impact(a, motion, b, motion);
};

template <Dim N, class T>
bool may_move(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return std::visit([]<class A, class B>(const A&, const B&) { return have_time<A, B>; }, a, b);
}

template <Dim N, class T>
std::optional<Impact<N, T>> impact_of(const Moving<N, T>& moving) {
  return std::visit(
      [&]<class A, class B>(const A& a, const B& b) -> std::optional<Impact<N, T>> {
        if constexpr (have_time<A, B>) {
          return time_of_impact(a, moving.motion_a, b, moving.motion_b);
        } else {
          return std::nullopt;
        }
      },
      moving.a, moving.b);
}

template <Dim N, class T>
std::optional<detail::Strike<N>> strike_of(const Moving<N, T>& moving) {
  return std::visit(
      [&]<class A, class B>(const A& a, const B& b) -> std::optional<detail::Strike<N>> {
        if constexpr (have_time<A, B>) {
          return detail::strike_in_motion(a, detail::wide_motion(moving.motion_a), b,
                                          detail::wide_motion(moving.motion_b));
        } else {
          return std::nullopt;
        }
      },
      moving.a, moving.b);
}

}  // namespace graze::test
