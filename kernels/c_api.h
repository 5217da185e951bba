/* SPDX-License-Identifier: MIT
 *
 * Offers the predicates to C and to everything that calls C. The answers are those of
 * filtered_kernel (kernels/filtered_kernel.hpp): exact for the doubles given, whatever the caller's
 * rounding mode, FTZ and DAZ, which are the same after the call.
 *
 * Arguments: a point is x y, a metric tensor m11 m12 m22, a site x y m11 m12 m22. Any finite double
 * is allowed, from subnormal to the largest.
 * Checks, in this order: no null pointer, every number finite, every site's metric positive
 * definite (decided exactly), no two sites of one call at one position. The first that fails gives
 * the status; *answer is then left as it was.
 * Errors: nothing is thrown, nothing aborts; ASTERISM_INTERNAL_FAILURE stands for everything else,
 * of which no case is known. ASTERISM_OUT_OF_MEMORY: there is not enough for an exact number; where
 * it is GMP that asks for it, GMP ends the program, unless it is told otherwise.
 * State: none. Every function may be called from any thread at any time.
 * Language: C89. Version: core/version.h; asterism_version() is that of the library linked.
 *
 * One function a predicate answers one question; asterism_ask() answers any, and counts which tier
 * decided; kernels/c_batch.h answers many in a call. The mesher's functions are those of
 * mesh/c_interface/.
 * Cost: checks and border take some nanoseconds a call beside what the kernel takes
 * (docs/results/interfaces.md).
 */
#ifndef ASTERISM_KERNELS_C_API_H
#define ASTERISM_KERNELS_C_API_H

#include <stddef.h>

#include "asterism/core/export.h"
#include "asterism/core/version.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Outcome of a call. */
typedef enum asterism_status { /* NOLINT(modernize-use-using): C */
                               ASTERISM_OK = 0,
                               ASTERISM_NULL_POINTER = 1,
                               ASTERISM_NOT_FINITE = 2,
                               ASTERISM_NOT_POSITIVE_DEFINITE = 3,
                               ASTERISM_EQUAL_SITES = 4,
                               ASTERISM_INTERNAL_FAILURE = 5,
                               ASTERISM_OUT_OF_MEMORY = 6,
                               ASTERISM_OUT_OF_RANGE = 7, /* an index, count or option */
                               ASTERISM_REFUSED = 8 /* of a mesh or domain; a message says why */
} asterism_status;

/* Returns a sentence for a person, never null, also for a number that is no status. Owned by the
 * library. */
ASTERISM_EXPORT const char* asterism_status_message(asterism_status status);

/* Returns ASTERISM_VERSION as the library was compiled. */
ASTERISM_EXPORT int asterism_version(void);
/* Returns ASTERISM_VERSION_TEXT as the library was compiled. */
ASTERISM_EXPORT const char* asterism_version_text(void);

/* Tells whether r lies to the left (1) or right (-1) of the directed line from p to q, or on it
 * (0). Source and laws: predicates/orientation.hpp. Equal points give 0. */
ASTERISM_EXPORT asterism_status asterism_orientation(const double p[2], const double q[2],
                                                     const double r[2], int* answer);

/* Tells whether the metric tensor is positive definite (1 or 0); semidefinite is 0. Never gives
 * ASTERISM_NOT_POSITIVE_DEFINITE. Source: predicates/positive_definite.hpp. */
ASTERISM_EXPORT asterism_status asterism_is_spd(const double metric[3], int* answer);

/* Tells where p lies against the ellipse through a, b, c that is a circle in the metric. 1: inside
 * when a b c turn counter-clockwise (outside when clockwise); -1: the other way round; 0: the four
 * are cocircular in the metric, or a, b, c collinear with each other and with p. The points need
 * not be distinct. Source and laws: predicates/in_circle.hpp. */
ASTERISM_EXPORT asterism_status asterism_in_circle(const double metric[3], const double a[2],
                                                   const double b[2], const double c[2],
                                                   const double p[2], int* answer);

/* Tells it in the plane as it is: the usual in-circle test. */
ASTERISM_EXPORT asterism_status asterism_in_circle_plane(const double a[2], const double b[2],
                                                         const double c[2], const double p[2],
                                                         int* answer);

