/* SPDX-License-Identifier: MIT
 *
 * Offers the star builder to C: the neighbours of a site in the stars of given sites, in exact
 * counter-clockwise order. A mesh generator with loops of its own can take its stars from here.
 *
 * Two neighbours y, x in a row (counter-clockwise, x last) with less than 180 degrees between them
 * make the triangle v, y, x; a wider gap holds none. The triangle is part of a triangulation when
 * the stars of y and x have it too.
 *
 * Boundary: without one (asterism_sites_create) the domain is the whole plane. With one
 * (asterism_sites_create_within) its segments are edges of every triangulation, and no star reaches
 * across them. A site on the boundary has one sector for each angle of the domain at it: its first
 * and last neighbours are the ends of the two subsegments there, which no test removes, and the
 * last and the first do not make a triangle. A site inside has one closed sector, the full turn.
 * Segments are split by asterism_sites_split alone; where, is for the host to decide (a subsegment
 * that a site encroaches upon is what asterism_encroaches tells).
 *
 * Sites are numbered from 0 in the order they came in. Checks, statuses, errors: those of
 * kernels/c_api.h; on a failure nothing has changed and *out is left as it was. The exception:
 * where memory ends within asterism_sites_split, the sites give ASTERISM_OUT_OF_MEMORY from then
 * on, and can only be freed.
 * Ownership: what a function gives through `out` is the caller's, until given to the function that
 * frees it, which also takes null. A star does not keep its sites alive.
 * Threads: functions that take a pointer to const may run at once on one object; a function that
 * changes an object must be alone with it. No function keeps anything between calls elsewhere.
 */
#ifndef ASTERISM_MESH_C_INTERFACE_STARS_H
#define ASTERISM_MESH_C_INTERFACE_STARS_H

#include <stddef.h>

#include "asterism/core/export.h"
#include "asterism/kernels/c_batch.h"

#ifdef __cplusplus
extern "C" {
#endif

/* NOLINTBEGIN(modernize-use-using): C */
/* Sites in an index. */
typedef struct asterism_sites asterism_sites;
/* The star of one site. */
typedef struct asterism_star asterism_star;

/* The boundary of a domain whose vertices are sites, and lines inside it that are to be edges; as
 * check_domain (mesh/domain/check_domain.hpp) takes them, in any direction. */
typedef struct asterism_boundary {
  size_t segment_count;
  const unsigned* segments; /* two sites by number */
  size_t hole_count;
  const double* holes; /* x y, a point inside each */
} asterism_boundary;
/* NOLINTEND(modernize-use-using) */

/* Sets all to null and 0. */
ASTERISM_EXPORT void asterism_boundary_init(asterism_boundary* boundary);

/* Copies `count` sites; the domain is the plane. */
ASTERISM_EXPORT asterism_status asterism_sites_create(size_t count, asterism_rows sites,
                                                      asterism_sites** out);
/* Copies `count` sites within a boundary. A segment with sites on it counts as split there.
 * ASTERISM_REFUSED, and why in `message` (as mesh/c_interface/mesh.h has it): check_domain refuses
 * the boundary, or a site lies outside or in a hole. */
ASTERISM_EXPORT asterism_status asterism_sites_create_within(size_t count, asterism_rows sites,
                                                             const asterism_boundary* boundary,
                                                             asterism_sites** out, char* message,
                                                             size_t capacity);
/* Frees the sites; null is allowed. Their stars must not be offered anything afterwards. */
ASTERISM_EXPORT void asterism_sites_free(asterism_sites* sites);
/* Returns how many sites there are. */
ASTERISM_EXPORT size_t asterism_sites_count(const asterism_sites* sites);

/* Returns how many subsegments there are; one inside the domain counts twice. */
ASTERISM_EXPORT size_t asterism_sites_subsegment_count(const asterism_sites* sites);
/* Writes the ends of a subsegment, with the domain on its left; one inside the domain comes in both
 * directions. ASTERISM_OUT_OF_RANGE: there are not so many. */
ASTERISM_EXPORT asterism_status asterism_sites_subsegment(const asterism_sites* sites, size_t which,
                                                          unsigned ends[2]);

/* Adds a site, whose number is the count before. ASTERISM_REFUSED: it is not strictly inside the
 * boundary. Fast inside the smallest box around the sites there were at first; outside of it
 * everything is sorted again. Stars know nothing of it until it is offered to them. */
ASTERISM_EXPORT asterism_status asterism_sites_add(asterism_sites* sites, const double site[5]);

/* Adds a site, whose number is the count before, on the subsegment between sites a and b, which
 * becomes two. A place that rounding moved off the subsegment will do: the split polygon is the
 * domain from then on. ASTERISM_REFUSED: the place is outside the box of a and b, or another site
 * or subsegment is in the sliver between the subsegment and the new ones. ASTERISM_OUT_OF_RANGE: a
 * and b are no subsegment.
 * Stars that the split concerns (of a and b, and those with an edge that the new subsegments hide)
 * are built anew when a site is next offered to them. */
ASTERISM_EXPORT asterism_status asterism_sites_split(asterism_sites* sites, size_t a, size_t b,
                                                     const double site[5]);

/* Builds the star of site v from all others that it sees. A function of the sites alone. */
ASTERISM_EXPORT asterism_status asterism_star_build(const asterism_sites* sites, size_t v,
                                                    asterism_star** out);
/* Frees a star; null is allowed. */
ASTERISM_EXPORT void asterism_star_free(asterism_star* star);

/* Offers site w to a star of these sites: inserts it if it belongs there, and removes the
 * neighbours beside it that then no longer do. *changed becomes 1 or 0. A star that has w, or is
 * w's own, does not change, but for what a split did to it. What was removed is not looked for
 * again: build the star anew where it matters that it is as if built from all sites. */
ASTERISM_EXPORT asterism_status asterism_star_insert(const asterism_sites* sites,
                                                     asterism_star* star, size_t w, int* changed);

/* Returns the number of the site that the star belongs to. */
ASTERISM_EXPORT size_t asterism_star_center(const asterism_star* star);
/* Returns the number of sectors: 1, but for a site on the boundary that has more angles. */
ASTERISM_EXPORT size_t asterism_star_sector_count(const asterism_star* star);
/* Returns the neighbours in a sector, counter-clockwise. *closed becomes 1 if it is the full turn
 * of a site inside: which one comes first then means nothing, and the last and the first are in a
 * row, too. Owned by the star, valid until it changes or is freed. Null: no such sector. */
ASTERISM_EXPORT const unsigned* asterism_star_sector(const asterism_star* star, size_t which,
                                                     size_t* count, int* closed);
/* Returns the neighbours in the first sector: of a site that is not on the boundary, all. */
ASTERISM_EXPORT const unsigned* asterism_star_neighbours(const asterism_star* star, size_t* count);
/* Returns 1 if, when built, every neighbour passed its own test and no other site was accepted; 0
 * if neighbours were still replacing each other when the bound on rounds was met. An insertion does
 * not change it. */
ASTERISM_EXPORT int asterism_star_is_settled(const asterism_star* star);

#ifdef __cplusplus
}
#endif

#endif /* ASTERISM_MESH_C_INTERFACE_STARS_H */
