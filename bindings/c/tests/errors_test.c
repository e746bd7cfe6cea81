/* SPDX-License-Identifier: MIT */
/* What is refused: each call fails with its status and a message that names the argument and the fault. */
#include <math.h>
#include <string.h>

#include "check.h"

static void test_null_pointers(void) {
  const graze_shape ball = graze_make_sphere(GRAZE_3D, vec(0, 0, 0), 1);
  const graze_rows one_missing = {NULL, 1, 0, GRAZE_3D};
  bool is_true = true;
  size_t count = 0;
  graze_pair pair = {0, 0};
  FAILS(graze_intersects(NULL, &ball, &is_true), GRAZE_INVALID_ARGUMENT, "graze_intersects: a is a null pointer");
  FAILS(graze_intersects(&ball, NULL, &is_true), GRAZE_INVALID_ARGUMENT, "b is a null pointer");
  FAILS(graze_intersects(&ball, &ball, NULL), GRAZE_INVALID_ARGUMENT, "out is a null pointer");
  FAILS(graze_overlapping_pairs(one_missing, NULL, &pair, 1, &count), GRAZE_INVALID_ARGUMENT,
        "boxes is a null pointer, but has 1 element");
  FAILS(graze_touching_pairs(NULL, 2, NULL, 0, 0, &pair, 1, &count), GRAZE_INVALID_ARGUMENT, "shapes is a null");
  FAILS(graze_touching_pairs(&ball, 1, NULL, 0, 0, NULL, 1, &count), GRAZE_INVALID_ARGUMENT, "out is a null");
  FAILS(graze_touching_pairs(&ball, 1, NULL, 0, 0, &pair, 1, NULL), GRAZE_INVALID_ARGUMENT, "count is a null");
  FAILS(graze_visit_overlapping_pairs(one_missing, NULL, NULL, NULL), GRAZE_INVALID_ARGUMENT, "visit is a null");
  FAILS(graze_read_scene(NULL, NULL), GRAZE_INVALID_ARGUMENT, "path is a null");
  CHECK(is_true && count == 0); /* errors write no output */
}