/* Tells which of v, w is nearer to q, each by its own metric. -1: v; 1: w; 0: q is on their
 * bisector. Source: predicates/compare_distance.hpp. */
ASTERISM_EXPORT asterism_status asterism_compare_distance(const double v[5], const double w[5],
                                                          const double q[2], int* answer);

/* Tells whether q is strictly in the wedge of v and w (1 or 0). Source: predicates/wedge.hpp. */
ASTERISM_EXPORT asterism_status asterism_in_wedge(const double v[5], const double w[5],
                                                  const double q[2], int* answer);

/* Tells whether v (1) or w (-1) dominates p over the other, or neither (0: p is on the border).
 * This is not the same as being nearer. Source: predicates/domination.hpp. */
ASTERISM_EXPORT asterism_status asterism_dominates(const double v[5], const double w[5],
                                                   const double p[2], int* answer);

/* Counts the points that are equally near to u, v, w. 0 to 4; -1: infinitely many. A tangency is
 * one point. Source: predicates/voronoi_vertices.hpp. */
ASTERISM_EXPORT asterism_status asterism_voronoi_vertex_count(const double u[5], const double v[5],
                                                              const double w[5], int* answer);

/* Counts the points of the visible arc of v, w to which x is as near as they are. 0 to 4; -1:
 * infinitely many. Source: predicates/arc_intersections.hpp. */
ASTERISM_EXPORT asterism_status asterism_arc_intersection_count(const double v[5],
                                                                const double w[5],
                                                                const double x[5], int* answer);

/* Tells whether w is nearer than a and than b somewhere on the open segment ab (1 or 0); touching
 * is 0. Source: predicates/encroachment.hpp. */
ASTERISM_EXPORT asterism_status asterism_encroaches(const double a[5], const double b[5],
                                                    const double w[5], int* answer);

/* Tells whether w may stand in the star of v between its neighbours x and y (1 or 0); touching is
 * 0. Four distinct sites. Source: predicates/insertion_test.hpp. */
ASTERISM_EXPORT asterism_status asterism_insertion_test(const double v[5], const double w[5],
                                                        const double x[5], const double y[5],
                                                        int* answer);

/* Tells it with ties broken alike from every side: what a mesh generator should ask.
 * Source: predicates/tie_breaking.hpp. */
ASTERISM_EXPORT asterism_status asterism_edge_test(const double v[5], const double w[5],
                                                   const double x[5], const double y[5],
                                                   int* answer);

/* The predicates by number, for asterism_ask. Their arguments are those of the functions above, in
 * the same order. */
typedef enum asterism_predicate { /* NOLINT(modernize-use-using): C */
                                  ASTERISM_ORIENTATION = 0,
                                  ASTERISM_IS_SPD = 1,
                                  ASTERISM_COMPARE_DISTANCE = 2,
                                  ASTERISM_IN_WEDGE = 3,
                                  ASTERISM_DOMINATES = 4,
                                  ASTERISM_VORONOI_VERTEX_COUNT = 5,
                                  ASTERISM_ARC_INTERSECTION_COUNT = 6,
                                  ASTERISM_ENCROACHES = 7,
                                  ASTERISM_INSERTION_TEST = 8,
                                  ASTERISM_EDGE_TEST = 9,
                                  ASTERISM_IN_CIRCLE = 10
} asterism_predicate;

/* How many questions each tier decided (docs/math/tiers.md): the semi-static one is the fast path,
 * doubles with an error bound. Set it to zeros; every answer adds one. */
typedef struct asterism_tier_counts { /* NOLINT(modernize-use-using): C */
  size_t by_semi_static, by_interval, by_exact;
} asterism_tier_counts;

/* Answers any of the predicates above: arguments[i] points to the numbers of its argument i, before
 * the answer. `counts` may be null; it is the caller's, one a thread. A question that gets no
 * answer is not counted, nor are the checks. ASTERISM_OUT_OF_RANGE: there is no such predicate. */
ASTERISM_EXPORT asterism_status asterism_ask(asterism_predicate question,
                                             const double* const* arguments, int* answer,
                                             asterism_tier_counts* counts);

#ifdef __cplusplus
}
#endif

#endif /* ASTERISM_KERNELS_C_API_H */
