/* SPDX-License-Identifier: MIT
 *
 * The C functions from a C89 program: every answer, every status, nothing written on failure;
 * batches against one question at a time. */
#include "asterism/kernels/c_api.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "asterism/kernels/c_batch.h"

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
  expect_answer(asterism_in_circle(metric, origin, right, up, beside, &answer), &answer, 1,
                "in_circle");
  expect_answer(asterism_in_circle(metric, origin, up, right, beside, &answer), &answer, -1,
                "in_circle");
  expect_answer(asterism_in_circle_plane(origin, right, c, up, &answer), &answer, 0,
                "in_circle_plane");
  expect_answer(asterism_in_circle_plane(origin, right, up, a, &answer), &answer, 0,
                "in_circle_plane, a point twice");
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
  const double infinite[5] = {0, HUGE_VAL, 1, 0, 1};
  double not_a_number[5] = {0, 0, 1, 0, 1};
  const double indefinite[5] = {0, 5, 1, 2, 1}, semidefinite[5] = {0, 5, 0, 0, 1};
  const double elsewhere_metric[5] = {1, 0, 3, 1, 2}, minus_zero[5] = {-0.0, 0, 1, 0, 1};
  int answer = 99;
  not_a_number[0] = HUGE_VAL - HUGE_VAL;
  expect_refused(asterism_in_circle(indefinite + 2, a, b, c, d, &answer),
                 ASTERISM_NOT_POSITIVE_DEFINITE, &answer, "indefinite");
  expect_refused(asterism_in_circle(NULL, a, b, c, d, &answer), ASTERISM_NULL_POINTER, &answer,
                 "null metric");
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

/* Every question of a batch again alone. Rows of sites on a small grid, so that ties occur. */
#define ROWS 300
static double table[ROWS][5];

static void fill_table(void) {
  unsigned long state = 20;
  int k, i;
  for (k = 0; k < ROWS; ++k) {
    for (i = 0; i < 2; ++i) {
      state = (state * 1103515245UL + 12345UL) & 0x7FFFFFFFUL;
      table[k][i] =
          (double)((state >> 16) % 7) + 8 * (k % 4); /* of four, all at places of their own */
    }
    table[k][2] = k % 3 == 0 ? 2 : 1;
    table[k][3] = 0;
    table[k][4] = 1;
  }
}

static asterism_rows every(size_t first) {
  asterism_rows rows;
  rows.first = table[first];
  rows.stride = 5;
  return rows;
}

static void expect_rows(asterism_status status, const signed char* answers, const int* alone,
                        const asterism_batch_report* report, const char* what) {
  size_t k;
  expect(status == ASTERISM_OK, what);
  expect(report->failed_row == ROWS - 3, what);
  expect(report->by_semi_static + report->by_interval + report->by_exact == ROWS - 3, what);
  for (k = 0; k < ROWS - 3; ++k) expect(answers[k] == alone[k], what);
}

