// SPDX-License-Identifier: MIT
#include <cstddef>
#include <exception>
#include <limits>
#include <optional>
#include <type_traits>
#include <variant>

#include <fcl/narrowphase/continuous_collision.h>

#include <graze/math/vec.hpp>

#include "exam/cast_rival.hpp"
#include "exam/fcl_shapes.hpp"

namespace graze::exam {
namespace {

template <class First, class Second>
Meeting meeting(const Placed<First, double>& a, const Vec<3, double>& motion, const Placed<Second, double>& b) {
  constexpr std::size_t most_steps = 100;
  fcl::ContinuousCollisionRequest<double> request;
  request.num_max_iterations = most_steps;
  request.ccd_motion_type = fcl::CCDM_TRANS;
  request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
  request.gjk_solver_type = fcl::GST_INDEP;
  fcl::Transform3<double> end = a.pose;
  end.translation() += vector(motion);
  fcl::ContinuousCollisionResult<double> result;
  fcl::continuousCollide(&a.shape, a.pose, end, &b.shape, b.pose, b.pose, request, result);
  return {result.is_collide, result.time_of_contact};
}

std::optional<Meeting> meeting_of(const Solid3<double>& a, const Vec<3, double>& motion, const Solid3<double>& b) {
  return std::visit(
      [&motion](const auto& held_a, const auto& held_b) -> std::optional<Meeting> {
        using A = std::decay_t<decltype(held_a)>;
        using B = std::decay_t<decltype(held_b)>;
        if constexpr (is_level<A> || is_level<B>) {
          return std::nullopt;
        } else if constexpr (requires { placed(held_a), placed(held_b); }) {
          return meeting(placed(held_a), motion, placed(held_b));
        } else {
          return std::nullopt;
        }
      },
      a, b);
}

}  // namespace

std::optional<Meeting> fcl_meeting(const Solid3<double>& a, const Vec<3, double>& motion, const Solid3<double>& b) {
  try {
    return meeting_of(a, motion, b);
  } catch (const std::exception&) {
    return Meeting{true, std::numeric_limits<double>::quiet_NaN()};
  }
}

}  // namespace graze::exam
