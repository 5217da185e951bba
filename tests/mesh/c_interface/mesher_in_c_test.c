/* SPDX-License-Identifier: MIT
 *
 * Stars and meshes from a C89 program: what comes back, what is refused, and that nothing is left
 * behind (the sanitizer build tells). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asterism/mesh/c_interface/mesh.h"
#include "asterism/mesh/c_interface/stars.h"

static int failures = 0;

static void expect(int holds, const char* what) {
  if (holds) return;
  ++failures;
  fprintf(stderr, "failed: %s\n", what);
}

/* A grid whose sites see the plane in a round metric, every second row moved by half a step. */
#define SIDE 7
static double grid[SIDE * SIDE + 1][5];

static asterism_rows grid_rows(void) {
  asterism_rows rows;
  size_t k;
  for (k = 0; k < SIDE * SIDE; ++k) {
    grid[k][0] = (double)(k % SIDE) + 0.5 * (double)(k / SIDE % 2);
    grid[k][1] = (double)(k / SIDE);
    grid[k][2] = grid[k][4] = 1;
  }
  rows.first = grid[0];
  rows.stride = 5;
  return rows;
}

static int has_neighbour(const asterism_star* star, unsigned w) {
  size_t count, k;
  const unsigned* neighbours = asterism_star_neighbours(star, &count);
  for (k = 0; k < count; ++k)
    if (neighbours[k] == w) return 1;
  return 0;
}

static void test_stars(void) {
  const double near_centre[5] = {3.5, 3.25, 1, 0, 1}, far_off[5] = {90, 3, 1, 0, 1};
  const size_t centre = 3 * SIDE + 3, last = SIDE * SIDE;
  asterism_sites* sites = NULL;
  asterism_star *star = NULL, *again = NULL;
  size_t count, v, k, agreeing = 0;
  int changed = 9;
  expect(asterism_sites_create(SIDE * SIDE, grid_rows(), &sites) == ASTERISM_OK, "create sites");
  expect(asterism_sites_count(sites) == SIDE * SIDE, "count");
  expect(asterism_star_build(sites, centre, &star) == ASTERISM_OK, "build");
  (void)asterism_star_neighbours(star, &count);
  expect(count == 6 && asterism_star_center(star) == centre, "six neighbours");
  expect(asterism_star_is_settled(star), "settled");
  expect(has_neighbour(star, (unsigned)centre + 1) && has_neighbour(star, (unsigned)centre - SIDE),
         "the nearest sites");
  /* With ties broken alike from every side: w in the star of v is v in the star of w. */
  for (v = 0; v < SIDE * SIDE; ++v) {
    const unsigned* neighbours;
    asterism_star *of_v = NULL, *of_w = NULL;
    expect(asterism_star_build(sites, v, &of_v) == ASTERISM_OK, "build");
    neighbours = asterism_star_neighbours(of_v, &count);
    for (k = 0; k < count; ++k) {
      expect(asterism_star_build(sites, neighbours[k], &of_w) == ASTERISM_OK, "build");
      agreeing += !has_neighbour(of_w, (unsigned)v);
      asterism_star_free(of_w);
    }
    asterism_star_free(of_v);
  }
  expect(agreeing == 0, "neighbours of each other");

  expect(asterism_sites_add(sites, grid[4]) == ASTERISM_EQUAL_SITES, "a place taken");
  expect(asterism_sites_add(sites, near_centre) == ASTERISM_OK, "add");
  expect(asterism_sites_count(sites) == last + 1, "count");
  expect(!has_neighbour(star, (unsigned)last), "not before it is offered");
  expect(asterism_star_insert(sites, star, last, &changed) == ASTERISM_OK && changed == 1,
         "insert");
  expect(has_neighbour(star, (unsigned)last), "inserted");
  expect(asterism_star_insert(sites, star, last, &changed) == ASTERISM_OK && changed == 0, "twice");
  expect(asterism_star_insert(sites, star, centre, &changed) == ASTERISM_OK && changed == 0, "own");
  expect(asterism_star_insert(sites, star, 0, &changed) == ASTERISM_OK && changed == 0, "far");
  expect(asterism_star_insert(sites, star, last + 1, &changed) == ASTERISM_OUT_OF_RANGE, "range");
  expect(asterism_sites_add(sites, far_off) == ASTERISM_OK, "outside the box");
  expect(asterism_star_build(sites, centre, &again) == ASTERISM_OK, "build again");
  (void)asterism_star_neighbours(star, &count);
  (void)asterism_star_neighbours(again, &k);
  expect(count == k, "inserted or built, the same neighbours");
  expect(asterism_star_build(sites, last + 2, &again) == ASTERISM_OUT_OF_RANGE, "range");
  asterism_star_free(star);
  asterism_star_free(again);
  asterism_star_free(NULL);
  asterism_sites_free(sites);
  asterism_sites_free(NULL);
}

