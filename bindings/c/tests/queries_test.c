/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdint.h>

#include "check.h"

static graze_shape ball_at(double x) { return graze_make_sphere(GRAZE_3D, vec(x, 0, 0), 1); }

void test_pairs(void) {
  const graze_shape a = ball_at(0), far = ball_at(5), near = ball_at(1.5);
  graze_relation relation = -1;
  OK(graze_relation_of(&a, &near, &relation));
  CHECK(relation == GRAZE_OVERLAPPING);
  OK(graze_relation_of(&a, &far, &relation));
  CHECK(relation == GRAZE_APART);
  bool is_true = true;
  OK(graze_intersects(&a, &far, &is_true));
  CHECK(!is_true);
  double distance = -1;
  OK(graze_distance(&a, &far, &distance));
  NEAR(distance, 3);
  graze_proximity proximity;
  OK(graze_closest_points(&a, &far, &proximity));
  NEAR(proximity.distance, 3);
  VEC(proximity.point_a, 1, 0, 0);
  VEC(proximity.point_b, 4, 0, 0);
  VEC(proximity.normal, 1, 0, 0);
  CHECK(proximity.relation == GRAZE_APART && proximity.status == GRAZE_CONVERGED);
  OK(graze_separation(&a, &near, &proximity));
  NEAR(proximity.distance, -0.5);
  graze_contact contact;
  OK(graze_contact_of(&a, &near, 0, &contact));
  NEAR(contact.depth, 0.5);
  VEC(contact.normal, 1, 0, 0);
  STATUS(graze_contact_of(&a, &far, 0, &contact), GRAZE_NONE);
  CHECK(contact.depth == 0);
  OK(graze_contact_of(&a, &far, 4, &contact));
  NEAR(contact.depth, -3);
  graze_manifold manifold;
  OK(graze_manifold_of(&a, &near, 0, &manifold));
  CHECK(manifold.count == 1);
  NEAR(manifold.points[0].depth, 0.5);
  STATUS(graze_manifold_of(&a, &far, 0, &manifold), GRAZE_NONE);
  CHECK(manifold.count == 0);
}

