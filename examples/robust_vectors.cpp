// SPDX-License-Identifier: MIT
// Lengths, directions and normals where the usual formulas fail: squares that overflow or underflow, and vectors that
// are almost parallel. And floats that are calculated with in double, as graze does.
#include <cmath>
#include <cstdio>

#include <graze/graze.hpp>
#include <graze/math/rounding.hpp>

using Vec3 = graze::Vec<3, double>;

/// The length, even if its square overflows or underflows. Multiplying by a power of two is exact.
double length_of(const Vec3& v) {
  const double scale = graze::scale_to_moderate(graze::max_abs(v));
  return std::sqrt(graze::length_squared<3, double>(v * scale)) / scale;
}

/// The direction of any nonzero vector.
Vec3 direction_of(const Vec3& v) {
  const Vec3 moderate = graze::of_moderate_size(v);
  return moderate / std::sqrt(dot(moderate, moderate));
}

int main() {
  const Vec3 huge(3e200, 4e200, 0);
  const Vec3 tiny(0, 3e-200, 4e-200);
  std::printf("lengths %g and %g; by their squares %g and %g\n", length_of(huge), length_of(tiny),
              std::sqrt(dot(huge, huge)), std::sqrt(dot(tiny, tiny)));

  // The normal of a triangle that is almost a line.
  const double n = 94906266;
  const Vec3 edge(n + 1, n, 0);
  const Vec3 other_edge(n, n - 1, 0);
  const Vec3 rounded = cross(edge, other_edge);
  const Vec3 accurate = graze::accurate_cross(edge, other_edge);
  std::printf("twice its area: %g, by doubles %g\n", std::fabs(accurate.z), std::fabs(rounded.z));

  // A corner of a box far from the origin: in float, the corner loses what the size says.
  const graze::Obb<3> box{{16777216, 0, 0}, {0.5F, 0.5F, 0.5F}};
  const Vec3 corner = graze::wide<3, float>(box.center) +
                      graze::wide_matrix<3, float>(box.axes) * graze::wide<3, float>(box.half_extents);
  std::printf("it reaches to %.1f, in float to %.1f\n", corner.x, box.center.x + box.half_extents.x);

  const Vec3 up = direction_of(tiny);
  const bool is_long =
      std::fabs(length_of(huge) / 5e200 - 1) < 1e-15 && std::fabs(length_of(tiny) / 5e-200 - 1) < 1e-15;
  const bool is_right = std::fabs(up.y - 0.6) < 1e-15 && accurate == Vec3(0, 0, -1) && rounded.z != -1;
  return is_long && is_right && corner.x == 16777216.5 ? 0 : 1;
}