static void test_refused_sites(void) {
  asterism_sites* sites = NULL;
  const asterism_rows rows = grid_rows();
  grid[5][3] = 4;
  expect(asterism_sites_create(9, rows, &sites) == ASTERISM_NOT_POSITIVE_DEFINITE, "indefinite");
  grid[5][3] = 0;
  grid[5][0] = HUGE_VAL;
  expect(asterism_sites_create(9, rows, &sites) == ASTERISM_NOT_FINITE, "infinite");
  grid[5][0] = grid[4][0];
  expect(asterism_sites_create(9, rows, &sites) == ASTERISM_EQUAL_SITES, "equal");
  expect(sites == NULL, "nothing is made");
}

static const double corners[] = {0, 0, 1, 0, 1, 1, 0, 1};
static const unsigned sides[] = {0, 1, 1, 2, 2, 3, 3, 0};
static const int markers[] = {11, 12, 13, 14};

static void make_square(asterism_domain* square) {
  asterism_domain_init(square);
  square->vertex_count = 4;
  square->vertices = corners;
  square->segment_count = 4;
  square->segments = sides;
  square->segment_markers = markers;
}

static int stretched(void* context, double x, double y, double metric[3]) {
  ++*(int*)context;
  metric[0] = 40 * (1 + x);
  metric[1] = 0;
  metric[2] = 200 + y;
  return 0;
}

static int stretched_many(void* context, size_t count, const double* points, double* metrics) {
  size_t k;
  ++*(int*)context;
  for (k = 0; k < count; ++k) {
    int uncounted = 0;
    (void)stretched(&uncounted, points[2 * k], points[2 * k + 1], metrics + 3 * k);
  }
  return 0;
}

static int failing(void* context, double x, double y, double metric[3]) {
  (void)context, (void)y, (void)metric;
  return x >= 0;
}

static void expect_mesh(const asterism_mesh* mesh) {
  size_t sites, triangles, regions, edges, edge_markers, k;
  const double* const at = asterism_mesh_sites(mesh, &sites);
  const unsigned* const corners_of = asterism_mesh_triangles(mesh, &triangles);
  const int* const region = asterism_mesh_regions(mesh, &regions);
  const int* const marker = asterism_mesh_boundary_markers(mesh, &edge_markers);
  (void)asterism_mesh_boundary(mesh, &edges);
  expect(asterism_mesh_is_certified(mesh) && asterism_mesh_is_complete(mesh), "certified");
  expect(asterism_mesh_worst_angle(mesh) >= 20, "the angle bound");
  expect(strlen(asterism_mesh_reason(mesh)) > 0, "a reason");
  expect(sites > 10 && triangles > 10 && regions == triangles, "counts");
  expect(edges == edge_markers && edges >= 4, "boundary");
  expect(at[5] == 1 && at[6] == 0, "the second vertex is the domain's");
  expect(region[0] == 1, "region");
  for (k = 0; k < 3 * triangles; ++k) expect(corners_of[k] < sites, "corners");
  for (k = 0; k < edges; ++k) expect(marker[k] >= 11 && marker[k] <= 14, "markers");
}

static void test_verify(const asterism_mesh* mesh) {
  char message[200];
  int verified = 9;
  size_t length = strlen(asterism_mesh_certificate(mesh));
  char* const forged = malloc(length + 1);
  char* digit;
  expect(asterism_mesh_verify(mesh, NULL, &verified, message, sizeof message) == ASTERISM_OK &&
             verified == 1 && message[0] == '\0',
         "verified");
  expect(asterism_mesh_verify(mesh, "{}", &verified, message, sizeof message) == ASTERISM_REFUSED &&
             message[0] != '\0',
         "no certificate");
  if (forged == NULL) return;
  memcpy(forged, asterism_mesh_certificate(mesh), length + 1);
  digit = strstr(forged, "\"triangles\": ");
  expect(digit != NULL, "the certificate counts triangles");
  if (digit != NULL) digit[13] = digit[13] == '9' ? '8' : (char)(digit[13] + 1);
  expect(asterism_mesh_verify(mesh, forged, &verified, message, sizeof message) == ASTERISM_OK &&
             verified == 0 && message[0] != '\0',
         "a forged certificate");
  free(forged);
}