static void test_values(void) {
  const graze_shape ball = graze_make_sphere(GRAZE_3D, vec(0, 0, 0), 1);
  graze_shape bad = graze_make_sphere(GRAZE_3D, vec(0, NAN, 0), 1);
  double distance = 7;
  FAILS(graze_distance(&ball, &bad, &distance), GRAZE_INVALID_ARGUMENT,
        "graze_distance: b, a sphere, has a center that is not finite");
  CHECK(distance == 7);
  bad = graze_make_sphere(GRAZE_3D, vec(0, 0, 0), -1);
  FAILS(graze_check(&bad), GRAZE_INVALID_ARGUMENT, "shape, a sphere, has a negative radius");
  bad = graze_make_sphere(GRAZE_3D_FLOAT, vec(1e300, 0, 0), 1);
  FAILS(graze_check(&bad), GRAZE_INVALID_ARGUMENT, "not finite"); /* too large for float */
  memset(&bad, 0, sizeof bad);
  bad.kind = GRAZE_OBB;
  FAILS(graze_check(&bad), GRAZE_INVALID_ARGUMENT, "axes that are not orthonormal");
  bad.kind = GRAZE_RAY;
  FAILS(graze_check(&bad), GRAZE_INVALID_ARGUMENT, "a direction of length zero");
  bad.kind = 13;
  FAILS(graze_check(&bad), GRAZE_INVALID_ARGUMENT, "of the kind 13; a kind from GRAZE_POINT to GRAZE_MESH is needed");
  bad.kind = -1;
  FAILS(graze_check(&bad), GRAZE_INVALID_ARGUMENT, "of the kind -1");
  bad.kind = GRAZE_POINT;
  bad.world = 4;
  FAILS(graze_check(&bad), GRAZE_INVALID_ARGUMENT, "there is no world 4; GRAZE_3D");
  FAILS(graze_distance(&bad, &ball, &distance), GRAZE_INVALID_ARGUMENT, "there is no world 4");
  const graze_shape flat = graze_make_point(GRAZE_2D, vec(0, 0, 0));
  FAILS(graze_distance(&ball, &flat, &distance), GRAZE_WRONG_WORLD, "a is in GRAZE_3D, but b in GRAZE_2D");
  graze_contact contact;
  FAILS(graze_contact_of(&ball, &ball, -1, &contact), GRAZE_INVALID_ARGUMENT, "margin is -1");
  graze_impact impact;
  FAILS(graze_shape_cast(&ball, vec(INFINITY, 0, 0), &ball, NULL, &impact), GRAZE_INVALID_ARGUMENT,
        "motion has a coordinate that is not finite");
  const graze_ray ray = {{0, 0, 0}, {1, 0, 0}};
  const graze_ray_options options = {true, false, NAN};
  graze_ray_hit hit;
  FAILS(graze_ray_cast(&ball, &ray, &options, &hit), GRAZE_INVALID_ARGUMENT, "options->t_max is");
  graze_shape moved;
  const graze_pose pose = {{{{2, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {0, 0, 0}};
  FAILS(graze_transformed(&ball, &pose, &moved), GRAZE_INVALID_ARGUMENT, "pose has a rotation that is not orthonormal");
  FAILS(graze_winding_number(&ball, vec(0, 0, 0), &distance), GRAZE_INVALID_ARGUMENT, "a sphere; a mesh is needed");
}

static void test_rows(void) {
  const double points[2][3] = {{0, 0, 0}, {0, NAN, 0}};
  const graze_rows rows = {points, 2, 0, GRAZE_3D}, overlapping = {points, 2, 8, GRAZE_3D},
                   none = {NULL, 0, 0, GRAZE_3D};
  const uint32_t faces[1][3] = {{0, 1, 2}};
  const graze_shape ball = graze_make_sphere(GRAZE_3D, vec(0, 0, 0), 1);
  graze_shape shape;
  double distances[2];
  FAILS(graze_create_hull(rows, &shape), GRAZE_INVALID_ARGUMENT, "not finite");
  FAILS(graze_create_hull(overlapping, &shape), GRAZE_INVALID_ARGUMENT, "stride of 8 bytes, but its rows have 24");
  FAILS(graze_create_hull(none, &shape), GRAZE_INVALID_ARGUMENT, "graze_create_hull: ");
  FAILS(graze_create_mesh(none, faces, 1, GRAZE_SURFACE, &shape), GRAZE_INVALID_ARGUMENT, "face 0 has vertex 0");
  FAILS(graze_create_mesh(none, NULL, 0, 5, &shape), GRAZE_INVALID_ARGUMENT, "kind is 5");
  FAILS(graze_signed_distances(&ball, rows, 0, distances), GRAZE_INVALID_ARGUMENT, "points[1] has a coordinate");
  const graze_pair candidate = {0, 1};
  graze_pair pair;
  size_t count = 0;
  FAILS(graze_touching_pairs(&ball, 1, &candidate, 1, 0, &pair, 1, &count), GRAZE_OUT_OF_RANGE, "graze_touching_pairs");
}

static void test_stale_handles(void) {
  const double corners[2][3] = {{0, 0, 0}, {1, 0, 0}};
  const graze_rows rows = {corners, 2, 0, GRAZE_3D};
  graze_shape hull, other;
  double distance = 0;
  OK(graze_create_hull(rows, &hull));
  OK(graze_destroy_geometry(hull.as.geometry));
  FAILS(graze_distance(&hull, &hull, &distance), GRAZE_OUT_OF_RANGE, "names no geometry; it was destroyed");
  OK(graze_create_hull(rows, &other)); /* takes the same place, with another handle */
  FAILS(graze_distance(&hull, &other, &distance), GRAZE_OUT_OF_RANGE, "names no geometry");
  FAILS(graze_destroy_geometry(hull.as.geometry), GRAZE_OUT_OF_RANGE, "names no geometry");
  hull = other;
  hull.kind = GRAZE_MESH;
  FAILS(graze_check(&hull), GRAZE_INVALID_ARGUMENT, "shape is a mesh; a polytope, as its geometry is, is needed");
  hull = other;
  hull.world = GRAZE_2D;
  FAILS(graze_check(&hull), GRAZE_WRONG_WORLD, "shape is in GRAZE_2D, but its geometry in GRAZE_3D");
  graze_scene scene = {0};
  size_t count = 0;
  FAILS(graze_scene_size(scene, &count), GRAZE_OUT_OF_RANGE, "names no scene");
  scene.handle = other.as.geometry.handle;
  FAILS(graze_scene_size(scene, &count), GRAZE_OUT_OF_RANGE, "names no scene");
  OK(graze_destroy_geometry(other.as.geometry));
}

static void test_scenes_refuse(void) {
  graze_scene scene, other, snapshot;
  graze_id id, foreign, none = {0, 0, 0};
  uint32_t layer = 0;
  size_t count = 0;
  const graze_shape ball = graze_make_sphere(GRAZE_3D, vec(0, 0, 0), 1),
                    flat = graze_make_point(GRAZE_2D, vec(0, 0, 0));
  const graze_object_options named = {.name = "ball"}, on_layer = {.layer = 64};
  FAILS(graze_create_scene(9, &scene), GRAZE_INVALID_ARGUMENT, "there is no world 9");
  OK(graze_create_scene(GRAZE_3D, &scene));
  OK(graze_create_scene(GRAZE_3D, &other));
  OK(graze_scene_add(scene, &ball, &named, &id));
  OK(graze_scene_add(other, &ball, NULL, &foreign));
  FAILS(graze_scene_add(scene, &ball, &named, &id), GRAZE_INVALID_ARGUMENT, "ball");
  FAILS(graze_scene_add(scene, &ball, &on_layer, &id), GRAZE_INVALID_ARGUMENT, "options->layer is 64");
  FAILS(graze_scene_add(scene, &flat, NULL, &id), GRAZE_WRONG_WORLD, "shape is in GRAZE_2D, but the scene in GRAZE_3D");
  FAILS(graze_scene_move(scene, foreign, &ball), GRAZE_OUT_OF_RANGE, "graze_scene_move: ");
  FAILS(graze_scene_remove(scene, none), GRAZE_OUT_OF_RANGE, "graze_scene_remove: ");
  FAILS(graze_scene_except(scene, id, id), GRAZE_INVALID_ARGUMENT, "graze_scene_except: ");
  FAILS(graze_scene_events(scene, 3, NULL, 0, &count), GRAZE_INVALID_ARGUMENT, "there is no event 3");
  FAILS(graze_scene_closest_pairs(scene, NAN, NULL, 0, &count), GRAZE_INVALID_ARGUMENT, "within is ");
  OK(graze_scene_snapshot(scene, &snapshot));
  FAILS(graze_scene_remove(snapshot, id), GRAZE_INVALID_ARGUMENT, "the scene is a snapshot");
  OK(graze_scene_size(scene, &count));
  CHECK(count == 1); /* no failed call has changed it */
  for (int i = 0; i < 64; ++i) {
    const char name[3] = {(char)('a' + i % 26), (char)('a' + i / 26), 0};
    OK(graze_scene_layer(scene, name, &layer));
  }
  FAILS(graze_scene_layer(scene, "one more", &layer), GRAZE_TOO_MANY, "graze_scene_layer: ");
  OK(graze_scene_remove(scene, id));
  FAILS(graze_scene_remove(scene, id), GRAZE_OUT_OF_RANGE, "graze_scene_remove: ");
  OK(graze_destroy_scene(snapshot));
  OK(graze_destroy_scene(other));
  OK(graze_destroy_scene(scene));
  FAILS(graze_scene_update(scene), GRAZE_OUT_OF_RANGE, "names no scene; it was destroyed");
  FAILS(graze_destroy_scene(scene), GRAZE_OUT_OF_RANGE, "names no scene");
  FAILS(graze_read_scene("data/none.json", &scene), GRAZE_INPUT_ERROR, "data/none.json");
}

void test_errors(void) {
  test_null_pointers();
  test_values();
  test_rows();
  test_stale_handles();
  test_scenes_refuse();
}
