/* SPDX-License-Identifier: MIT
 *
 * cavity_mesher POINTS ARITHMETIC [FIELD]: a mesh generator in C89 that inserts points into the
 * square [0,1024]^2 by cavities (Bowyer and Watson), each in the metric at the new point, as gmsh
 * does. ARITHMETIC is exact or double: who answers orientation and in_circle. FIELD is constant
 * (default), a stretched and turned metric in which the points lie on many common ellipses, or
 * swirl.
 *
 * Two questions are asked. Is the new point inside the ellipse through a triangle's corners? Then
 * the triangle goes. Does it see a side of the hole from the left? Else the triangle behind the
 * side goes too, since the new triangles would overlap: in a metric that varies the hole need not
 * be seen whole. Both answers are signs that no rounding may change, or triangles are inverted.
 *
 * Prints triangles, inverted ones (by the exact orientation), points refused, questions. Exit
 * status 1 if anything is wrong with the mesh, whatever the arithmetic.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asterism/kernels/c_api.h"

#define MOST_HOLE 4096 /* triangles in one hole; more is refused */

typedef struct triangle {
  int corner[3]; /* counter-clockwise; corner[0] < 0: not in use */
  int beside[3]; /* the triangle across from corner k, -1 outside */
} triangle;

typedef struct side { /* of a hole, from a to b with the hole on its left */
  int a, b, beside;
} side;

typedef struct mesh {
  double (*point)[2];
  triangle* of;
  int points, triangles, last, exact, varies;
  long orientations, circles;
} mesh;

static void metric_at(const mesh* m, const double p[2], double metric[3]) {
  double x, y;
  if (!m->varies) { /* eigenvalues 5 and 50000, about (2, 1): short that way */
    metric[0] = 40001;
    metric[1] = 19998;
    metric[2] = 10004;
    return;
  }
  x = (p[0] - 512) / 512;
  y = (p[1] - 512) / 512;
  metric[0] = 1 + 12 * x * x;
  metric[1] = 12 * x * y;
  metric[2] = 1 + 12 * y * y;
}

static int sign_of(double value) { return (value > 0) - (value < 0); }

static int exact_orientation(const double* p, const double* q, const double* r) {
  int answer = 0;
  if (asterism_orientation(p, q, r, &answer) != ASTERISM_OK) abort();
  return answer;
}