/* What was made is certified again as if it came from elsewhere, and is a metric for the next. */
static void test_arrays(const asterism_mesh* mesh) {
  asterism_domain square;
  asterism_metric metric;
  asterism_mesh* next = NULL;
  char message[200];
  int certified = 9;
  size_t sites, triangles, k;
  const double* const at = asterism_mesh_sites(mesh, &sites);
  const unsigned* const corners_of = asterism_mesh_triangles(mesh, &triangles);
  double* const places = malloc(sites * 2 * sizeof(double));
  double* const tensors = malloc(sites * 3 * sizeof(double));
  expect(asterism_certify(sites, at, triangles, corners_of, 20, &certified, message,
                          sizeof message) == ASTERISM_OK &&
             certified == 1,
         message);
  expect(asterism_certify(sites, at, triangles - 1, corners_of, 59, &certified, message,
                          sizeof message) == ASTERISM_OK &&
             certified == 0 && message[0] != '\0',
         "no angle is that large");
  expect(asterism_certify(sites - 1, at, triangles, corners_of, 20, &certified, message,
                          sizeof message) == ASTERISM_REFUSED,
         "a vertex that is not there");
  for (k = 0; places != NULL && tensors != NULL && k < sites; ++k) {
    memcpy(places + 2 * k, at + 5 * k, 2 * sizeof(double));
    memcpy(tensors + 3 * k, at + 5 * k + 2, 3 * sizeof(double));
  }
  make_square(&square);
  asterism_metric_init(&metric);
  metric.vertex_count = sites;
  metric.vertices = places;
  metric.tensors = tensors;
  metric.triangle_count = triangles;
  metric.triangles = corners_of;
  expect(
      asterism_mesh_create(&square, &metric, NULL, &next, message, sizeof message) == ASTERISM_OK,
      message);
  asterism_mesh_free(next);
  free(places);
  free(tensors);
}

/* Messages count from 0, as the arrays do. */
static void test_numbers_in_messages(void) {
  double sites[4][5] = {{0, 0, 1, 0, 1}, {1, 0, 1, 0, 1}, {1, 1, 1, 0, 1}, {0, 1, 1, 0, 1}};
  unsigned triangles[] = {0, 1, 2, 0, 3, 2};
  char message[200];
  int certified = 9;
  expect(asterism_certify(4, sites[0], 2, triangles, 20, &certified, message, sizeof message) ==
                 ASTERISM_OK &&
             certified == 0 && strstr(message, "triangle 1 of vertex 0 (0, 0), vertex 3 ") != NULL,
         message);
  triangles[4] = 4;
  expect(asterism_certify(4, sites[0], 2, triangles, 20, &certified, message, sizeof message) ==
                 ASTERISM_REFUSED &&
             strstr(message, "triangle 1 names vertex 4 of 4") != NULL,
         message);
  triangles[4] = 3;
  sites[2][0] = sites[1][0];
  sites[2][1] = sites[1][1];
  expect(asterism_certify(4, sites[0], 2, triangles, 20, &certified, message, sizeof message) ==
                 ASTERISM_REFUSED &&
             strstr(message, "vertex 1 and vertex 2 are at the same point") != NULL &&
             strstr(message, "triangle 0") != NULL,
         message);
}

/* The same mesh, whether points are asked for alone or together; together in few calls. */
static void test_batch_function(const asterism_mesh* mesh, const asterism_metric* metric,
                                const asterism_mesh_options* options, int calls_alone) {
  asterism_domain square;
  asterism_metric together = *metric;
  asterism_mesh* same = NULL;
  size_t sites, count;
  int calls = 0;
  make_square(&square);
  together.function = NULL;
  together.batch_function = stretched_many;
  together.context = &calls;
  expect(asterism_mesh_create(&square, &together, options, &same, NULL, 0) == ASTERISM_OK,
         "a batch function");
  (void)asterism_mesh_sites(mesh, &sites);
  expect(memcmp(asterism_mesh_sites(same, &count), asterism_mesh_sites(mesh, &sites),
                5 * sites * sizeof(double)) == 0 &&
             count == sites,
         "the same mesh");
  expect(calls < calls_alone / 2, "in few calls");
  asterism_mesh_free(same);
}

