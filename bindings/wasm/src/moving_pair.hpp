// SPDX-License-Identifier: MIT
// time_of_impact for shapes of which only the running program knows the types.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include <graze/math/motion.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/time_of_impact.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::wasm {

/// When the shapes first touch. Throws std::invalid_argument for types that time_of_impact does not take.
template <Dim N>
std::optional<Impact<N, double>> impact_of_moving(const AnyShape<N, double>& a, const Motion<N, double>& motion_a,
                                                  const AnyShape<N, double>& b, const Motion<N, double>& motion_b) {
  const auto answer = [&](const auto& own, const auto& other) -> std::optional<Impact<N, double>> {
    if constexpr (requires { time_of_impact(own, motion_a, other, motion_b); }) {
      return time_of_impact(own, motion_a, other, motion_b);
    } else {
      throw std::invalid_argument(
          "timeOfImpact: one shape must be convex and bounded, the other too, or a plane or a "
          "half-space; these are a " +
          std::string(type_name(a)) + " and a " + std::string(type_name(b)));
    }
  };
  return std::visit(answer, a, b);
}

}  // namespace graze::wasm
