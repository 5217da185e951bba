/* SPDX-License-Identifier: MIT
 *
 * Stars within a boundary from a C89 program: an L with a hole and a line inside, in one tilted
 * metric, where the boundary's long segments are encroached and the stars agree all the same. The
 * triangles that stars agree about fill the domain; splits and new sites are taken up; what does
 * not fit is refused. */
#include <stdio.h>
#include <string.h>

#include "asterism/mesh/c_interface/stars.h"

static int failures = 0;

static void expect(int holds, const char* what) {
  if (holds) return;
  ++failures;
  fprintf(stderr, "failed: %s\n", what);
}

/* The corners of the L and of its hole, the ends of the line, and a grid inside. */
#define CORNERS 6
#define MOST 400
static double table[MOST][5];
static size_t count = 0;
static const double hole[2] = {1.5, 1.5};
static const unsigned segments[] = {0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 0, /* the L */
                                    6, 7, 7, 8, 8, 9, 9, 6,             /* the hole */
                                    0, 10};                             /* the line */

static void append(double x, double y) {
  double* const row = table[count++];
  row[0] = x;
  row[1] = y;
  row[2] = 2;
  row[3] = 0.5;
  row[4] = 1;
}

static void fill_table(void) {
  static const double corners[][2] = {{0, 0},       {4, 0},    {4, 2},     {2, 2},
                                      {2, 4},       {0, 4},    {1, 1},     {1.75, 1},
                                      {1.75, 1.75}, {1, 1.75}, {0.5, 0.75}};
  size_t k, row, column;
  count = 0;
  for (k = 0; k < sizeof corners / sizeof corners[0]; ++k) append(corners[k][0], corners[k][1]);
  for (row = 1; row < 16; ++row)
    for (column = 1; column < 16; ++column) {
      const double x = 0.25 * (double)column + 0.03125 * (double)(row % 3), y = 0.25 * (double)row;
      const int outside = x >= 2 && y >= 2;
      const int in_hole = x >= 1 && x <= 1.75 && y >= 1 && y <= 1.75;
      const int on_line = 2 * y == 3 * x && x <= 0.5;
      if (!outside && !in_hole && !on_line && x < 4) append(x, y);
    }
}

static asterism_rows rows(void) {
  asterism_rows all;
  all.first = table[0];
  all.stride = 5;
  return all;
}

static void make_boundary(asterism_boundary* boundary) {
  asterism_boundary_init(boundary);
  boundary->segment_count = sizeof segments / sizeof segments[0] / 2;
  boundary->segments = segments;
  boundary->hole_count = 1;
  boundary->holes = hole;
}

static double doubled_area(size_t u, size_t v, size_t w) {
  return (table[v][0] - table[u][0]) * (table[w][1] - table[u][1]) -
         (table[w][0] - table[u][0]) * (table[v][1] - table[u][1]);
}

static int has_triangle(const asterism_star* star, unsigned y, unsigned x) {
  size_t sector, n, i;
  int closed;
  for (sector = 0; sector < asterism_star_sector_count(star); ++sector) {
    const unsigned* const at = asterism_star_sector(star, sector, &n, &closed);
    for (i = 0; i + (closed ? 0 : 1) < n; ++i)
      if (at[i] == y && at[(i + 1) % n] == x) return 1;
  }
  return 0;
}

static int is_neighbour(const asterism_star* star, unsigned w) {
  size_t n, i;
  const unsigned* const at = asterism_star_neighbours(star, &n);
  for (i = 0; i < n; ++i)
    if (at[i] == w) return 1;
  return 0;
}

static asterism_star* stars[MOST];

static void free_stars(void) {
  size_t v;
  for (v = 0; v < MOST; ++v) {
    asterism_star_free(stars[v]);
    stars[v] = NULL;
  }
}

/* Adds up the triangles that all three corners have, each once; tells of those that fewer have. */
static double agreed_area(size_t* disagreeing) {
  double doubled = 0;
  size_t v, sector, n, i;
  int closed;
  *disagreeing = 0;
  for (v = 0; v < count; ++v)
    for (sector = 0; sector < asterism_star_sector_count(stars[v]); ++sector) {
      const unsigned* const at = asterism_star_sector(stars[v], sector, &n, &closed);
      for (i = 0; i + (closed ? 0 : 1) < n; ++i) {
        const unsigned y = at[i], x = at[(i + 1) % n];
        if (!(doubled_area(v, y, x) > 0)) continue;
        if (!has_triangle(stars[y], x, (unsigned)v) || !has_triangle(stars[x], (unsigned)v, y))
          ++*disagreeing;
        else if (v < y && v < x)
          doubled += doubled_area(v, y, x);
      }
    }
  return doubled / 2;
}

