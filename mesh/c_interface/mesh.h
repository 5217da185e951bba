/* SPDX-License-Identifier: MIT
 *
 * Offers the mesher to C: arrays of a domain and of a metric in, arrays of a mesh and a certificate
 * out; and the auditor, which trusts none of them. Indices count from 0; numbers of one vertex,
 * edge or triangle lie side by side.
 *
 * Statuses: ASTERISM_OK says that there is a mesh, not that it is complete or certified: ask
 * asterism_mesh_is_certified. ASTERISM_REFUSED: the input is at fault, `message` says where.
 * Messages: `message` may be null; else it points to `capacity` characters, and gets a sentence
 * that is cut where it does not fit, empty on success. Messages and the reason count from 0, as the
 * arrays do. The certificate is the text of a file, and counts vertices, triangles and edges from
 * 1, as its entry "numbering" says; so do parts of it that a message quotes, and its sentences on
 * periodic sides. Ownership: arrays and texts given are read during the call alone. A mesh is the
 * caller's until given to asterism_mesh_free, which also takes null; what is read of it is the
 * mesh's and lives as long. Threads: as kernels/c_api.h; one mesh may be read from many. A run uses
 * several threads itself.
 */
#ifndef ASTERISM_MESH_C_INTERFACE_MESH_H
#define ASTERISM_MESH_C_INTERFACE_MESH_H

#include <stddef.h>

#include "asterism/core/export.h"
#include "asterism/kernels/c_api.h"

