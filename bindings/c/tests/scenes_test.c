/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "check.h"

/* Three balls of radius 1 along x, of which the first two touch. */
static graze_scene balls(graze_id ids[3]) {
  graze_scene scene = {0};
  const double places[3] = {0, 1.5, 10};
  OK(graze_create_scene(GRAZE_3D, &scene));
  for (int i = 0; i < 3; ++i) {
    const graze_shape ball = graze_make_sphere(GRAZE_3D, vec(places[i], 0, 0), 1);
    OK(graze_scene_add(scene, &ball, NULL, &ids[i]));
  }
  return scene;
}

static bool same(graze_id a, graze_id b) { return memcmp(&a, &b, sizeof a) == 0; }

static void test_objects(void) {
  graze_id ids[3], found, list[2];
  graze_scene scene = balls(ids);
  graze_world world = -1;
  OK(graze_scene_world(scene, &world));
  CHECK(world == GRAZE_3D);
  size_t count = 0;
  OK(graze_scene_size(scene, &count));
  CHECK(count == 3);
  uint32_t layer = 9;
  OK(graze_scene_layer(scene, "walls", &layer));
  CHECK(layer == 0);
  OK(graze_scene_layer(scene, "doors", &layer));
  CHECK(layer == 1);
  const graze_object_options options = {"gate", 7, 4, 1, true};
  const graze_shape box = graze_make_aabb(GRAZE_3D, vec(20, 0, 0), vec(21, 1, 1));
  graze_id gate;
  OK(graze_scene_add(scene, &box, &options, &gate));
  OK(graze_scene_find(scene, "gate", &found));
  CHECK(same(found, gate));
  STATUS(graze_scene_find(scene, "fence", &found), GRAZE_NONE);
  CHECK(found.generation == 0);
  graze_object object;
  OK(graze_scene_object(scene, gate, &object));
  CHECK(strcmp(object.options.name, "gate") == 0 && object.options.user == 7 && object.options.ignored_layers == 4 &&
        object.options.layer == 1 && object.options.is_fixed);
  VEC(object.box.max, 21, 1, 1);
  OK(graze_scene_object(scene, ids[0], &object));
  CHECK(strcmp(object.options.name, "") == 0 && object.options.ignored_layers == 0 && !object.options.is_fixed);
  graze_shape shape;
  OK(graze_scene_shape(scene, ids[1], &shape));
  CHECK(shape.kind == GRAZE_SPHERE && shape.as.sphere.center.x == 1.5);
  STATUS(graze_scene_ids(scene, list, 2, &count), GRAZE_TRUNCATED);
  CHECK(count == 4 && same(list[1], ids[1]));
  bool is_there = false;
  OK(graze_scene_has(scene, gate, &is_there));
  CHECK(is_there);
  OK(graze_scene_remove(scene, gate));
  OK(graze_scene_has(scene, gate, &is_there));
  CHECK(!is_there);
  OK(graze_destroy_scene(scene));
}

static size_t events(graze_scene scene, graze_event event) {
  size_t count = 99;
  graze_id_pair pairs[4];
  OK(graze_scene_events(scene, event, pairs, 4, &count));
  return count;
}

static void test_updates(void) {
  graze_id ids[3];
  graze_scene scene = balls(ids), snapshot;
  OK(graze_scene_update(scene));
  CHECK(events(scene, GRAZE_BEGAN) == 1 && events(scene, GRAZE_STAYED) == 0);
  OK(graze_scene_snapshot(scene, &snapshot));
  graze_shape ball = graze_make_sphere(GRAZE_3D, vec(11, 0, 0), 1);
  OK(graze_scene_move(scene, ids[0], &ball));
  OK(graze_scene_update(scene));
  CHECK(events(scene, GRAZE_BEGAN) == 1 && events(scene, GRAZE_ENDED) == 1);
  graze_id_pair pairs[4];
  size_t count = 0;
  OK(graze_scene_pairs(scene, pairs, 4, &count));
  CHECK(count == 1 && same(pairs[0].a, ids[0]) && same(pairs[0].b, ids[2]));
  OK(graze_scene_pairs(snapshot, pairs, 4, &count)); /* still as it was */
  CHECK(count == 1 && same(pairs[0].b, ids[1]));
  OK(graze_scene_except(scene, ids[0], ids[2]));
  OK(graze_scene_pairs(scene, pairs, 4, &count));
  CHECK(count == 0);
  OK(graze_scene_accept(scene, ids[0], ids[2]));
  const graze_shape together[2] = {ball, ball};
  OK(graze_scene_move_many(scene, ids, together, 2));
  OK(graze_scene_pairs(scene, pairs, 4, &count));
  CHECK(count == 3);
  OK(graze_destroy_scene(snapshot));
  OK(graze_destroy_scene(scene));
}

