/* SPDX-License-Identifier: MIT */
/* A convex stone falls onto a floor, frame by frame; the scene tells when it lands and where it touches. */
#include <graze.h>
#include <stdio.h>
#include <stdlib.h>

static void require(graze_status status) {
  if (status >= 0) return;
  fprintf(stderr, "%s: %s\n", graze_status_name(status), graze_error_message());
  exit(1);
}

int main(void) {
  const double corners[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const graze_rows points = {corners, 6, 0, GRAZE_3D};
  const graze_vec up = {0, 1, 0};
  graze_scene scene;
  graze_shape stone;
  graze_id floor_id, stone_id;
  const graze_shape floor_shape = graze_make_half_space(GRAZE_3D, up, 0);
  const graze_object_options fixed = {.name = "floor", .is_fixed = true};
  require(graze_create_scene(GRAZE_3D, &scene));
  require(graze_create_hull(points, &stone));
  require(graze_scene_add(scene, &floor_shape, &fixed, &floor_id));
  require(graze_scene_add(scene, &stone, NULL, &stone_id));

  for (int frame = 0; frame < 5; ++frame) {
    const graze_pose pose = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {0, 2.5 - 0.5 * frame, 0}};
    graze_shape moved;
    require(graze_transformed(&stone, &pose, &moved));
    require(graze_scene_move(scene, stone_id, &moved));
    require(graze_destroy_geometry(moved.as.geometry)); /* The scene has its own copy. */
    require(graze_scene_update(scene));

    size_t count;
    graze_id_pair began[4];
    graze_object_contact contacts[4];
    require(graze_scene_events(scene, GRAZE_BEGAN, began, 4, &count));
    if (count > 0) printf("frame %d: the stone lands\n", frame);
    require(graze_scene_contacts(scene, contacts, 4, &count));
    for (size_t i = 0; i < count; ++i) printf("frame %d: it rests on %u points\n", frame, contacts[i].manifold.count);
  }
  require(graze_destroy_geometry(stone.as.geometry));
  require(graze_destroy_scene(scene));
  return 0;
}
