/* SPDX-License-Identifier: MIT */
/* Every function of the interface, called from C: values that can be calculated by hand. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "check.h"

static int failed = 0;

static void report(const char* text, const char* file, int line) {
  ++failed;
  printf("%s:%d: %s\n  the last error: %s\n", file, line, text, graze_error_message());
}

void check_true(bool is_true, const char* text, const char* file, int line) {
  if (!is_true) report(text, file, line);
}

void check_status(graze_status found, graze_status wanted, const char* text, const char* file, int line) {
  if (found == wanted) return;
  report(text, file, line);
  printf("  is %s, not %s\n", graze_status_name(found), graze_status_name(wanted));
}

void check_number(double found, double wanted, const char* text, const char* file, int line) {
  if (found == wanted || fabs(found - wanted) <= 1e-12) return;
  report(text, file, line);
  printf("  is %.17g, not %.17g\n", found, wanted);
}

void check_message(const char* part, const char* file, int line) {
  if (strstr(graze_error_message(), part) == NULL) report(part, file, line);
}

int failures(void) { return failed; }

graze_vec vec(double x, double y, double z) {
  graze_vec result;
  result.x = x;
  result.y = y;
  result.z = z;
  return result;
}

graze_mat identity(void) {
  const graze_mat result = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  return result;
}

static void test_general(void) {
  CHECK(strcmp(graze_error_message(), "") == 0);
  CHECK(graze_version() == GRAZE_VERSION);
  CHECK(strcmp(graze_status_name(GRAZE_TOO_MANY), "GRAZE_TOO_MANY") == 0);
  CHECK(strcmp(graze_status_name(99), "unknown") == 0);
  CHECK(strstr(graze_layout(), "graze_shape.as 8 120\n") != NULL);
}

int main(void) {
  test_general(); /* first, because no call has failed yet */
  test_shapes();
  test_pairs();
  test_singles();
  test_batches();
  test_scenes();
  test_scene_queries();
  test_errors();
  if (failures() == 0) puts("all checks passed");
  return failures() == 0 ? 0 : 1;
}