static int at_once(void* context) {
  (void)context;
  return 1;
}

static void test_meshes(void) {
  asterism_domain square;
  asterism_metric metric;
  asterism_mesh_options options;
  asterism_mesh *mesh = NULL, *stopped = NULL;
  char message[200];
  int calls = 0;
  make_square(&square);
  asterism_metric_init(&metric);
  asterism_mesh_options_init(&options);
  metric.function = stretched;
  metric.context = &calls;
  options.limit_size = 1;
  expect(asterism_mesh_create(&square, &metric, &options, &mesh, message, sizeof message) ==
             ASTERISM_OK,
         message);
  expect(calls > 10, "the function was asked");
  expect_mesh(mesh);
  test_verify(mesh);
  test_arrays(mesh);
  test_batch_function(mesh, &metric, &options, calls);
  asterism_mesh_free(mesh);

  options.stop = at_once;
  expect(asterism_mesh_create(&square, &metric, &options, &stopped, message, sizeof message) ==
                 ASTERISM_OK &&
             !asterism_mesh_is_certified(stopped) &&
             strstr(asterism_mesh_reason(stopped), "the caller stopped it") != NULL,
         "stopped");
  asterism_mesh_free(stopped);
  asterism_mesh_free(NULL);
}

/* A metric that jumps, which no stars agree in: beside the jump another one is delivered. */
static void test_metric_tolerance(void) {
  asterism_domain square;
  asterism_metric metric;
  asterism_mesh_options options;
  asterism_mesh *any = NULL, *near_it = NULL;
  char message[200];
  make_square(&square);
  asterism_metric_init(&metric);
  asterism_mesh_options_init(&options);
  expect(options.metric_tolerance < 0, "any distance, by default");
  metric.specification = "expr:(x>0.5)?400:4;0;4";
  options.limit_size = 1;
  expect(asterism_mesh_create(&square, &metric, &options, &any, message, sizeof message) ==
                 ASTERISM_OK &&
             asterism_mesh_is_certified(any) &&
             strstr(asterism_mesh_certificate(any), "\"greatest\"") != NULL,
         "another metric is delivered, and said");
  options.metric_tolerance = 0.01;
  expect(asterism_mesh_create(&square, &metric, &options, &near_it, message, sizeof message) ==
                 ASTERISM_OK &&
             !asterism_mesh_is_complete(near_it) && !asterism_mesh_is_certified(near_it),
         "not within the tolerance");
  asterism_mesh_free(any);
  asterism_mesh_free(near_it);
}

/* Makes a disc with so many vertices wanted and returns how many it has. */
static size_t disc_vertices(size_t wanted, double chord_tolerance, size_t* edges) {
  const double ends[] = {1, 0, -1, 0};
  const unsigned halves[] = {0, 1, 1, 0}, curved[] = {0, 1};
  const int kinds[] = {ASTERISM_ARC, ASTERISM_ARC};
  const double centres[] = {0, 0, 0, 0, 0, 0, 0, 0};
  asterism_domain disc;
  asterism_metric metric;
  asterism_mesh_options options;
  asterism_mesh* mesh = NULL;
  char message[200];
  size_t sites;
  asterism_domain_init(&disc);
  asterism_metric_init(&metric);
  asterism_mesh_options_init(&options);
  disc.vertex_count = 2;
  disc.vertices = ends;
  disc.segment_count = 2;
  disc.segments = halves;
  disc.curve_count = 2;
  disc.curve_segments = curved;
  disc.curve_kinds = kinds;
  disc.curve_points = centres;
  metric.specification = "identity";
  options.vertices = wanted;
  options.chord_tolerance = chord_tolerance;
  expect(asterism_mesh_create(&disc, &metric, &options, &mesh, message, sizeof message) ==
                 ASTERISM_OK &&
             asterism_mesh_is_certified(mesh),
         message);
  (void)asterism_mesh_sites(mesh, &sites);
  (void)asterism_mesh_boundary(mesh, edges);
  asterism_mesh_free(mesh);
  return sites;
}

