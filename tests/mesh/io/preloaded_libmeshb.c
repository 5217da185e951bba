/* SPDX-License-Identifier: MIT
 *
 * Reads and writes binary Medit files by libMeshb, the format's own library, as FreeFEM's ffmedit
 * contains and exports it (Debian has no package of its own). Preloaded into that program, runs
 * before its main, copies LIBMESHB_FROM (a name without its ending) to LIBMESHB_TO in version
 * LIBMESHB_VERSION, both .meshb and .solb, prints all numbers as hexadecimal, and ends the program.
 * The symbols are those of the program preloaded into. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Values of libMeshb's header. */
enum { gmf_read = 1, gmf_write = 2, gmf_symmetric = 3 };
enum {
  gmf_vertices = 4,
  gmf_edges = 5,
  gmf_triangles = 6,
  gmf_required_vertices = 15,
  gmf_sol_at_vertices = 62
};

typedef int64_t (*open_function)(const char*, int, ...);
typedef int (*close_function)(int64_t);
typedef int64_t (*count_function)(int64_t, int, ...);
typedef int (*line_function)(int64_t, int, ...);

static void* found(const char* name) {
  void* const symbol = dlsym(RTLD_DEFAULT, name);
  if (symbol == NULL) {
    fprintf(stderr, "no %s here\n", name);
    exit(77);
  }
  return symbol;
}

struct library {
  open_function open;
  close_function close;
  count_function count, set_section;
  line_function go_to, get, set;
};

static struct library library_here(void) {
  struct library made;
  *(void**)&made.open = found("GmfOpenMesh");
  *(void**)&made.close = found("GmfCloseMesh");
  *(void**)&made.count = found("GmfStatKwd");
  *(void**)&made.set_section = found("GmfSetKwd");
  *(void**)&made.go_to = found("GmfGotoKwd");
  *(void**)&made.get = found("GmfGetLin");
  *(void**)&made.set = found("GmfSetLin");
  return made;
}

static void expect(int holds, const char* what) {
  if (holds) return;
  fprintf(stderr, "libMeshb: %s\n", what);
  exit(1);
}

/* Whole numbers are passed as 64 bits to files of version 4, tensors as floats to those of 1. */
static void copy_vertices(const struct library* l, int64_t in, int64_t out, int version) {
  const int64_t count = l->count(in, gmf_vertices);
  int64_t k;
  expect(count > 0, "no vertices");
  expect(l->go_to(in, gmf_vertices), "the section Vertices is not found");
  expect(l->set_section(out, gmf_vertices, count) != 0, "Vertices cannot be written");
  for (k = 0; k < count; ++k) {
    double x = 0, y = 0;
    int reference = 0;
    expect(l->get(in, gmf_vertices, &x, &y, &reference), "a vertex cannot be read");
    printf("vertex %a %a %d\n", x, y, reference);
    if (version >= 4)
      l->set(out, gmf_vertices, x, y, (int64_t)reference);
    else
      l->set(out, gmf_vertices, x, y, reference);
  }
}

static int columns_of(int section) {
  return section == gmf_triangles ? 4 : section == gmf_edges ? 3 : 1;
}

/* Copies lines of whole numbers. Those of no use to the section are passed, and not looked at. */
static void copy_numbered(const struct library* l, int64_t in, int64_t out, int section,
                          const char* name, int version) {
  const int64_t count = l->count(in, section);
  int64_t k;
  if (count == 0) return;
  expect(l->go_to(in, section), name);
  expect(l->set_section(out, section, count) != 0, name);
  for (k = 0; k < count; ++k) {
    int n[4] = {0, 0, 0, 0}, column;
    expect(l->get(in, section, &n[0], &n[1], &n[2], &n[3]), name);
    printf("%s", name);
    for (column = 0; column < columns_of(section); ++column) printf(" %d", n[column]);
    printf("\n");
    if (version >= 4)
      l->set(out, section, (int64_t)n[0], (int64_t)n[1], (int64_t)n[2], (int64_t)n[3]);
    else
      l->set(out, section, n[0], n[1], n[2], n[3]);
  }
}

static void copy_tensors(const struct library* l, int64_t in, int64_t out, int version) {
  int kinds = 0, numbers = 0, kind[1000];
  const int64_t count = l->count(in, gmf_sol_at_vertices, &kinds, &numbers, kind);
  int64_t k;
  expect(count > 0 && kinds == 1 && numbers == 3 && kind[0] == gmf_symmetric, "not one tensor");
  expect(l->go_to(in, gmf_sol_at_vertices), "the section SolAtVertices is not found");
  expect(l->set_section(out, gmf_sol_at_vertices, count, 1, kind) != 0, "cannot be written");
  for (k = 0; k < count; ++k) {
    double m[3] = {0, 0, 0};
    expect(l->get(in, gmf_sol_at_vertices, m), "a tensor cannot be read");
    printf("tensor %a %a %a\n", m[0], m[1], m[2]);
    if (version == 1) {
      const float rounded[3] = {(float)m[0], (float)m[1], (float)m[2]};
      l->set(out, gmf_sol_at_vertices, rounded);
    } else {
      l->set(out, gmf_sol_at_vertices, m);
    }
  }
}

static int64_t opened(const struct library* l, const char* stem, const char* ending, int* version) {
  char name[1024];
  int dimension = 0;
  int64_t file;
  snprintf(name, sizeof name, "%s%s", stem, ending);
  file = l->open(name, gmf_read, version, &dimension);
  expect(file != 0 && dimension == 2, "a file cannot be opened");
  return file;
}

static int64_t created(const struct library* l, const char* stem, const char* ending, int version) {
  char name[1024];
  int64_t file;
  snprintf(name, sizeof name, "%s%s", stem, ending);
  file = l->open(name, gmf_write, version, 2);
  expect(file != 0, "a file cannot be written");
  return file;
}

__attribute__((constructor)) static void copy_and_end(void) {
  const char *const from = getenv("LIBMESHB_FROM"), *const to = getenv("LIBMESHB_TO");
  const char* const wanted = getenv("LIBMESHB_VERSION");
  int read_version = 0, version;
  int64_t in, out;
  struct library l;
  if (from == NULL || to == NULL || wanted == NULL) return;
  l = library_here();
  version = atoi(wanted);

  in = opened(&l, from, ".meshb", &read_version);
  expect(read_version == 2 || read_version == 3, "another version than what is read below");
  out = created(&l, to, ".meshb", version);
  copy_vertices(&l, in, out, version);
  copy_numbered(&l, in, out, gmf_edges, "edge", version);
  copy_numbered(&l, in, out, gmf_triangles, "triangle", version);
  copy_numbered(&l, in, out, gmf_required_vertices, "required", version);
  l.close(in);
  l.close(out);

  in = opened(&l, from, ".solb", &read_version);
  out = created(&l, to, ".solb", version);
  copy_tensors(&l, in, out, version);
  l.close(in);
  l.close(out);
  fflush(stdout);
  _Exit(0);
}
