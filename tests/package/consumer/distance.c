/* SPDX-License-Identifier: MIT */
#include <graze.h>

int main(void) {
  const graze_vec origin = {0, 0, 0}, right = {5, 0, 0};
  const graze_shape a = graze_make_sphere(GRAZE_3D, origin, 1), b = graze_make_sphere(GRAZE_3D, right, 1);
  double distance = 0;
  return graze_version() == GRAZE_VERSION && graze_distance(&a, &b, &distance) == GRAZE_OK && distance == 3 ? 0 : 1;
}
