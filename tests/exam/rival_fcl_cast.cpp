// SPDX-License-Identifier: MIT
#include <cstddef>
#include <exception>
#include <limits>
#include <optional>
#include <type_traits>
#include <variant>

#include <fcl/math/motion/interp_motion.h>
#include <fcl/math/motion/translation_motion.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <graze/math/motion.hpp>
#include <graze/math/vec.hpp>

#include "exam/fcl_shapes.hpp"
#include "exam/rival.hpp"
#include "query/times_of_impact.hpp"

namespace graze::exam {
namespace {

using Pose3 = fcl::Transform3<double>;

/// When two moving shapes first meet.
template <class First, class Second, class Way>
Meeting meeting(const Placed<First, double>& a, const Way& way_a, const Placed<Second, double>& b, const Way& way_b) {
  constexpr std::size_t most_steps = 100;
  fcl::ContinuousCollisionRequest<double> request;
  request.num_max_iterations = most_steps;
  request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
  request.gjk_solver_type = fcl::GST_INDEP;
  fcl::ContinuousCollisionResult<double> result;
  fcl::continuousCollide(&a.shape, &way_a, &b.shape, &way_b, request, result);
  return {result.is_collide, result.time_of_contact};
}

/// Calls `meet` for both shapes in FCL's form; none if unsupported. It may give up with an exception.
template <class Meet>
std::optional<Meeting> meeting_of(const Solid3<double>& a, const Solid3<double>& b, const Meet& meet) {
  try {
    return std::visit(
        [&meet](const auto& held_a, const auto& held_b) -> std::optional<Meeting> {
          using A = std::decay_t<decltype(held_a)>;
          using B = std::decay_t<decltype(held_b)>;
          if constexpr (is_plane_or_half_space<A> || is_plane_or_half_space<B>) {
            return std::nullopt;
          } else if constexpr (requires { placed(held_a), placed(held_b); }) {
            return meet(placed(held_a), placed(held_b));
          } else {
            return std::nullopt;
          }
        },
        a, b);
  } catch (const std::exception&) {
    return Meeting{true, std::numeric_limits<double>::quiet_NaN()};
  }
}

using Glide = fcl::TranslationMotion<double>;

Glide glide(const Pose3& start, const Vec<3, double>& way) {
  Pose3 end = start;
  end.translation() += vector(way);
  return {start, end};
}

using TurningWay = fcl::InterpMotion<double>;

/// Rotates a shape about its own center, which must be set: the motion that fcl::continuousCollide makes from poses
/// alone rotates about an uninitialised point.
TurningWay turning_way(const Pose3& start, const Motion<3, double>& motion) {
  fcl::Matrix3<double> end = start.linear();
  const fcl::Vector3<double> turn = vector(motion.angular);
  if (turn.norm() > 0) end = Eigen::AngleAxis<double>(turn.norm(), turn.normalized()).toRotationMatrix() * end;
  return {start.linear(), start.translation(), end, start.translation() + vector(motion.linear),
          fcl::Vector3<double>::Zero()};
}

}  // namespace

std::optional<Meeting> fcl_meeting(const Solid3<double>& a, const Vec<3, double>& motion, const Solid3<double>& b) {
  return meeting_of(a, b, [&motion](const auto& placed_a, const auto& placed_b) {
    return meeting(placed_a, glide(placed_a.pose, motion), placed_b, glide(placed_b.pose, Vec<3, double>(0.0)));
  });
}

std::optional<Meeting> fcl_impact(const test::Moving<3, double>& moving) {
  return meeting_of(moving.a, moving.b, [&moving](const auto& a, const auto& b) {
    return meeting(a, turning_way(a.pose, moving.motion_a), b, turning_way(b.pose, moving.motion_b));
  });
}

}  // namespace graze::exam
