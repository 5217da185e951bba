/* SPDX-License-Identifier: MIT
 *
 * A program that opens the library by itself, has a mesh made by several threads, and closes it:
 * the threads that wait for the next loop do not end the program. Then the same in a child, to
 * which a fork gives no threads. The one argument is the library's path. */
#define _POSIX_C_SOURCE 200809L
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "asterism/mesh/c_interface/mesh.h"

/* ISO C has no cast from an object's address to a function's, dlsym's page copies it. */
static void find(void* library, const char* name, void* function) {
  void* address = dlsym(library, name);
  memcpy(function, &address, sizeof address);
}

/* Returns 1 if the library at the path makes a certified mesh of the unit square, else 0. */
static int makes_mesh(const char* path) {
  static const double corners[8] = {0, 0, 1, 0, 1, 1, 0, 1};
  static const unsigned sides[8] = {0, 1, 1, 2, 2, 3, 3, 0};
  asterism_status (*create)(const asterism_domain*, const asterism_metric*,
                            const asterism_mesh_options*, asterism_mesh**, char*, size_t);
  void (*init_domain)(asterism_domain*);
  void (*init_metric)(asterism_metric*);
  void (*init_options)(asterism_mesh_options*);
  void (*free_mesh)(asterism_mesh*);
  int (*is_certified)(const asterism_mesh*);
  asterism_domain square;
  asterism_metric metric;
  asterism_mesh_options options;
  asterism_mesh* made = NULL;
  char message[400] = "";
  int certified = 0;
  void* library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (library == NULL) return fprintf(stderr, "%s\n", dlerror()), 0;
  find(library, "asterism_mesh_create", &create);
  find(library, "asterism_domain_init", &init_domain);
  find(library, "asterism_metric_init", &init_metric);
  find(library, "asterism_mesh_options_init", &init_options);
  find(library, "asterism_mesh_free", &free_mesh);
  find(library, "asterism_mesh_is_certified", &is_certified);
  init_domain(&square);
  init_metric(&metric);
  init_options(&options);
  square.vertex_count = square.segment_count = 4;
  square.vertices = corners;
  square.segments = sides;
  metric.specification = "swirl:3";
  options.vertices = 2000;
  if (create(&square, &metric, &options, &made, message, sizeof message) == ASTERISM_OK)
    certified = is_certified(made);
  if (!certified) fprintf(stderr, "no certified mesh: %s\n", message);
  free_mesh(made);
  if (dlclose(library) != 0) return fprintf(stderr, "%s\n", dlerror()), 0;
  return certified;
}

int main(int count, char** words) {
  const struct timespec longer_than_polls = {0, 100000000};
  int times, status = 1;
  pid_t child;
  if (count != 2) return fputs("closed_library_test LIBRARY\n", stderr), 2;
  alarm(120); /* seconds: ends a loop that waits for threads that are not there */
  for (times = 0; times < 2; ++times) {
    if (!makes_mesh(words[1])) return 1;
    nanosleep(&longer_than_polls, NULL);
  }
  child = fork();
  if (child == 0) {
    alarm(60);
    _exit(makes_mesh(words[1]) ? 0 : 1);
  }
  if (child < 0 || waitpid(child, &status, 0) != child || status != 0)
    return fputs("the child of a fork made no mesh\n", stderr), 1;
  puts("mesh made twice and by a child");
  return 0;
}
