// SPDX-License-Identifier: MIT
//
// ASTERISM_CALLER is the name of this caller's function.
#include "abuse_caller.hpp"

#include "asterism/kernels/batch_question.hpp"
#include "asterism/kernels/c_api.h"
#include "asterism/kernels/filtered_kernel.hpp"
#include "caller_environment.hpp"

namespace asterism::abuse {

namespace {

// Of this translation unit alone, and so all that is instantiated with it: the linker would keep
// one caller's copy for all.
class own_kernel : public filtered_kernel {};

asterism_status ask_c(const batch_record& r, int* answer) {
  const double* const n = r.numbers.data();
  switch (r.question) {
    case predicate::orientation:
      return asterism_orientation(n, n + 2, n + 4, answer);
    case predicate::is_spd:
      return asterism_is_spd(n, answer);
    case predicate::compare_distance:
      return asterism_compare_distance(n, n + 5, n + 10, answer);
    case predicate::in_wedge:
      return asterism_in_wedge(n, n + 5, n + 10, answer);
    case predicate::dominates:
      return asterism_dominates(n, n + 5, n + 10, answer);
    case predicate::voronoi_vertex_count:
      return asterism_voronoi_vertex_count(n, n + 5, n + 10, answer);
    case predicate::arc_intersection_count:
      return asterism_arc_intersection_count(n, n + 5, n + 10, answer);
    case predicate::encroaches:
      return asterism_encroaches(n, n + 5, n + 10, answer);
    case predicate::insertion_test:
      return asterism_insertion_test(n, n + 5, n + 10, n + 15, answer);
    case predicate::edge_test:
      return asterism_edge_test(n, n + 5, n + 10, n + 15, answer);
  }
  return ASTERISM_INTERNAL_FAILURE;
}

}  // namespace

caller_answer ASTERISM_CALLER(const batch_record& record);

caller_answer ASTERISM_CALLER(const batch_record& record) {
  caller_answer result;
  const caller_environment before = current_environment();
  const own_kernel kernel;
  result.by_class = ask(kernel, record).value();
  result.kept_by_class = current_environment() == before;
  result.status = ask_c(record, &result.by_c_api);
  result.kept_by_c_api = current_environment() == before;
  return result;
}

}  // namespace asterism::abuse