static void test_shapes_of_any_size(void) {
  const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const graze_rows rows = {corners, 4, 0, GRAZE_3D};
  graze_scene scene;
  graze_shape hull, copy;
  graze_id id;
  OK(graze_create_scene(GRAZE_3D, &scene));
  OK(graze_create_hull(rows, &hull));
  OK(graze_scene_add(scene, &hull, NULL, &id));
  OK(graze_destroy_geometry(hull.as.geometry));
  OK(graze_scene_shape(scene, id, &copy)); /* the scene has its own */
  CHECK(copy.kind == GRAZE_POLYTOPE && copy.as.geometry.handle != hull.as.geometry.handle);
  OK(graze_check(&copy));
  OK(graze_destroy_scene(scene));
  OK(graze_check(&copy));
  OK(graze_destroy_geometry(copy.as.geometry));
}

void test_scenes(void) {
  test_objects();
  test_updates();
  test_shapes_of_any_size();
  graze_scene scene;
  size_t count = 0;
  OK(graze_read_scene("data/platform_level.tmx", &scene));
  OK(graze_scene_size(scene, &count));
  CHECK(count > 10);
  OK(graze_destroy_scene(scene));
}

void test_scene_queries(void) {
  graze_id ids[3], found[3];
  graze_scene scene = balls(ids);
  size_t count = 0;
  graze_object_contact contacts[2];
  OK(graze_scene_contacts(scene, contacts, 2, &count));
  CHECK(count == 1 && same(contacts[0].pair.b, ids[1]));
  NEAR(contacts[0].manifold.points[0].depth, 0.5);
  graze_near_pair near_pairs[3];
  OK(graze_scene_closest_pairs(scene, 6.5, near_pairs, 3, &count));
  CHECK(count == 2 && same(near_pairs[1].pair.a, ids[1]));
  NEAR(near_pairs[1].distance, 6.5);

  const graze_shape region = graze_make_sphere(GRAZE_3D, vec(0.75, 1.2, 0), 0.5);
  OK(graze_scene_overlapping(scene, &region, NULL, found, 3, &count));
  CHECK(count == 2 && same(found[1], ids[1]));
  const graze_query without_first = {0, ids, 1, false};
  OK(graze_scene_overlapping(scene, &region, &without_first, found, 3, &count));
  CHECK(count == 1 && same(found[0], ids[1]));
  const graze_query nothing = {1, NULL, 0, false};
  OK(graze_scene_cull(scene, &region, &nothing, found, 3, &count));
  CHECK(count == 0);
  OK(graze_scene_cull(scene, &region, NULL, found, 3, &count));
  CHECK(count == 2);
  graze_object_touch touches[3];
  OK(graze_scene_contacts_with(scene, &region, NULL, touches, 3, &count));
  CHECK(count == 2 && same(touches[0].id, ids[0]) && touches[0].manifold.count == 1);
  graze_near_object near_objects[2];
  const graze_shape point = graze_make_point(GRAZE_3D, vec(13, 0, 0));
  OK(graze_scene_nearest(scene, &point, NULL, near_objects, 2, &count));
  CHECK(count == 2 && same(near_objects[0].id, ids[2]) && same(near_objects[1].id, ids[1]));
  NEAR(near_objects[0].distance, 2);

  const graze_ray ray = {{-5, 0, 0}, {1, 0, 0}};
  const graze_ray_options limit = {true, false, 3};
  graze_object_hit hit, hits[3];
  OK(graze_scene_ray_cast(scene, &ray, NULL, NULL, &hit));
  CHECK(same(hit.id, ids[0]));
  NEAR(hit.hit.t, 4);
  STATUS(graze_scene_ray_cast(scene, &ray, &limit, NULL, &hit), GRAZE_NONE);
  OK(graze_scene_ray_cast_all(scene, &ray, NULL, NULL, hits, 3, &count));
  CHECK(count == 3 && same(hits[2].id, ids[2]));
  NEAR(hits[2].hit.t, 14);
  const graze_shape bullet = graze_make_sphere(GRAZE_3D, vec(-5, 0, 0), 1);
  graze_object_impact impact, impacts[3];
  OK(graze_scene_shape_cast(scene, &bullet, vec(6, 0, 0), NULL, &impact));
  CHECK(same(impact.id, ids[0]));
  NEAR(impact.impact.t, 0.5);
  OK(graze_scene_shape_cast_all(scene, &bullet, vec(6, 0, 0), NULL, impacts, 3, &count));
  CHECK(count == 2 && same(impacts[1].id, ids[1]));
  const graze_motion motion = {{6, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  OK(graze_scene_time_of_impact(scene, &bullet, &motion, NULL, &impact));
  NEAR(impact.impact.t, 0.5);
  STATUS(graze_scene_time_of_impact(scene, &bullet, &motion, &nothing, &impact), GRAZE_NONE);
  OK(graze_destroy_scene(scene));
}
