/* SPDX-License-Identifier: MIT
 *
 * Offers the star builder to C: the neighbours of a site in the stars of given sites, in exact
 * counter-clockwise order. A mesh generator with loops of its own can take its stars from here.
 *
 * The domain is the whole plane: there is no boundary, and a gap between two neighbours of 180
 * degrees or more holds no triangle. Two neighbours y, x in a row (x last) with a narrower gap make
 * the triangle v, y, x; it is part of a triangulation when the stars of y and x have it too.
 *
 * Sites are numbered from 0 in the order they came in. Checks, statuses, errors: those of
 * kernels/c_api.h; on a failure nothing has changed and *out is left as it was.
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
/* NOLINTEND(modernize-use-using) */

/* Copies `count` sites. */
ASTERISM_EXPORT asterism_status asterism_sites_create(size_t count, asterism_rows sites,
                                                      asterism_sites** out);
/* Frees the sites; null is allowed. Their stars must not be offered anything afterwards. */
ASTERISM_EXPORT void asterism_sites_free(asterism_sites* sites);
/* Returns how many sites there are. */
ASTERISM_EXPORT size_t asterism_sites_count(const asterism_sites* sites);

/* Adds a site, whose number is the count before. Fast inside the smallest box around the sites
 * there were at first; outside of it everything is sorted again. Stars know nothing of it until it
 * is offered to them. */
ASTERISM_EXPORT asterism_status asterism_sites_add(asterism_sites* sites, const double site[5]);

/* Builds the star of site v from all others. A function of the sites alone. */
ASTERISM_EXPORT asterism_status asterism_star_build(const asterism_sites* sites, size_t v,
                                                    asterism_star** out);
/* Frees a star; null is allowed. */
ASTERISM_EXPORT void asterism_star_free(asterism_star* star);

/* Offers site w to a star of these sites: inserts it if it belongs there, and removes the
 * neighbours beside it that then no longer do. *changed becomes 1 or 0. A star that has w, or is
 * w's own, does not change. What was removed is not looked for again: build the star anew where it
 * matters that it is as if built from all sites. */
ASTERISM_EXPORT asterism_status asterism_star_insert(const asterism_sites* sites,
                                                     asterism_star* star, size_t w, int* changed);

/* Returns the number of the site that the star belongs to. */
ASTERISM_EXPORT size_t asterism_star_center(const asterism_star* star);
/* Returns the neighbours, counter-clockwise; which one comes first means nothing. Owned by the
 * star, valid until it changes or is freed. */
ASTERISM_EXPORT const unsigned* asterism_star_neighbours(const asterism_star* star, size_t* count);
/* Returns 1 if, when built, every neighbour passed its own test and no other site was accepted; 0
 * if neighbours were still replacing each other when the bound on rounds was met. An insertion does
 * not change it. */
ASTERISM_EXPORT int asterism_star_is_settled(const asterism_star* star);

#ifdef __cplusplus
}
#endif

#endif /* ASTERISM_MESH_C_INTERFACE_STARS_H */
