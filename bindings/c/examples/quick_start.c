/* SPDX-License-Identifier: MIT */
/* A ball above a tilted box: whether they touch, how far apart they are, and when the falling ball lands. */
#include <graze.h>
#include <stdio.h>
#include <stdlib.h>

/* Ends the program if a call has failed. */
static void require(graze_status status) {
  if (status >= 0) return;
  fprintf(stderr, "%s: %s\n", graze_status_name(status), graze_error_message());
  exit(1);
}

int main(void) {
  const graze_vec center = {0, 0, 0}, half_extents = {2, 1, 2}, above = {0.5, 4, 0}, z = {0, 0, 1}, fall = {0, -10, 0};
  graze_mat axes;
  require(graze_make_rotation(GRAZE_3D, z, 0.3, &axes));
  const graze_shape box = graze_make_obb(GRAZE_3D, center, half_extents, axes);
  const graze_shape ball = graze_make_sphere(GRAZE_3D, above, 1);

  bool is_touching;
  require(graze_intersects(&ball, &box, &is_touching));
  graze_proximity near;
  require(graze_closest_points(&ball, &box, &near));
  printf("they %s, %.3f apart\n", is_touching ? "touch" : "do not touch", near.distance);

  graze_impact impact;
  const graze_status status = graze_shape_cast(&ball, fall, &box, NULL, &impact);
  require(status);
  if (status == GRAZE_OK) printf("it lands at %.3f of the way, at y = %.3f\n", impact.t, impact.point.y);

  const graze_shape wrong = graze_make_sphere(GRAZE_3D, above, -1);
  if (graze_intersects(&wrong, &box, &is_touching) != GRAZE_OK) puts(graze_error_message());
  return 0;
}