static int orientation(mesh* m, const double* p, const double* q, const double* r) {
  ++m->orientations;
  if (m->exact) return exact_orientation(p, q, r);
  return sign_of((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
}

static double squared_length(const double* m, double x, double y) {
  return m[0] * x * x + 2 * m[1] * x * y + m[2] * y * y;
}

/* Is p inside the ellipse of the metric through the triangle's corners? */
static int in_circle(mesh* m, const double metric[3], const triangle* t, const double* p) {
  const double *a = m->point[t->corner[0]], *b = m->point[t->corner[1]];
  const double* c = m->point[t->corner[2]];
  ++m->circles;
  if (m->exact) {
    int answer = 0;
    if (asterism_in_circle(metric, a, b, c, p, &answer) != ASTERISM_OK) abort();
    return answer;
  } else {
    const double ax = a[0] - p[0], ay = a[1] - p[1], bx = b[0] - p[0], by = b[1] - p[1];
    const double cx = c[0] - p[0], cy = c[1] - p[1];
    return sign_of(squared_length(metric, ax, ay) * (bx * cy - by * cx) -
                   squared_length(metric, bx, by) * (ax * cy - ay * cx) +
                   squared_length(metric, cx, cy) * (ax * by - ay * bx));
  }
}

/* The triangle that holds p, its sides included, by a walk; by looking at all where that does not
 * end, as it need not in a metric that varies. -1: none. */
static int triangle_of(mesh* m, const double* p) {
  int at = m->last, steps, i, k;
  for (steps = 0; steps < m->triangles && at >= 0; ++steps) {
    const triangle* t = &m->of[at];
    for (k = 0; k < 3; ++k)
      if (orientation(m, m->point[t->corner[(k + 1) % 3]], m->point[t->corner[(k + 2) % 3]], p) < 0)
        break;
    if (k == 3) return at;
    at = t->beside[k];
  }
  for (i = 0; i < m->triangles; ++i) {
    const triangle* t = &m->of[i];
    for (k = 0; k < 3 && t->corner[0] >= 0; ++k)
      if (orientation(m, m->point[t->corner[(k + 1) % 3]], m->point[t->corner[(k + 2) % 3]], p) < 0)
        break;
    if (k == 3) return i;
  }
  return -1;
}

static int is_in(const int* hole, int count, int t) {
  int i;
  for (i = 0; i < count; ++i)
    if (hole[i] == t) return 1;
  return 0;
}

/* Triangles around `first` whose ellipses hold p, and those behind sides that p does not see from
 * the left. Returns how many; 0: too many, or p lies on the border of the square. */
static int make_hole(mesh* m, const double* p, int first, int* hole) {
  double metric[3];
  int count = 1, i, k, grown = 1;
  metric_at(m, p, metric);
  hole[0] = first;
  for (i = 0; i < count; ++i)
    for (k = 0; k < 3; ++k) {
      const int next = m->of[hole[i]].beside[k];
      if (next < 0 || is_in(hole, count, next)) continue;
      if (in_circle(m, metric, &m->of[next], p) <= 0) continue;
      if (count == MOST_HOLE) return 0;
      hole[count++] = next;
    }
  while (grown) { /* the hole only grows, and there are finitely many triangles */
    grown = 0;
    for (i = 0; i < count; ++i)
      for (k = 0; k < 3; ++k) {
        const triangle* t = &m->of[hole[i]];
        const int next = t->beside[k];
        if (next >= 0 && is_in(hole, count, next)) continue;
        if (orientation(m, m->point[t->corner[(k + 1) % 3]], m->point[t->corner[(k + 2) % 3]], p) >
            0)
          continue;
        if (next < 0 || count == MOST_HOLE) return 0;
        hole[count++] = next;
        grown = 1;
      }
  }
  return count;
}

static int sides_of(const mesh* m, const int* hole, int count, side* sides) {
  int i, k, found = 0;
  for (i = 0; i < count; ++i)
    for (k = 0; k < 3; ++k) {
      const triangle* t = &m->of[hole[i]];
      if (t->beside[k] >= 0 && is_in(hole, count, t->beside[k])) continue;
      sides[found].a = t->corner[(k + 1) % 3];
      sides[found].b = t->corner[(k + 2) % 3];
      sides[found++].beside = t->beside[k];
    }
  return found;
}

static void put_beside(mesh* m, int t, int a, int b, int now) {
  int k;
  for (k = 0; t >= 0 && k < 3; ++k)
    if (m->of[t].corner[(k + 1) % 3] == b && m->of[t].corner[(k + 2) % 3] == a)
      m->of[t].beside[k] = now;
}

/* Fills the hole with triangles from its sides to the new point. */
static void fill_hole(mesh* m, int p, const int* hole, int count, const side* sides, int found) {
  static int place[3 * MOST_HOLE + 3];
  int i, j;
  for (i = 0; i < count; ++i) m->of[hole[i]].corner[0] = -1;
  for (i = 0; i < found; ++i) {
    triangle t;
    place[i] = i < count ? hole[i] : m->triangles++;
    t.corner[0] = p;
    t.corner[1] = sides[i].a;
    t.corner[2] = sides[i].b;
    t.beside[0] = sides[i].beside;
    t.beside[1] = t.beside[2] = -1;
    m->of[place[i]] = t;
    put_beside(m, sides[i].beside, sides[i].a, sides[i].b, place[i]);
  }
  for (i = 0; i < found; ++i)
    for (j = 0; j < found; ++j)
      if (sides[j].a == sides[i].b) {
        m->of[place[i]].beside[1] = place[j];
        m->of[place[j]].beside[2] = place[i];
      }
  m->last = place[0];
}

static int is_corner(const mesh* m, const triangle* t, const double* p) {
  int k;
  for (k = 0; k < 3; ++k)
    if (m->point[t->corner[k]][0] == p[0] && m->point[t->corner[k]][1] == p[1]) return 1;
  return 0;
}

/* 1: inserted, or there already; 0: refused. The hole of a simply connected region of n triangles
 * has n + 2 sides; another number says that an answer was wrong, and the point is refused before
 * any harm is done. */
static int insert(mesh* m, double x, double y) {
  static int hole[MOST_HOLE];
  static side sides[3 * MOST_HOLE];
  double* p = m->point[m->points];
  int first, count, found;
  p[0] = x;
  p[1] = y;
  first = triangle_of(m, p);
  if (first < 0) return 0;
  if (is_corner(m, &m->of[first], p)) return 1;
  count = make_hole(m, p, first, hole);
  if (count == 0) return 0;
  found = sides_of(m, hole, count, sides);
  if (found != count + 2) return 0;
  fill_hole(m, m->points++, hole, count, sides, found);
  return 1;
}

static void start(mesh* m, int points) {
  static const triangle first = {{0, 1, 2}, {-1, 1, -1}}, second = {{0, 2, 3}, {-1, -1, 0}};
  static const double corners[4][2] = {{0, 0}, {1024, 0}, {1024, 1024}, {0, 1024}};
  m->point = malloc(sizeof *m->point * (size_t)(points + 5));
  m->of = malloc(sizeof *m->of * (size_t)(2 * points + 16));
  if (m->point == NULL || m->of == NULL) abort();
  memcpy(m->point, corners, sizeof corners);
  m->of[0] = first;
  m->of[1] = second;
  m->points = 4;
  m->triangles = 2;
  m->last = 0;
  m->orientations = m->circles = 0;
}

static unsigned long state = 12345;
static unsigned long drawn(unsigned long below) { /* numerical recipes' generator, upper bits */
  state = (state * 1664525UL + 1013904223UL) & 0xffffffffUL;
  return (state >> 8) % below;
}

int main(int count, char** words) {
  static const double unit = 2.2204460492503131e-16;
  mesh m;
  int wanted, i, refused = 0, inverted = 0, used = 0;
  if (count < 3 || (wanted = atoi(words[1])) < 1 || wanted > 10000000) return 2;
  m.exact = strcmp(words[2], "exact") == 0;
  if (!m.exact && strcmp(words[2], "double") != 0) return 2;
  m.varies = count > 3 && strcmp(words[3], "swirl") == 0;
  start(&m, wanted);
  for (i = 0; i < wanted; ++i) {
    /* A lattice, moved by as little as doubles can be: many are nearly on one line or ellipse. */
    const double x = 16.0 * (1 + (double)drawn(63)), y = 16.0 * (1 + (double)drawn(63));
    const double moved = x * (1 + ((double)drawn(3) - 1) * unit);
    refused += !insert(&m, moved, y * (1 + ((double)drawn(3) - 1) * unit));
  }
  for (i = 0; i < m.triangles; ++i) {
    const int* c = m.of[i].corner;
    if (c[0] < 0) continue;
    ++used;
    inverted += exact_orientation(m.point[c[0]], m.point[c[1]], m.point[c[2]]) <= 0;
  }
  printf(
      "%s: %d points, %d triangles, %d inverted, %d points refused, %ld orientations, %ld "
      "in_circle\n",
      words[2], m.points, used, inverted, refused, m.orientations, m.circles);
  free(m.point);
  free(m.of);
  return inverted > 0 || used != 2 * (m.points - 4) + 2;
}
