// SPDX-License-Identifier: MIT
// A box in float that is certain to contain what was calculated in double, because every step rounds outward.
#include <cmath>
#include <cstdio>

#include <graze/graze.hpp>

struct Drone {
  graze::Vec<3, double> center;
  graze::Vec<3, double> top_speed;  ///< Along each axis.
  double radius;
};

/// Everywhere the drone can be within `seconds`.
graze::Aabb<3> reach_of(const Drone& drone, double seconds) {
  graze::Aabb<3> box = graze::Aabb<3>::nothing();
  if (!graze::is_finite(drone.center)) return box;
  for (graze::Dim i = 0; i < 3; ++i) {
    const double reach = graze::add_up(drone.radius, graze::multiply_up(drone.top_speed[i], seconds));
    box.min[i] = graze::round_down<float>(graze::add_down(drone.center[i], -reach));
    box.max[i] = graze::round_up<float>(graze::add_up(drone.center[i], reach));
  }
  return box;
}

int main() {
  const Drone drone{{0.1, 1e6, -3}, {0.7, 0.1, 0}, 0.3};
  const graze::Aabb<3> box = reach_of(drone, 1.0 / 3);
  std::printf("x from %.9f to %.9f\n", static_cast<double>(box.min.x), static_cast<double>(box.max.x));

  // No smaller box of floats contains it.
  const double right = drone.center.x + drone.radius + drone.top_speed.x / 3;
  const double left = drone.center.x - drone.radius - drone.top_speed.x / 3;
  const bool contains_it = static_cast<double>(box.max.x) >= right && static_cast<double>(box.min.x) <= left;
  const bool is_tight =
      static_cast<double>(graze::next_down(box.max.x))<right&& static_cast<double>(graze::next_up(box.min.x))> left;

  // The speed lies between these two, and neither takes a square root.
  const double speed = std::sqrt(graze::length_squared(drone.top_speed));
  std::printf("speed %.3f, from %.3f to %.3f\n", speed, graze::max_abs(drone.top_speed),
              graze::sum_abs(drone.top_speed));

  const bool is_lost = graze::is_nothing(reach_of({{NAN, 0, 0}, {1, 1, 1}, 1}, 1));
  return contains_it && is_tight && is_lost && graze::max_abs(drone.top_speed) <= speed &&
                 speed <= graze::sum_abs(drone.top_speed)
             ? 0
             : 1;
}
