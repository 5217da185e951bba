/* SPDX-License-Identifier: MIT
 *
 * A C program that takes its stars from the library: a grid of sites whose metrics stretch along
 * circles, a triangle wherever three stars agree. Prints how many are in one or two stars only.
 * Exit status 0: some on the coarse grid, none on the fine one. */
#include <asterism/kernels/c_api.h>
#include <asterism/mesh/c_interface/stars.h>
#include <stdio.h>
#include <stdlib.h>

#define MOST 41

static double table[MOST * MOST][5]; /* x y m11 m12 m22 */
static asterism_star* star[MOST * MOST];

static size_t fill_table(int side) {
  size_t n = 0;
  int i, j;
  for (i = 0; i < side; ++i)
    for (j = 0; j < side; ++j, ++n) {
      const double x = 2.0 * (i + (j % 2) * 0.375) / side - 1, y = 2.0 * j / side - 1;
      double* const row = table[n];
      row[0] = x;
      row[1] = y;
      row[2] = 1 + 12 * x * x;
      row[3] = 12 * x * y;
      row[4] = 1 + 12 * y * y;
    }
  return n;
}

/* The neighbours y and x in row k of the star of v, if they make a triangle with it. */
static int triangle_at(size_t v, size_t k, unsigned* y, unsigned* x) {
  size_t count;
  int closed, turn;
  const unsigned* const ring = asterism_star_sector(star[v], 0, &count, &closed);
  if (k >= count) return 0;
  *y = ring[k];
  *x = ring[(k + 1) % count];
  if (asterism_orientation(table[v], table[*y], table[*x], &turn) != ASTERISM_OK) exit(2);
  return turn > 0; /* else the gap between them is 180 degrees or more */
}

static size_t rows_of(size_t v) {
  size_t count;
  int closed;
  asterism_star_sector(star[v], 0, &count, &closed);
  return count;
}

static int has_triangle(size_t v, unsigned wanted_y, unsigned wanted_x) {
  unsigned y, x;
  size_t k;
  for (k = 0; k < rows_of(v); ++k)
    if (triangle_at(v, k, &y, &x) && y == wanted_y && x == wanted_x) return 1;
  return 0;
}

/* Triangles of stars that another of their vertices does not have. */
static long disagreeing(size_t n, long* all) {
  long found = 0;
  size_t v, k;
  unsigned y, x;
  *all = 0;
  for (v = 0; v < n; ++v)
    for (k = 0; k < rows_of(v); ++k) {
      if (!triangle_at(v, k, &y, &x)) continue;
      ++*all;
      if (!has_triangle(y, x, (unsigned)v) || !has_triangle(x, (unsigned)v, y)) ++found;
    }
  return found;
}

static long try_grid(int side) {
  asterism_rows rows;
  asterism_sites* sites = NULL;
  long all, wrong;
  const size_t n = fill_table(side);
  size_t v;
  rows.first = table[0];
  rows.stride = 5;
  if (asterism_sites_create(n, rows, &sites) != ASTERISM_OK) exit(2);
  /* Stars know nothing of each other: any number of threads may build them. */
  for (v = 0; v < n; ++v)
    if (asterism_star_build(sites, v, &star[v]) != ASTERISM_OK) exit(2);
  wrong = disagreeing(n, &all);
  for (v = 0; v < n; ++v) asterism_star_free(star[v]);
  asterism_sites_free(sites);
  printf("%d sites: %ld triangles of stars, %ld not in all three\n", (int)n, all, wrong);
  return wrong;
}

int main(void) {
  const long coarse = try_grid(5), fine = try_grid(41);
  return coarse > 0 && fine == 0 ? 0 : 1;
}
