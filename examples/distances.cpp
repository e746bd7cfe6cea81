// SPDX-License-Identifier: MIT
// The distance of two shapes, their closest points, the depth of an overlap, and how accurate each of these is.
#include <cmath>
#include <cstdio>

#include <graze/graze.hpp>

using Vec3 = graze::Vec<3, double>;

int main() {
  // A closed form: accurate to a few units in the last place of a double.
  const graze::Capsule<3, double> arm{{0, 0, 2}, {3, 0, 2}, 0.5};
  const graze::Obb<3, double> crate = graze::Obb<3, double>::from_axis_angle({5, 0, 0}, {1, 1, 1}, {0, 1, 0}, 0.5);
  const auto nearest = graze::closest_points(arm, crate);
  std::printf("the arm is %.6f from the crate, up to %.0e, at (%.3f, %.3f, %.3f)\n", nearest.distance, nearest.error,
              nearest.point_b.x, nearest.point_b.y, nearest.point_b.z);

  // Any other pair of convex shapes: bounds that enclose the distance.
  const graze::Polytope<3, double> stone =
      graze::convex_hull<3, double>(std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {2, 2, 2}});
  const graze::GjkResult<3> apart = graze::gjk(stone, graze::Sphere<3, double>{{4, 4, 0}, 1});
  std::printf("the distance is between %.12f and %.12f\n", apart.lower, apart.upper);

  // If they overlap, EPA continues from the result of GJK and finds the depth.
  const graze::Sphere<3, double> ball{{1, 1, 1}, 0.5};
  const graze::GjkResult<3> met = graze::gjk(stone, ball);
  const graze::EpaResult<3> depth = graze::epa(stone, ball, met.simplex);
  std::printf("the depth is between %.6f and %.6f: %s\n", depth.lower, depth.upper,
              depth.status == graze::Status::converged ? "as exact as it gets" : "the best bounds found");

  // The height of a point above the ground.
  const graze::HalfSpace<3, double> ground{{0, 0, 2}, 1};  // z <= 0.5; the normal may have any length
  const graze::Plane<3, double> surface = graze::unit_plane(graze::boundary(ground));
  const double height = dot(surface.normal, nearest.point_b) - surface.offset;
  std::printf("the nearest point is %.3f above the ground\n", height);

  const Vec3 between = nearest.point_b - nearest.point_a;
  const bool is_consistent = std::fabs(std::sqrt(dot(between, between)) - nearest.distance) < 1e-12 &&
                             std::fabs(height - (nearest.point_b.z - 0.5)) < 1e-12;
  return is_consistent && apart.lower > 0 && apart.upper - apart.lower < 1e-9 && met.upper <= met.resolution &&
                 depth.lower <= depth.upper && depth.upper > 0.5
             ? 0
             : 1;
}
