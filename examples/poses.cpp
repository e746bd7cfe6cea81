// SPDX-License-Identifier: MIT
// A door that swings open: poses that place a shape, and the motion that leads from one pose to another.
#include <cstdio>
#include <numbers>

#include <graze/graze.hpp>

using Pose = graze::Pose<3, double>;
using Vec3 = graze::Vec<3, double>;

bool is_near(const Vec3& a, const Vec3& b) { return graze::max_abs<3, double>(a - b) < 1e-12; }

int main() {
  const Vec3 hinge(2, 0, 0);
  const Pose closed{.position = hinge};
  const Pose open = Pose::from_axis_angle(hinge, graze::unit_axis<3>(2), std::numbers::pi / 2);
  const Pose also_open = Pose::from_quaternion(hinge, graze::Vec<4, double>(0, 0, 1, 1));

  // A pose moves points and shapes, and only turns directions.
  const graze::Aabb<3, double> door{{0, -0.05, 0}, {1, 0.05, 2}};  // the hinge is at the origin
  const Vec3 knob(0.9, 0.1, 1);
  const Vec3 outward(0, 1, 0);
  const Vec3 knob_when_open = graze::transformed(knob, open);
  const graze::Obb<3, double> open_door = graze::transformed(graze::oriented(door), open);
  const graze::Mat<3, double> edges = graze::half_edges(open_door);  // from its center to the middles of its faces
  std::printf("the door is %.1f wide along y; the knob goes to (%.1f, %.1f, %.1f)\n", 2 * edges[0].y, knob_when_open.x,
              knob_when_open.y, knob_when_open.z);

  // Halfway from closed to open. The shape is the one at the start.
  const graze::Motion<3, double> swing = graze::motion_between(closed, open);
  const Pose halfway = graze::pose_at(swing, 0.5);
  const graze::Obb<3, double> ajar = graze::transformed(graze::transformed(door, closed), halfway);
  std::printf("halfway its center is at (%.2f, %.2f)\n", ajar.center.x, ajar.center.y);

  // In 2D the angle is enough, and a shape that only moves keeps its type.
  const auto tilted = graze::Pose<2>::from_angle({0, 1}, std::numbers::pi / 6);
  const graze::Vec<2> slope = graze::rotated(graze::Vec<2>(1, 0), tilted);
  const graze::AnyShape<2> moved = graze::translated(graze::AnyShape<2>(graze::Rect<>{{0, 0}, {1, 1}}), {3, 0});
  std::printf("a slope along (%.2f, %.2f), and a moved shape of type %s\n", slope.x, slope.y,
              graze::type_name(moved).data());

  const bool is_open = is_near(knob_when_open, {1.9, 0.9, 1}) && is_near(graze::rotated(outward, open), {-1, 0, 0}) &&
                       is_near(graze::transformed(knob, also_open), knob_when_open);
  const bool arrives =
      graze::is_finite(swing) && is_near(graze::transformed(hinge, graze::pose_at(swing, 1)), hinge) &&
      is_near(graze::transformed(graze::transformed(knob, closed), graze::pose_at(swing, 1)), knob_when_open);
  return is_open && arrives && is_near(open_door.center, {2, 0.5, 1}) && moved.index() == 4 ? 0 : 1;
}
