// SPDX-License-Identifier: MIT
#include <cstddef>
#include <exception>
#include <limits>
#include <optional>
#include <type_traits>
#include <variant>

#include <fcl/narrowphase/continuous_collision.h>

#include <graze/math/motion.hpp>
#include <graze/math/vec.hpp>

#include "exam/cast_rival.hpp"
#include "exam/fcl_shapes.hpp"
#include "exam/impact_rival.hpp"
#include "query/times_of_impact.hpp"

namespace graze::exam {
namespace {

using Pose3 = fcl::Transform3<double>;

/// When two shapes that go from their poses to others first meet.
template <class First, class Second>
Meeting meeting(const Placed<First, double>& a, const Pose3& end_a, const Placed<Second, double>& b, const Pose3& end_b,
                fcl::CCDMotionType motion_type) {
  constexpr std::size_t most_steps = 100;
  fcl::ContinuousCollisionRequest<double> request;
  request.num_max_iterations = most_steps;
  request.ccd_motion_type = motion_type;
  request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
  request.gjk_solver_type = fcl::GST_INDEP;
  fcl::ContinuousCollisionResult<double> result;
  fcl::continuousCollide(&a.shape, a.pose, end_a, &b.shape, b.pose, end_b, request, result);
  return {result.is_collide, result.time_of_contact};
}

/// What `meet` says of both as FCL has them; none if it has not. It may give up with an exception.
template <class Meet>
std::optional<Meeting> meeting_of(const Solid3<double>& a, const Solid3<double>& b, const Meet& meet) {
  try {
    return std::visit(
        [&meet](const auto& held_a, const auto& held_b) -> std::optional<Meeting> {
          using A = std::decay_t<decltype(held_a)>;
          using B = std::decay_t<decltype(held_b)>;
          if constexpr (is_level<A> || is_level<B>) {
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

/// Of a shape whose own middle is where it turns about.
Pose3 end_of(const Pose3& start, const Motion<3, double>& motion) {
  Pose3 end = start;
  const fcl::Vector3<double> turn = vector(motion.angular);
  if (turn.norm() > 0) {
    end.linear() = Eigen::AngleAxis<double>(turn.norm(), turn.normalized()).toRotationMatrix() * start.linear();
  }
  end.translation() += vector(motion.linear);
  return end;
}

}  // namespace

std::optional<Meeting> fcl_meeting(const Solid3<double>& a, const Vec<3, double>& motion, const Solid3<double>& b) {
  return meeting_of(a, b, [&motion](const auto& placed_a, const auto& placed_b) {
    Pose3 end = placed_a.pose;
    end.translation() += vector(motion);
    return meeting(placed_a, end, placed_b, placed_b.pose, fcl::CCDM_TRANS);
  });
}

std::optional<Meeting> fcl_impact(const test::Moving<3, double>& moving) {
  return meeting_of(moving.a, moving.b, [&moving](const auto& a, const auto& b) {
    return meeting(a, end_of(a.pose, moving.motion_a), b, end_of(b.pose, moving.motion_b), fcl::CCDM_LINEAR);
  });
}

}  // namespace graze::exam