/* The number of vertices is met, and chords of curves are as long as it wants them. */
static void test_vertex_counts(void) {
  const size_t few = 150, many = 1200;
  size_t coarse, fine, fine_by_tolerance, sites;
  sites = disc_vertices(few, 0, &coarse);
  expect(20 * sites >= 19 * few && 20 * sites <= 21 * few, "few vertices are met");
  sites = disc_vertices(many, 0, &fine);
  expect(20 * sites >= 19 * many && 20 * sites <= 21 * many, "many vertices are met");
  expect(2 * fine > 3 * coarse, "chords follow the number");
  (void)disc_vertices(few, 1e-3, &fine_by_tolerance);
  expect(fine_by_tolerance > coarse, "chords follow a tolerance");
}

static void expect_refused(const asterism_domain* domain, const asterism_metric* metric,
                           const asterism_mesh_options* options, const char* word) {
  char message[200], cut[5];
  asterism_mesh* mesh = NULL;
  expect(asterism_mesh_create(domain, metric, options, &mesh, message, sizeof message) ==
             ASTERISM_REFUSED,
         word);
  expect(strstr(message, word) != NULL, message);
  expect(asterism_mesh_create(domain, metric, options, &mesh, cut, sizeof cut) == ASTERISM_REFUSED,
         word);
  expect(strlen(cut) == 4, "cut where it does not fit");
  expect(asterism_mesh_create(domain, metric, options, &mesh, NULL, 0) == ASTERISM_REFUSED, word);
  expect(mesh == NULL, "nothing is made");
}

static void test_refused_meshes(void) {
  const unsigned open[] = {0, 1, 1, 2, 2, 3, 3, 9}, no_segment = 7;
  const int arc = ASTERISM_ARC;
  asterism_domain square, wrong;
  asterism_metric metric, other;
  asterism_mesh_options options;
  asterism_mesh* mesh = NULL;
  make_square(&square);
  asterism_metric_init(&metric);
  asterism_mesh_options_init(&options);
  expect_refused(&square, &metric, &options, "metric must be one of");
  options.metric_tolerance = HUGE_VAL;
  expect_refused(&square, &metric, &options, "metric_tolerance");
  options.metric_tolerance = -1;
  metric.specification = "swirl:12";
  other = metric;
  other.function = failing;
  expect_refused(&square, &other, &options, "metric must be one of");
  other.specification = NULL;
  expect_refused(&square, &other, NULL, "function failed at");
  other = metric;
  other.specification = "whirl";
  expect_refused(&square, &other, NULL, "whirl");
  other = metric;
  other.size = -1;
  expect_refused(&square, &other, NULL, "size");
  wrong = square;
  wrong.segments = open;
  expect_refused(&wrong, &metric, NULL, "9");
  wrong.segments = NULL;
  expect_refused(&wrong, &metric, NULL, "null");
  wrong = square;
  wrong.curve_count = 1;
  expect_refused(&wrong, &metric, NULL, "null");
  wrong.curve_segments = &no_segment;
  wrong.curve_points = corners;
  expect_refused(&wrong, &metric, NULL, "curve 0 is of segment 7 of 4");
  wrong.curve_segments = sides;
  wrong.curve_kinds = markers;
  expect_refused(&wrong, &metric, NULL, "curve 0 is of kind 11");
  wrong.curve_kinds = &arc;
  expect_refused(&wrong, &metric, NULL, "curve 0");
  options.vertices = 2;
  expect_refused(&square, &metric, &options, "vertices must be");
  options.vertices = 3;
  expect_refused(&square, &metric, &options, "has 4 already");
  options.vertices = 0;
  options.chord_tolerance = -1;
  expect_refused(&square, &metric, &options, "chord_tolerance");
  options.chord_tolerance = 0;
  options.angle_bound = 60;
  expect_refused(&square, &metric, &options, "angle bound");
  expect(asterism_mesh_create(NULL, &metric, NULL, &mesh, NULL, 0) == ASTERISM_NULL_POINTER,
         "null domain");
}

int main(void) {
  test_stars();
  test_refused_sites();
  test_meshes();
  test_metric_tolerance();
  test_vertex_counts();
  test_refused_meshes();
  test_numbers_in_messages();
  if (failures == 0) puts("stars and meshes come and are refused as documented");
  return failures == 0 ? 0 : 1;
}