static void test_casts(void) {
  const graze_shape a = ball_at(0), far = ball_at(5), near = ball_at(1.5);
  graze_impact impact;
  OK(graze_shape_cast(&a, vec(6, 0, 0), &far, NULL, &impact));
  NEAR(impact.t, 0.5);
  VEC(impact.point, 4, 0, 0);
  STATUS(graze_shape_cast(&a, vec(-6, 0, 0), &far, NULL, &impact), GRAZE_NONE);
  CHECK(impact.t == 0);
  graze_cast_options options = {false, 1.5};
  OK(graze_shape_cast(&a, vec(6, 0, 0), &far, &options, &impact));
  NEAR(impact.t, 0.25);
  options.ignore_initial_touch = true;
  options.target_distance = 0;
  OK(graze_shape_cast(&a, vec(-6, 0, 0), &near, NULL, &impact));
  STATUS(graze_shape_cast(&a, vec(-6, 0, 0), &near, &options, &impact), GRAZE_NONE);
  const graze_motion half_way = {{6, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  OK(graze_time_of_impact(&a, &half_way, &far, NULL, &impact));
  NEAR(impact.t, 0.5);
  STATUS(graze_time_of_impact(&a, NULL, &far, NULL, &impact), GRAZE_NONE);
  /* In 2D, a rod that turns by a quarter about the origin reaches a point straight above it. */
  const graze_shape rod = graze_make_segment(GRAZE_2D, vec(0, 0, 0), vec(2, 0, 0));
  const graze_shape point = graze_make_point(GRAZE_2D, vec(0, 1, 0));
  const graze_motion turn = {{0, 0, 0}, {0, 0, 1.8}, {0, 0, 0}};
  OK(graze_time_of_impact(&rod, &turn, &point, NULL, &impact));
  CHECK(fabs(impact.t * 1.8 - 1.5707963267948966) < 1e-6);
}

static void test_points(void) {
  const graze_shape box = graze_make_aabb(GRAZE_3D, vec(0, 0, 0), vec(2, 4, 6));
  bool is_true = false;
  OK(graze_contains(&box, vec(2, 4, 6), &is_true));
  CHECK(is_true);
  OK(graze_contains(&box, vec(3, 0, 0), &is_true));
  CHECK(!is_true);
  graze_vec point;
  OK(graze_closest_point(&box, vec(1, 5, 1), &point));
  VEC(point, 1, 4, 1);
  OK(graze_closest_boundary_point(&box, vec(0.5, 2, 3), &point));
  VEC(point, 0, 2, 3);
  double distance = 0;
  OK(graze_signed_distance(&box, vec(0.5, 2, 3), &distance));
  NEAR(distance, -0.5);
}

static void test_rays(void) {
  const graze_shape box = graze_make_aabb(GRAZE_3D, vec(0, 0, 0), vec(2, 4, 6));
  const graze_ray ray = {{-1, 1, 1}, {2, 0, 0}};
  graze_ray_options options = {false, false, 0};
  graze_ray_hit hit;
  OK(graze_ray_cast(&box, &ray, NULL, &hit));
  NEAR(hit.t, 0.5);
  VEC(hit.normal, -1, 0, 0);
  CHECK(hit.is_hit && hit.face == GRAZE_NO_FACE);
  OK(graze_ray_cast(&box, &ray, &options, &hit)); /* t_max does not count */
  options.is_exit = true;
  OK(graze_ray_cast(&box, &ray, &options, &hit));
  NEAR(hit.t, 1.5);
  options.is_exit = false;
  options.is_limited = true;
  options.t_max = 0.25;
  STATUS(graze_ray_cast(&box, &ray, &options, &hit), GRAZE_NONE);
  CHECK(!hit.is_hit);
}

void test_singles(void) {
  test_casts();
  test_points();
  test_rays();
  const graze_shape box = graze_make_aabb(GRAZE_3D, vec(0, 0, 0), vec(2, 4, 6));
  graze_box bounds;
  OK(graze_bounds(&box, &bounds));
  VEC(bounds.max, 2, 4, 6);
  graze_mass mass;
  OK(graze_mass_properties(&box, &mass));
  NEAR(mass.volume, 48);
  VEC(mass.centroid, 1, 2, 3);
  NEAR(mass.inertia.columns[0].x, 48 * (16 + 36) / 12.0);
  const graze_shape square = graze_make_aabb(GRAZE_2D, vec(0, 0, 0), vec(2, 2, 0));
  OK(graze_mass_properties(&square, &mass));
  NEAR(mass.volume, 4);
  NEAR(mass.inertia.columns[2].z, 4 * (4 + 4) / 12.0);
}

static bool count_pairs(const graze_pair* pairs, size_t count, void* context) {
  (void)pairs;
  *(size_t*)context += count;
  return true;
}

static void test_boxes(void) {
  /* Rows with a gap: four numbers of a box, then one that is not read. */
  const float boxes[3][5] = {{0, 0, 1, 1, -9}, {1, 1, 2, 2, -9}, {3, 3, 4, 4, -9}};
  const graze_rows rows = {boxes, 3, sizeof boxes[0], GRAZE_2D_FLOAT};
  graze_pair pairs[4];
  size_t count = 9;
  OK(graze_overlapping_pairs(rows, NULL, pairs, 4, &count));
  CHECK(count == 1 && pairs[0].a == 0 && pairs[0].b == 1);
  const graze_pair_options options = {true, 1, 0.5};
  STATUS(graze_overlapping_pairs(rows, &options, NULL, 0, &count), GRAZE_TRUNCATED);
  CHECK(count == 2); /* grown by 0.5, the last two touch as well */
  const graze_rows first = {boxes, 1, sizeof boxes[0], GRAZE_2D_FLOAT};
  OK(graze_overlapping_pairs_between(first, rows, NULL, pairs, 4, &count));
  CHECK(count == 2 && pairs[1].a == 0 && pairs[1].b == 1);
  size_t visited = 0;
  OK(graze_visit_overlapping_pairs(rows, NULL, &count_pairs, &visited));
  CHECK(visited == 1);
  const graze_rows none = {NULL, 0, 0, GRAZE_3D};
  OK(graze_overlapping_pairs(none, NULL, NULL, 0, &count));
  CHECK(count == 0);
}

void test_batches(void) {
  test_boxes();
  const graze_shape balls[3] = {ball_at(0), ball_at(1.5), ball_at(9)};
  const graze_pair candidates[2] = {{0, 1}, {1, 2}};
  graze_pair pairs[2];
  size_t count = 0;
  OK(graze_touching_pairs(balls, 3, candidates, 2, 0, pairs, 2, &count));
  CHECK(count == 1 && pairs[0].b == 1);
  graze_pair_contact contacts[2];
  OK(graze_contacts(balls, 3, candidates, 2, 1, contacts, 2, &count));
  CHECK(count == 1 && contacts[0].pair.a == 0);
  NEAR(contacts[0].manifold.points[0].depth, 0.5);

  const double vertices[3][3] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const uint32_t faces[1][3] = {{0, 1, 2}};
  const graze_rows corners = {vertices, 3, 0, GRAZE_3D};
  graze_shape mesh;
  OK(graze_create_mesh(corners, faces, 1, GRAZE_SURFACE, &mesh));
  const double rays[2][6] = {{1, 2, 5, 0, 0, -1}, {9, 9, 5, 0, 0, -1}};
  const graze_rows ray_rows = {rays, 2, 0, GRAZE_3D};
  graze_ray_hit hits[2];
  OK(graze_ray_casts(&mesh, ray_rows, NULL, 0, hits));
  CHECK(hits[0].is_hit && hits[0].face == 0 && !hits[1].is_hit);
  VEC(hits[0].barycentric, 0.25, 0.25, 0.5);
  const double points[2][3] = {{1, 1, 2}, {1, 1, 0}};
  const graze_rows point_rows = {points, 2, 0, GRAZE_3D};
  bool are_inside[2];
  OK(graze_contains_points(&mesh, point_rows, 0, are_inside));
  CHECK(!are_inside[0] && are_inside[1]);
  graze_vec nearest[2];
  OK(graze_closest_points_to(&mesh, point_rows, 0, nearest));
  VEC(nearest[0], 1, 1, 0);
  double distances[2];
  OK(graze_signed_distances(&mesh, point_rows, 0, distances));
  NEAR(distances[0], 2);
  double windings[2];
  OK(graze_winding_numbers(&mesh, point_rows, 0, windings));
  CHECK(fabs(windings[0]) < 0.5);
  OK(graze_destroy_geometry(mesh.as.geometry));
}
