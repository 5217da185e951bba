/* SPDX-License-Identifier: MIT
 *
 * The C functions from a C11 program: every answer, every status, nothing written on failure. */
#include "asterism/kernels/c_api.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

static void expect(int holds, const char* what) {
  if (holds) return;
  ++failures;
  fprintf(stderr, "failed: %s\n", what);
}

static void expect_answer(asterism_status status, const int* answer, int expected,
                          const char* what) {
  expect(status == ASTERISM_OK, what);
  expect(*answer == expected, what);
}

/* Four corners of the unit square with the Euclidean metric. */
static const double a[5] = {0, 0, 1, 0, 1}, b[5] = {1, 0, 1, 0, 1}, c[5] = {1, 1, 1, 0, 1},
                    d[5] = {0, 1, 1, 0, 1};

static void test_answers(void) {
  const double origin[2] = {0, 0}, right[2] = {1, 0}, up[2] = {0, 1}, beside[2] = {0.5, 0.25};
  const double metric[3] = {2, 1, 1}, semidefinite[3] = {1, 1, 1};
  const double near[5] = {0.5, 0.125, 1, 0, 1};
  int answer = 99;
  expect_answer(asterism_orientation(origin, right, up, &answer), &answer, 1, "orientation");
  expect_answer(asterism_orientation(origin, up, right, &answer), &answer, -1, "orientation");
  expect_answer(asterism_orientation(origin, up, up, &answer), &answer, 0, "orientation");
  expect_answer(asterism_is_spd(metric, &answer), &answer, 1, "is_spd");
  expect_answer(asterism_is_spd(semidefinite, &answer), &answer, 0, "is_spd");
  expect_answer(asterism_compare_distance(a, b, beside, &answer), &answer, 0, "compare_distance");
  expect_answer(asterism_compare_distance(a, b, up, &answer), &answer, -1, "compare_distance");
  expect_answer(asterism_in_wedge(a, b, beside, &answer), &answer, 1, "in_wedge");
  expect_answer(asterism_in_wedge(a, b, up, &answer), &answer, 0, "in_wedge");
  expect_answer(asterism_dominates(a, b, up, &answer), &answer, 1, "dominates");
  expect_answer(asterism_dominates(b, a, up, &answer), &answer, -1, "dominates");
  expect_answer(asterism_voronoi_vertex_count(a, b, c, &answer), &answer, 1,
                "voronoi_vertex_count");
  expect_answer(asterism_arc_intersection_count(a, b, c, &answer), &answer, 1,
                "arc_intersection_count");
  expect_answer(asterism_encroaches(a, b, near, &answer), &answer, 1, "encroaches");
  expect_answer(asterism_encroaches(a, b, d, &answer), &answer, 0, "encroaches");
  expect_answer(asterism_insertion_test(a, c, b, d, &answer), &answer, 0, "insertion_test");
  expect_answer(asterism_edge_test(a, c, b, d, &answer), &answer, 0, "edge_test");
  expect_answer(asterism_edge_test(b, d, c, a, &answer), &answer, 1, "edge_test");
}

static void expect_refused(asterism_status status, asterism_status expected, const int* answer,
                           const char* what) {
  expect(status == expected, what);
  expect(*answer == 99, "an answer is left as it was");
}

static void test_refusals(void) {
  const double infinite[5] = {0, HUGE_VAL, 1, 0, 1}, not_a_number[5] = {NAN, 0, 1, 0, 1};
  const double indefinite[5] = {0, 5, 1, 2, 1}, semidefinite[5] = {0, 5, 0, 0, 1};
  const double elsewhere_metric[5] = {1, 0, 3, 1, 2}, minus_zero[5] = {-0.0, 0, 1, 0, 1};
  int answer = 99;
  expect_refused(asterism_edge_test(a, b, c, NULL, &answer), ASTERISM_NULL_POINTER, &answer,
                 "null");
  expect(asterism_edge_test(a, b, c, d, NULL) == ASTERISM_NULL_POINTER, "null answer");
  expect_refused(asterism_edge_test(a, infinite, c, d, &answer), ASTERISM_NOT_FINITE, &answer,
                 "infinite");
  expect_refused(asterism_in_wedge(not_a_number, b, c, &answer), ASTERISM_NOT_FINITE, &answer,
                 "not a number");
  expect_refused(asterism_is_spd(infinite, &answer), ASTERISM_NOT_FINITE, &answer, "infinite");
  expect_refused(asterism_encroaches(a, indefinite, c, &answer), ASTERISM_NOT_POSITIVE_DEFINITE,
                 &answer, "indefinite");
  expect_refused(asterism_dominates(a, semidefinite, c, &answer), ASTERISM_NOT_POSITIVE_DEFINITE,
                 &answer, "semidefinite");
  expect_refused(asterism_insertion_test(a, b, c, elsewhere_metric, &answer), ASTERISM_EQUAL_SITES,
                 &answer, "equal positions");
  expect_refused(asterism_voronoi_vertex_count(a, minus_zero, c, &answer), ASTERISM_EQUAL_SITES,
                 &answer, "zero and minus zero");
}

int main(void) {
  test_answers();
  test_refusals();
  for (int status = -1; status <= 6; ++status)
    expect(strlen(asterism_status_message((asterism_status)status)) > 0, "message");
  if (failures == 0) puts("the C functions answer and refuse as documented");
  return failures == 0 ? 0 : 1;
}