#define ALONE(call)                                                                      \
  for (k = 0; k < ROWS - 3; ++k) {                                                       \
    const double *v = table[k], *w = table[k + 1], *x = table[k + 2], *y = table[k + 3]; \
    (void)v, (void)w, (void)x, (void)y;                                                  \
    expect(call == ASTERISM_OK, #call);                                                  \
  }

static void test_batches(void) {
  const size_t n = ROWS - 3;
  const asterism_rows v = every(0), w = every(1), x = every(2), y = every(3);
  asterism_rows metrics = every(0), same;
  signed char answers[ROWS];
  int alone[ROWS];
  asterism_batch_report report;
  size_t k;
  metrics.first += 2;
  same.first = table[0] + 2;
  same.stride = 0;
  ALONE(asterism_orientation(v, w, x, &alone[k]))
  expect_rows(asterism_orientations(n, v, w, x, answers, &report), answers, alone, &report,
              "orientations");
  ALONE(asterism_is_spd(v + 2, &alone[k]))
  expect_rows(asterism_are_spd(n, metrics, answers, &report), answers, alone, &report, "are_spd");
  ALONE(asterism_in_circle(v + 2, v, w, x, y, &alone[k]))
  expect_rows(asterism_in_circles(n, metrics, v, w, x, y, answers, &report), answers, alone,
              &report, "in_circles");
  ALONE(asterism_in_circle(table[0] + 2, v, w, x, y, &alone[k]))
  expect_rows(asterism_in_circles(n, same, v, w, x, y, answers, &report), answers, alone, &report,
              "in_circles of one metric");
  ALONE(asterism_compare_distance(v, w, x, &alone[k]))
  expect_rows(asterism_compare_distances(n, v, w, x, answers, &report), answers, alone, &report,
              "compare_distances");
  ALONE(asterism_in_wedge(v, w, x, &alone[k]))
  expect_rows(asterism_in_wedges(n, v, w, x, answers, &report), answers, alone, &report,
              "in_wedges");
  ALONE(asterism_dominates(v, w, x, &alone[k]))
  expect_rows(asterism_dominations(n, v, w, x, answers, &report), answers, alone, &report,
              "dominations");
  ALONE(asterism_voronoi_vertex_count(v, w, x, &alone[k]))
  expect_rows(asterism_voronoi_vertex_counts(n, v, w, x, answers, &report), answers, alone, &report,
              "voronoi_vertex_counts");
  ALONE(asterism_arc_intersection_count(v, w, x, &alone[k]))
  expect_rows(asterism_arc_intersection_counts(n, v, w, x, answers, &report), answers, alone,
              &report, "arc_intersection_counts");
  ALONE(asterism_encroaches(v, w, x, &alone[k]))
  expect_rows(asterism_encroachments(n, v, w, x, answers, &report), answers, alone, &report,
              "encroachments");
  ALONE(asterism_insertion_test(v, w, x, y, &alone[k]))
  expect_rows(asterism_insertion_tests(n, v, w, x, y, answers, &report), answers, alone, &report,
              "insertion_tests");
  ALONE(asterism_edge_test(v, w, x, y, &alone[k]))
  expect_rows(asterism_edge_tests(n, v, w, x, y, answers, &report), answers, alone, &report,
              "edge_tests");
}

static void test_refused_batches(void) {
  const asterism_rows v = every(0), w = every(1), x = every(2), y = every(3);
  asterism_rows none;
  signed char answers[ROWS];
  asterism_batch_report report;
  size_t k;
  none.first = NULL;
  none.stride = 0;
  memset(answers, 77, sizeof answers);
  table[200][3] = 9;
  expect(
      asterism_edge_tests(ROWS - 3, v, w, x, y, answers, &report) == ASTERISM_NOT_POSITIVE_DEFINITE,
      "one metric of a batch");
  expect(report.failed_row == 197, "the row is told");
  table[200][3] = 0;
  expect(asterism_edge_tests(ROWS - 3, v, w, v, y, answers, NULL) == ASTERISM_EQUAL_SITES,
         "equal sites in a batch");
  expect(asterism_edge_tests(ROWS - 3, v, none, x, y, answers, &report) == ASTERISM_NULL_POINTER,
         "null rows");
  expect(asterism_edge_tests(ROWS - 3, v, w, x, y, NULL, &report) == ASTERISM_NULL_POINTER,
         "null answers");
  expect(report.failed_row == ROWS - 3, "about no row");
  for (k = 0; k < ROWS; ++k) expect(answers[k] == 77, "nothing is written");
  expect(asterism_edge_tests(0, none, none, none, none, NULL, NULL) == ASTERISM_OK, "no rows");
}

/* Any predicate by number, with the tier that decided it. */
static void test_asking_by_number(void) {
  const double origin[2] = {0, 0}, right[2] = {1, 0}, up[2] = {0, 1}, corner[2] = {1, 1};
  const double near_corner[2] = {1, 1 + 2.220446049250313e-16}, metric[3] = {2, 1, 1};
  const double indefinite[5] = {0, 5, 1, 2, 1};
  const double *turn[3], *circle[5], *edge[4], *one[1];
  asterism_tier_counts counts = {0, 0, 0};
  int answer = 99, alone = 99, k;
  turn[0] = origin, turn[1] = right, turn[2] = up;
  expect_answer(asterism_ask(ASTERISM_ORIENTATION, turn, &answer, &counts), &answer, 1, "turn");
  expect(counts.by_semi_static == 1 && counts.by_interval == 0 && counts.by_exact == 0,
         "a clear turn is decided by the fast path");
  turn[1] = corner, turn[2] = near_corner;
  expect_answer(asterism_ask(ASTERISM_ORIENTATION, turn, &answer, &counts), &answer, 1, "near");
  expect(counts.by_semi_static + counts.by_interval + counts.by_exact == 2, "each counts once");
  one[0] = metric;
  expect_answer(asterism_ask(ASTERISM_IS_SPD, one, &answer, NULL), &answer, 1, "uncounted");
  circle[0] = metric, circle[1] = origin, circle[2] = right, circle[3] = up, circle[4] = corner;
  expect(asterism_in_circle(metric, origin, right, up, corner, &alone) == ASTERISM_OK, "alone");
  expect_answer(asterism_ask(ASTERISM_IN_CIRCLE, circle, &answer, &counts), &answer, alone,
                "in_circle");
  edge[0] = b, edge[1] = d, edge[2] = c, edge[3] = a;
  for (k = ASTERISM_VORONOI_VERTEX_COUNT; k <= ASTERISM_EDGE_TEST; ++k)
    expect(asterism_ask((asterism_predicate)k, edge, &answer, &counts) == ASTERISM_OK, "of sites");
  expect_answer(asterism_ask(ASTERISM_EDGE_TEST, edge, &answer, &counts), &answer, 1, "edge_test");
  expect(counts.by_semi_static + counts.by_interval + counts.by_exact == 9, "each counts once");
  answer = 99;
  edge[1] = indefinite;
  expect_refused(asterism_ask(ASTERISM_EDGE_TEST, edge, &answer, &counts),
                 ASTERISM_NOT_POSITIVE_DEFINITE, &answer, "indefinite");
  edge[1] = NULL;
  expect_refused(asterism_ask(ASTERISM_EDGE_TEST, edge, &answer, &counts), ASTERISM_NULL_POINTER,
                 &answer, "null argument");
  expect_refused(asterism_ask(ASTERISM_EDGE_TEST, NULL, &answer, &counts), ASTERISM_NULL_POINTER,
                 &answer, "null arguments");
  expect_refused(asterism_ask((asterism_predicate)11, turn, &answer, &counts),
                 ASTERISM_OUT_OF_RANGE, &answer, "no such predicate");
  expect(counts.by_semi_static + counts.by_interval + counts.by_exact == 9,
         "what is refused is not counted");
}

int main(void) {
  int status;
  test_answers();
  test_refusals();
  test_asking_by_number();
  fill_table();
  test_batches();
  test_refused_batches();
  for (status = -1; status <= 9; ++status)
    expect(strlen(asterism_status_message((asterism_status)status)) > 0, "message");
  expect(asterism_version() == ASTERISM_VERSION, "version");
  expect(strcmp(asterism_version_text(), ASTERISM_VERSION_TEXT) == 0, "version");
  if (failures == 0) puts("the C functions answer and refuse as documented");
  return failures == 0 ? 0 : 1;
}