static void build_all(const asterism_sites* sites) {
  size_t v;
  free_stars();
  for (v = 0; v < count; ++v)
    expect(asterism_star_build(sites, v, &stars[v]) == ASTERISM_OK &&
               asterism_star_is_settled(stars[v]),
           "build");
}

static asterism_sites* make_sites(void) {
  asterism_sites* sites = NULL;
  asterism_boundary boundary;
  char message[200];
  fill_table();
  make_boundary(&boundary);
  expect(asterism_sites_create_within(count, rows(), &boundary, &sites, message, sizeof message) ==
             ASTERISM_OK,
         message);
  return sites;
}

static void test_filling(void) {
  asterism_sites* const sites = make_sites();
  size_t disagreeing, n, k, both_ways = 0;
  unsigned ends[2];
  int closed;
  const unsigned* at;
  expect(asterism_sites_subsegment_count(sites) == 12, "the line counts twice");
  for (k = 0; k < 12; ++k) {
    expect(asterism_sites_subsegment(sites, k, ends) == ASTERISM_OK, "subsegment");
    both_ways += (ends[0] == 0 && ends[1] == 10) || (ends[0] == 10 && ends[1] == 0);
  }
  expect(both_ways == 2, "in both directions");
  expect(asterism_sites_subsegment(sites, 12, ends) == ASTERISM_OUT_OF_RANGE, "no more");
  build_all(sites);
  /* 12 is the area of the L, 9/16 that of the hole. */
  expect(agreed_area(&disagreeing) == 12 - 0.5625, "agreeing triangles fill the domain");
  expect(disagreeing == 0, "all stars agree");
  expect(asterism_star_sector_count(stars[0]) == 2, "the line parts the corner");
  at = asterism_star_sector(stars[0], 0, &n, &closed);
  expect(n >= 2 && !closed && (at[0] == 1 || at[0] == 10), "a sector begins at a subsegment");
  at = asterism_star_sector(stars[10], 0, &n, &closed);
  expect(asterism_star_sector_count(stars[10]) == 1 && !closed && at[0] == 0 && at[n - 1] == 0,
         "the free end of the line: a full turn, cut open");
  at = asterism_star_sector(stars[11], 0, &n, &closed);
  expect(at != NULL && closed && asterism_star_neighbours(stars[11], &k) == at && k == n, "inside");
  expect(asterism_star_sector(stars[11], 1, &n, &closed) == NULL && n == 0 && !closed, "no sector");
  free_stars();
  asterism_sites_free(sites);
}

/* Splits, offers the new site to all stars, and holds them against stars built anew. */
static void test_splits(void) {
  asterism_sites* const sites = make_sites();
  size_t disagreeing, v, changes = 0;
  double area = 12 - 0.5625;
  int changed = 9, which;
  build_all(sites);
  for (which = 0; which < 3; ++which) {
    const unsigned ends[][2] = {{0, 1}, {10, 0}, {3, 4}};
    const double at[][2] = {{1.125, 0}, {0.25, 0.375}, {2 - 0.0078125, 3.0625}};
    append(at[which][0], at[which][1]);
    expect(asterism_sites_split(sites, ends[which][0], ends[which][1], table[count - 1]) ==
               (which == 2 ? ASTERISM_REFUSED : ASTERISM_OK),
           "split");
    if (which == 2) break; /* outside the box of a vertical subsegment */
    for (v = 0; v + 1 < count; ++v) {
      expect(asterism_star_insert(sites, stars[v], count - 1, &changed) == ASTERISM_OK, "insert");
      changes += (size_t)changed;
    }
    expect(asterism_star_build(sites, count - 1, &stars[count - 1]) == ASTERISM_OK, "its own star");
    expect(asterism_star_sector_count(stars[count - 1]) == (which == 0 ? 1u : 2u), "sectors");
  }
  --count;
  expect(changes >= 6, "stars have taken up the new sites");
  expect(agreed_area(&disagreeing) == area && disagreeing == 0, "they fill the domain");
  expect(asterism_sites_split(sites, 0, 1, table[0]) == ASTERISM_OUT_OF_RANGE, "no subsegment now");
  expect(asterism_sites_split(sites, 0, 400, table[0]) == ASTERISM_OUT_OF_RANGE, "no such site");
  expect(asterism_sites_split(sites, 1, 2, table[3]) == ASTERISM_EQUAL_SITES, "a place taken");
  free_stars();
  asterism_sites_free(sites);
}

