/* SPDX-License-Identifier: MIT */
/* Checks for tests in C: each prints what failed, and failures() counts them. */
#ifndef CHECK_H
#define CHECK_H

#include <graze.h>
#include <stdbool.h>

void check_true(bool is_true, const char* text, const char* file, int line);
void check_status(graze_status found, graze_status wanted, const char* text, const char* file, int line);
void check_number(double found, double wanted, const char* text, const char* file, int line);
void check_message(const char* part, const char* file, int line);

#define CHECK(condition) check_true(condition, #condition, __FILE__, __LINE__)
#define OK(call) check_status(call, GRAZE_OK, #call, __FILE__, __LINE__)
/* Within 1e-12; the answers of C++ are compared bit for bit elsewhere. */
#define NEAR(found, wanted) check_number(found, wanted, #found, __FILE__, __LINE__)
#define VEC(found, in_x, in_y, in_z) (NEAR((found).x, in_x), NEAR((found).y, in_y), NEAR((found).z, in_z))
#define STATUS(call, wanted) check_status(call, wanted, #call, __FILE__, __LINE__)
/* The call fails, and its message contains the part. */
#define FAILS(call, wanted, part) (STATUS(call, wanted), check_message(part, __FILE__, __LINE__))

int failures(void);

graze_vec vec(double x, double y, double z);
graze_mat identity(void);

void test_shapes(void);
void test_pairs(void);
void test_singles(void);
void test_batches(void);
void test_scenes(void);
void test_scene_queries(void);
void test_errors(void);

#endif
