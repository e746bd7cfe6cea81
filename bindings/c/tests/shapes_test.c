/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "check.h"

static const double quarter_turn = 1.5707963267948966;

static void test_made_shapes(void) {
  const graze_vec a = vec(1, 2, 3), b = vec(4, 5, 6), c = vec(7, 8, 0);
  graze_shape shape = graze_make_point(GRAZE_2D, a);
  CHECK(shape.kind == GRAZE_POINT && shape.world == GRAZE_2D && shape.as.point.y == 2);
  shape = graze_make_segment(GRAZE_3D, a, b);
  CHECK(shape.kind == GRAZE_SEGMENT && shape.as.segment.start.x == 1 && shape.as.segment.end.z == 6);
  shape = graze_make_ray(GRAZE_3D, a, b);
  CHECK(shape.kind == GRAZE_RAY && shape.as.ray.origin.z == 3 && shape.as.ray.direction.x == 4);
  shape = graze_make_sphere(GRAZE_3D_FLOAT, a, 5);
  CHECK(shape.kind == GRAZE_SPHERE && shape.world == GRAZE_3D_FLOAT && shape.as.sphere.radius == 5);
  shape = graze_make_aabb(GRAZE_3D, a, b);
  CHECK(shape.kind == GRAZE_AABB && shape.as.aabb.min.x == 1 && shape.as.aabb.max.x == 4);
  shape = graze_make_obb(GRAZE_3D, a, b, identity());
  CHECK(shape.kind == GRAZE_OBB && shape.as.obb.half_extents.y == 5 && shape.as.obb.axes.columns[2].z == 1);
  shape = graze_make_plane(GRAZE_3D, a, 9);
  CHECK(shape.kind == GRAZE_PLANE && shape.as.plane.normal.z == 3 && shape.as.plane.offset == 9);
  shape = graze_make_half_space(GRAZE_3D, a, 9);
  CHECK(shape.kind == GRAZE_HALF_SPACE && shape.as.half_space.normal.z == 3 && shape.as.half_space.offset == 9);
  shape = graze_make_triangle(GRAZE_3D, a, b, c);
  CHECK(shape.kind == GRAZE_TRIANGLE && shape.as.triangle.b.y == 5 && shape.as.triangle.c.x == 7);
  shape = graze_make_capsule(GRAZE_3D, a, b, 0.5);
  CHECK(shape.kind == GRAZE_CAPSULE && shape.as.capsule.b.x == 4 && shape.as.capsule.radius == 0.5);
  OK(graze_check(&shape));
}

static void test_rotation(void) {
  graze_mat turned;
  OK(graze_make_rotation(GRAZE_3D, vec(0, 0, 2), quarter_turn, &turned));
  VEC(turned.columns[0], 0, 1, 0);
  OK(graze_make_rotation(GRAZE_2D, vec(9, 9, 9), quarter_turn, &turned));
  VEC(turned.columns[0], 0, 1, 0);
  VEC(turned.columns[1], -1, 0, 0);
  VEC(turned.columns[2], 0, 0, 1);
}

static void test_hull_and_pose(void) {
  const float points[5][2] = {{0, 0}, {2, 0}, {1, 0.5F}, {2, 2}, {0, 2}};
  const graze_rows rows = {points, 5, 0, GRAZE_2D_FLOAT};
  graze_shape square, moved;
  OK(graze_create_hull(rows, &square));
  CHECK(square.kind == GRAZE_POLYTOPE && square.world == GRAZE_2D_FLOAT);
  graze_vec corners[4];
  size_t count = 0;
  OK(graze_vertices(&square, corners, 4, &count));
  CHECK(count == 4); /* (1, 0.5) is inside */
  VEC(corners[2], 2, 2, 0);
  const graze_pose pose = {identity(), {10, 20, 30}};
  OK(graze_transformed(&square, &pose, &moved));
  OK(graze_destroy_geometry(square.as.geometry));
  STATUS(graze_vertices(&moved, corners, 1, &count), GRAZE_TRUNCATED);
  CHECK(count == 4);
  VEC(corners[0], 10, 20, 0);
  OK(graze_destroy_geometry(moved.as.geometry));
  const graze_geometry none = {0};
  OK(graze_destroy_geometry(none));
}

static void test_compound(void) {
  graze_shape parts[2], both;
  parts[0] = graze_make_sphere(GRAZE_3D, vec(0, 0, 0), 1);
  parts[1] = graze_make_sphere(GRAZE_3D, vec(10, 0, 0), 1);
  OK(graze_create_compound(GRAZE_3D, parts, 2, &both));
  CHECK(both.kind == GRAZE_COMPOUND);
  const graze_shape point = graze_make_point(GRAZE_3D, vec(7, 0, 0));
  double distance = -1;
  OK(graze_distance(&both, &point, &distance));
  NEAR(distance, 2);
  OK(graze_destroy_geometry(both.as.geometry));
  OK(graze_create_compound(GRAZE_2D, NULL, 0, &both));
  const graze_shape flat = graze_make_point(GRAZE_2D, vec(7, 0, 0));
  OK(graze_distance(&both, &flat, &distance));
  CHECK(isinf(distance));
  OK(graze_destroy_geometry(both.as.geometry));
}

static void test_mesh(void) {
  const double vertices[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const uint32_t faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const graze_rows rows = {vertices, 4, 0, GRAZE_3D};
  graze_shape mesh, other;
  OK(graze_create_mesh(rows, faces, 4, GRAZE_SOLID, &mesh));
  graze_vec read[4];
  uint32_t read_faces[4][3];
  size_t count = 0;
  OK(graze_vertices(&mesh, read, 4, &count));
  CHECK(count == 4 && read[3].z == 1);
  OK(graze_faces(&mesh, read_faces, 4, &count));
  CHECK(count == 4 && memcmp(faces, read_faces, sizeof faces) == 0);
  double turns = -1;
  OK(graze_winding_number(&mesh, vec(0.1, 0.1, 0.1), &turns));
  NEAR(turns, 1);
  graze_mesh_report report;
  OK(graze_report_mesh(&mesh, &report));
  CHECK(report.is_closed && report.open_edges == 0 && report.components == 1);
  OK(graze_create_mesh(rows, faces, 1, GRAZE_SURFACE, &other));
  OK(graze_report_mesh(&other, &report));
  CHECK(!report.is_closed && report.open_edges == 3 && report.unused_vertices == 1);
  graze_pair pairs[16];
  OK(graze_touching_faces(&other, &mesh, pairs, 16, &count));
  CHECK(count == 4 && pairs[0].a == 0 && pairs[3].b == 3); /* the face itself, and its three neighbours */
  OK(graze_self_intersections(&mesh, pairs, 16, &count));
  CHECK(count == 0);
  const uint32_t twice[2][3] = {{0, 1, 2}, {0, 1, 2}};
  OK(graze_destroy_geometry(other.as.geometry));
  OK(graze_create_mesh(rows, twice, 2, GRAZE_SURFACE, &other));
  OK(graze_self_intersections(&other, pairs, 16, &count));
  CHECK(count == 1 && pairs[0].a == 0 && pairs[0].b == 1);
  OK(graze_destroy_geometry(other.as.geometry));
  OK(graze_destroy_geometry(mesh.as.geometry));
}

void test_shapes(void) {
  test_made_shapes();
  test_rotation();
  test_hull_and_pose();
  test_compound();
  test_mesh();
}