/* A split point that rounding, here an eighth, has put inside: it hides sites from each other. */
static void test_bent_split(void) {
  static const double square[][2] = {{0, 0}, {4, 1},           {4, 5},
                                     {0, 5}, {1.75, 0.671875}, {2.25, 0.796875}};
  static const unsigned around[] = {0, 1, 1, 2, 2, 3, 3, 0};
  asterism_sites* sites = NULL;
  asterism_boundary boundary;
  int changed = 9;
  size_t k, v, disagreeing;
  const double near_tip[5] = {2, 0.75, 2, 0.5, 1}, off[5] = {2, 1.375, 1, 0, 1};
  count = 0;
  for (k = 0; k < 6; ++k) append(square[k][0], square[k][1]);
  asterism_boundary_init(&boundary);
  boundary.segment_count = 4;
  boundary.segments = around;
  expect(asterism_sites_create_within(count, rows(), &boundary, &sites, NULL, 0) == ASTERISM_OK,
         "create");
  build_all(sites);
  expect(is_neighbour(stars[4], 5) && is_neighbour(stars[5], 4), "neighbours before");
  expect(asterism_sites_split(sites, 1, 0, off) == ASTERISM_REFUSED, "outside the box");
  expect(asterism_sites_split(sites, 1, 0, near_tip) == ASTERISM_OK, "split");
  append(near_tip[0], near_tip[1]);
  for (v = 0; v < 6; ++v)
    expect(asterism_star_insert(sites, stars[v], 6, &changed) == ASTERISM_OK, "insert");
  expect(asterism_star_build(sites, 6, &stars[6]) == ASTERISM_OK, "build");
  expect(!is_neighbour(stars[4], 5) && !is_neighbour(stars[5], 4), "hidden by the tip");
  expect(agreed_area(&disagreeing) == 18 - 0.5 && disagreeing == 0, "the split polygon is filled");
  free_stars();
  asterism_sites_free(sites);
}

static void expect_refused(const asterism_boundary* boundary, const char* word) {
  asterism_sites* sites = NULL;
  char message[200], cut[5];
  expect(asterism_sites_create_within(count, rows(), boundary, &sites, message, sizeof message) ==
             ASTERISM_REFUSED,
         word);
  expect(strstr(message, word) != NULL, message);
  expect(asterism_sites_create_within(count, rows(), boundary, &sites, cut, sizeof cut) ==
                 ASTERISM_REFUSED &&
             strlen(cut) == 4,
         "cut where it does not fit");
  expect(sites == NULL, "nothing is made");
}

static void test_refusals(void) {
  static const unsigned crossing[] = {0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 0, 1, 4};
  asterism_boundary boundary, wrong;
  asterism_sites* sites = make_sites();
  const double outside[5] = {3, 3, 1, 0, 1}, in_hole[5] = {1.5, 1.5, 1, 0, 1};
  const double on_boundary[5] = {3, 0, 1, 0, 1}, fits[5] = {3.015625, 1.015625, 1, 0, 1};
  expect(asterism_sites_add(sites, outside) == ASTERISM_REFUSED, "outside");
  expect(asterism_sites_add(sites, in_hole) == ASTERISM_REFUSED, "in the hole");
  expect(asterism_sites_add(sites, on_boundary) == ASTERISM_REFUSED, "on the boundary");
  expect(asterism_sites_count(sites) == count, "nothing has changed");
  expect(asterism_sites_add(sites, fits) == ASTERISM_OK, "inside");
  asterism_sites_free(sites);
  sites = NULL;

  make_boundary(&boundary);
  expect(
      asterism_sites_create_within(count, rows(), NULL, &sites, NULL, 0) == ASTERISM_NULL_POINTER,
      "null");
  wrong = boundary;
  wrong.segments = NULL;
  expect_refused(&wrong, "null");
  wrong = boundary;
  wrong.segments = crossing;
  wrong.segment_count = 7;
  wrong.hole_count = 0;
  expect_refused(&wrong, "cross");
  append(3, 3);
  expect_refused(&boundary, "is not inside the boundary");
  --count;
  append(1.5, 1.5);
  expect_refused(&boundary, "is not inside the boundary");
  --count;
  table[count - 1][3] = 9;
  expect(asterism_sites_create_within(count, rows(), &boundary, &sites, NULL, 0) ==
             ASTERISM_NOT_POSITIVE_DEFINITE,
         "indefinite");
}

int main(void) {
  test_filling();
  test_splits();
  test_bent_split();
  test_refusals();
  if (failures == 0) puts("stars keep within their boundary as documented");
  return failures == 0 ? 0 : 1;
}