#ifdef __cplusplus
extern "C" {
#endif

/* NOLINTBEGIN(modernize-use-using): C */

/* A planar straight-line graph, as check_domain (mesh/domain/check_domain.hpp) takes it. */
typedef struct asterism_domain {
  size_t vertex_count;
  const double* vertices; /* x y */
  size_t segment_count;
  const unsigned* segments;   /* two vertices */
  const int* segment_markers; /* null: all 0 */
  size_t hole_count;
  const double* holes; /* x y, a point inside each */
  size_t region_count;
  const double* regions; /* x y, a point inside each */
  const int* region_numbers;
  /* Segments that are curves from their first vertex to their second: divided in chords, as the
   * metric wants them (mesh/domain/divide_curves.hpp). */
  size_t curve_count;
  const unsigned* curve_segments; /* one each */
  const int* curve_kinds;         /* asterism_curve_kind; null: all cubics */
  const double* curve_points; /* x y x y: the inner control points of a cubic; the centre of an arc,
                                 and two numbers that are not read */
} asterism_domain;

/* Kinds of curves: a cubic Bezier curve, an arc of a circle counter-clockwise or clockwise. An arc
 * of a segment from a vertex to itself is a whole circle. */
typedef enum asterism_curve_kind {
  ASTERISM_CUBIC = 0,
  ASTERISM_ARC = 1,
  ASTERISM_CLOCKWISE_ARC = 2
} asterism_curve_kind;

/* Writes the tensor wanted at x y to metric and returns 0; anything else ends the run with
 * ASTERISM_REFUSED. A function of x and y alone. Never called twice at once, though from different
 * threads. */
typedef int (*asterism_metric_function)(void* context, double x, double y, double metric[3]);

/* The same for many points at once: writes the tensors wanted at `count` points, x y side by side,
 * to metrics, three numbers each. How points are grouped is not to change a tensor. For callers to
 * whom a call costs more than a point: interpreters, tables, remote ones. */
typedef int (*asterism_metric_batch_function)(void* context, size_t count, const double* points,
                                              double* metrics);

/* The metric wanted: exactly one of a text, a function and a mesh with tensors. */
typedef struct asterism_metric {
  /* As `asterism mesh --metric` takes it: "swirl:12", "expr:1+x*x;0;1". */
  const char* specification;
  asterism_metric_function function;
  /* Beside the function, or in its place: asked where many points are known in advance, as most
   * are. What it says of a point is remembered for the rest of the run. */
  asterism_metric_batch_function batch_function;
  void* context;
  /* A triangulation and a tensor at each of its vertices; between them the logarithms are
   * interpolated. */
  size_t vertex_count;
  const double* vertices; /* x y */
  const double* tensors;  /* m11 m12 m22 */
  size_t triangle_count;
  const unsigned* triangles; /* three vertices */
  double size;               /* 0: 1. All tensors are divided by its square. */
} asterism_metric;

/* Options of a run; each comment ends with what init sets. */
typedef struct asterism_mesh_options {
  double angle_bound; /* degrees, at least 0 and below 60; 20 */
  int limit_size;     /* 1: triangles are to be as large as the metric says; 0 */
  size_t max_sites;   /* 100000 */
  int prove_voronoi;  /* 1: has the mesh proved, or refused, as the dual of a Voronoi diagram; 0 */
  /* Asked now and then, perhaps from another thread; not 0 ends the run, and the mesh is what is
   * certain by then. Null: never. */
  int (*stop)(void* context);
  void* stop_context;
  /* How far the metric delivered may be from the one wanted, at any site, where stars cannot agree
   * in that one: ln of the greatest ratio of two lengths of a displacement. Beyond it a mesh is not
   * complete. 0: no tensor is changed, and where stars cannot agree the mesh ends with triangles
   * that disagree; negative: any distance, but of half of the sites no more
   * than ln 10, and on the whole no more than ten times as dense or as thin; -1 */
  double metric_tolerance;
  /* Vertices wanted, from 3 to max_sites: the metric is scaled until about so many come out
   * (mesh/pipeline/counted_mesh.hpp), as if limit_size were 1. 0: the metric is as given; 0 */
  size_t vertices;
  /* Greatest distance of a curve from its chord. 0: a part of each chord; 0 */
  double chord_tolerance;
} asterism_mesh_options;

/* A mesh with its certificate. */
typedef struct asterism_mesh asterism_mesh;
/* NOLINTEND(modernize-use-using) */

/* Sets all to null and 0. */
ASTERISM_EXPORT void asterism_domain_init(asterism_domain* domain);
/* Sets all to null and 0. */
ASTERISM_EXPORT void asterism_metric_init(asterism_metric* metric);
/* Sets the defaults that the comments above end with. */
ASTERISM_EXPORT void asterism_mesh_options_init(asterism_mesh_options* options);

/* Makes a mesh and audits it. `options` null: as after init. */
ASTERISM_EXPORT asterism_status asterism_mesh_create(const asterism_domain* domain,
                                                     const asterism_metric* metric,
                                                     const asterism_mesh_options* options,
                                                     asterism_mesh** out, char* message,
                                                     size_t capacity);
/* Frees a mesh; null is allowed. */
ASTERISM_EXPORT void asterism_mesh_free(asterism_mesh* mesh);

/* Returns 1 if the mesher reached its goal, in its own opinion, else 0. */
ASTERISM_EXPORT int asterism_mesh_is_complete(const asterism_mesh* mesh);
/* Returns why the run ended: one sentence. */
ASTERISM_EXPORT const char* asterism_mesh_reason(const asterism_mesh* mesh);
/* Returns 1 if the mesh is complete and the auditor found nothing against it, else 0. */
ASTERISM_EXPORT int asterism_mesh_is_certified(const asterism_mesh* mesh);
/* Returns the smallest angle of all triangles that are not exempt, as any of their vertices
 * measures it; degrees. */
ASTERISM_EXPORT double asterism_mesh_worst_angle(const asterism_mesh* mesh);
/* Returns the certificate's text: JSON (docs/math/certificate.md). */
ASTERISM_EXPORT const char* asterism_mesh_certificate(const asterism_mesh* mesh);

/* Returns the sites: x y m11 m12 m22. The first ones are the domain's vertices. */
ASTERISM_EXPORT const double* asterism_mesh_sites(const asterism_mesh* mesh, size_t* count);
/* Returns the triangles: three sites each, counter-clockwise. */
ASTERISM_EXPORT const unsigned* asterism_mesh_triangles(const asterism_mesh* mesh, size_t* count);
/* Returns the region of each triangle. */
ASTERISM_EXPORT const int* asterism_mesh_regions(const asterism_mesh* mesh, size_t* count);
/* Returns the boundary edges: two sites each, the domain on the left. */
ASTERISM_EXPORT const unsigned* asterism_mesh_boundary(const asterism_mesh* mesh, size_t* count);
/* Returns the marker of each boundary edge's segment. */
ASTERISM_EXPORT const int* asterism_mesh_boundary_markers(const asterism_mesh* mesh, size_t* count);

/* Audits the mesh again, from its arrays and the text of a certificate (null: its own). *verified
 * becomes 1 if it is certified and nothing contradicts the certificate; else 0, and `message` says
 * the first reason. ASTERISM_REFUSED for a text that is no certificate. */
ASTERISM_EXPORT asterism_status asterism_mesh_verify(const asterism_mesh* mesh,
                                                     const char* certificate, int* verified,
                                                     char* message, size_t capacity);

/* Certifies a triangulation from elsewhere: sites (x y m11 m12 m22) and triangles. *certified
 * becomes 1 if it is the mesh of its sites' stars and no angle is below the bound; else 0, and
 * `message` says the first reason. */
ASTERISM_EXPORT asterism_status asterism_certify(size_t site_count, const double* sites,
                                                 size_t triangle_count, const unsigned* triangles,
                                                 double angle_bound, int* certified, char* message,
                                                 size_t capacity);

#ifdef __cplusplus
}
#endif

#endif /* ASTERISM_MESH_C_INTERFACE_MESH_H */
