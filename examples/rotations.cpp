// SPDX-License-Identifier: MIT
// The same rotation from an angle, from an axis, from a quaternion and from a rotation vector. The results have the
// same bits on every machine, which std::cos and std::sin do not promise.
#include <cmath>
#include <cstdio>
#include <numbers>

#include <graze/graze.hpp>

using Vec3 = graze::Vec<3, double>;
using Mat3 = graze::Mat<3, double>;

double difference(const Mat3& a, const Mat3& b) {
  double largest = 0;
  for (graze::Dim i = 0; i < 3; ++i) largest = std::fmax(largest, graze::max_abs<3, double>(a[i] - b[i]));
  return largest;
}

int main() {
  constexpr double third = 2 * std::numbers::pi / 3;   // a third of a turn about the diagonal permutes the axes
  const Vec3 diagonal(1, 1, 1);                        // axes and quaternions may have any length but zero
  const graze::Vec<4, double> quaternion(1, 1, 1, 1);  // x, y, z, w; w is the real part
  const Mat3 by_axis = graze::rotation_from_axis_angle(diagonal, third);
  const Mat3 by_quaternion = graze::rotation_from_quaternion(quaternion);
  const Mat3 by_vector =
      graze::rotation_of(diagonal * (third / std::sqrt(3.0)));  // along the axis, as long as the angle
  std::printf("they differ by %.1g and %.1g\n", difference(by_axis, by_quaternion), difference(by_axis, by_vector));

  // Degrees are exact at the multiples of 90; radians are not, because pi is not.
  const graze::Vec<2, double> in_degrees = graze::cosine_sine_of_degrees(90);
  const graze::Vec<2, double> in_radians = graze::cosine_sine(std::numbers::pi / 2);
  std::printf("the cosine of a right angle is %g in degrees, %.1g in radians\n", std::fabs(in_degrees.x), in_radians.x);

  // Boxes turned about their centers.
  const auto plank = graze::OrientedRect<double>::from_angle({0, 0}, {4, 1}, std::numbers::pi / 4);
  const auto crate = graze::Obb<3, double>::from_axis_angle({0, 0, 0}, {1, 2, 3}, diagonal, third);
  const auto same_crate = graze::Obb<3, double>::from_quaternion({0, 0, 0}, {1, 2, 3}, quaternion);
  const graze::Aabb<3, double> box = graze::bounds(crate);
  std::printf("the crate is now %.0f x %.0f x %.0f\n", box.max.x - box.min.x, box.max.y - box.min.y,
              box.max.z - box.min.z);

  // A matrix from elsewhere is a rotation if its columns are orthonormal.
  const double skew = graze::orthonormal_error<3, double>(same_crate.axes);
  const double scaled = graze::orthonormal_error<2, double>(graze::rotation_from_angle(1) * 1.5);
  std::printf("the error of a rotation is %.1g, that of a scaled one %.2f\n", skew, scaled);

  const bool are_equal = difference(by_axis, by_quaternion) < 1e-15 && difference(by_axis, by_vector) < 1e-15;
  const bool is_turned = std::fabs(box.max.x - 3) < 1e-12 && std::fabs(plank.axes[0].x - plank.axes[0].y) < 1e-15;
  return are_equal && is_turned && in_degrees == graze::Vec<2, double>(0, 1) && skew < 1e-15 && scaled > 1 ? 0 : 1;
}
