/* SPDX-License-Identifier: MIT
 *
 * Many questions in one call, for C: question k takes row k of every argument, and answers[k] is
 * what the function of kernels/c_api.h of the same name would give. Several rows are decided at
 * once where the processor has wide registers.
 *
 * Rows: `first` points to the numbers of row 0, those of row k lie k * stride numbers further, and
 * the numbers of one row lie side by side: 2 of a point, 3 of a metric, 5 of a site. So a table
 * with a site in each row has stride 5, its points alone are the same table with stride 5, and
 * stride 0 is one argument for all questions. Rows may overlap each other, but not the answers.
 * Checks: those of kernels/c_api.h, over all rows before any is answered: on a failure nothing is
 * written but the report. No rows are a valid batch, whose pointers may be null.
 * Report: null, or filled on every return.
 */
#ifndef ASTERISM_KERNELS_C_BATCH_H
#define ASTERISM_KERNELS_C_BATCH_H

#include <stddef.h>

#include "asterism/core/export.h"
#include "asterism/kernels/c_api.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A table of numbers, a record a row: row i begins at first + i * stride. */
typedef struct asterism_rows { /* NOLINT(modernize-use-using): C */
  const double* first;
  size_t stride; /* in numbers */
} asterism_rows;

/* What a batch tells beside its answers. */
typedef struct asterism_batch_report { /* NOLINT(modernize-use-using): C */
  size_t failed_row;                   /* of the status, if it is about a row; else the count */
  /* How many questions each tier decided (docs/math/tiers.md). */
  size_t by_semi_static, by_interval, by_exact;
} asterism_batch_report;

/* Answers asterism_orientation for each row. */
ASTERISM_EXPORT asterism_status asterism_orientations(size_t count, asterism_rows p,
                                                      asterism_rows q, asterism_rows r,
                                                      signed char* answers,
                                                      asterism_batch_report* report);
/* Answers asterism_is_spd for each row. */
ASTERISM_EXPORT asterism_status asterism_are_spd(size_t count, asterism_rows metric,
                                                 signed char* answers,
                                                 asterism_batch_report* report);
/* Answers asterism_in_circle for each row. */
ASTERISM_EXPORT asterism_status asterism_in_circles(size_t count, asterism_rows metric,
                                                    asterism_rows a, asterism_rows b,
                                                    asterism_rows c, asterism_rows p,
                                                    signed char* answers,
                                                    asterism_batch_report* report);
/* Answers asterism_compare_distance for each row. */
ASTERISM_EXPORT asterism_status asterism_compare_distances(size_t count, asterism_rows v,
                                                           asterism_rows w, asterism_rows q,
                                                           signed char* answers,
                                                           asterism_batch_report* report);
/* Answers asterism_in_wedge for each row. */
ASTERISM_EXPORT asterism_status asterism_in_wedges(size_t count, asterism_rows v, asterism_rows w,
                                                   asterism_rows q, signed char* answers,
                                                   asterism_batch_report* report);
/* Answers asterism_dominates for each row. */
ASTERISM_EXPORT asterism_status asterism_dominations(size_t count, asterism_rows v, asterism_rows w,
                                                     asterism_rows p, signed char* answers,
                                                     asterism_batch_report* report);
/* Answers asterism_voronoi_vertex_count for each row. */
ASTERISM_EXPORT asterism_status asterism_voronoi_vertex_counts(size_t count, asterism_rows u,
                                                               asterism_rows v, asterism_rows w,
                                                               signed char* answers,
                                                               asterism_batch_report* report);
/* Answers asterism_arc_intersection_count for each row. */
ASTERISM_EXPORT asterism_status asterism_arc_intersection_counts(size_t count, asterism_rows v,
                                                                 asterism_rows w, asterism_rows x,
                                                                 signed char* answers,
                                                                 asterism_batch_report* report);
/* Answers asterism_encroaches for each row. */
ASTERISM_EXPORT asterism_status asterism_encroachments(size_t count, asterism_rows a,
                                                       asterism_rows b, asterism_rows w,
                                                       signed char* answers,
                                                       asterism_batch_report* report);
/* Answers asterism_insertion_test for each row. */
ASTERISM_EXPORT asterism_status asterism_insertion_tests(size_t count, asterism_rows v,
                                                         asterism_rows w, asterism_rows x,
                                                         asterism_rows y, signed char* answers,
                                                         asterism_batch_report* report);
/* Answers asterism_edge_test for each row. */
ASTERISM_EXPORT asterism_status asterism_edge_tests(size_t count, asterism_rows v, asterism_rows w,
                                                    asterism_rows x, asterism_rows y,
                                                    signed char* answers,
                                                    asterism_batch_report* report);

#ifdef __cplusplus
}
#endif

#endif /* ASTERISM_KERNELS_C_BATCH_H */
