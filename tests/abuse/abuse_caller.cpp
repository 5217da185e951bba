// SPDX-License-Identifier: MIT
//
// ASTERISM_CALLER is the name of this caller's function.
#include "abuse_caller.hpp"

#include "asterism/kernels/batch_question.hpp"
#include "asterism/kernels/c_api.h"
#include "asterism/kernels/filtered_kernel.hpp"
#include "caller_environment.hpp"

#ifndef __FAST_MATH__
#include "asterism/kernels/semi_static_filter.hpp"
#include "asterism/kernels/star_gap.hpp"
#endif

namespace asterism::abuse {
#ifndef __FAST_MATH__
using namespace internal;
#endif

namespace {

// Everything here is local to this translation unit, templates included: otherwise the linker would
// keep one caller's copy for all.
class own_kernel : public filtered_kernel {};

#ifndef __FAST_MATH__
// Headers with plain doubles in them, compiled as the caller is.
uncertain_int ask_first_tier(const batch_record& r) {
  const auto s = [&r](std::size_t which) { return site_at(r, which); };
  const point at = point_at(r, 10);
  switch (r.question) {
    case predicate::orientation:
      return as_integer(semi_static::orientation(point_at(r, 0), point_at(r, 2), point_at(r, 4)));
    case predicate::is_positive_definite:
      return as_integer(semi_static::is_positive_definite(metric_at(r, 0)));
    case predicate::in_circle:
      return as_integer(semi_static::in_circle(metric_at(r, 0), point_at(r, 3), point_at(r, 5),
                                               point_at(r, 7), point_at(r, 9)));
    case predicate::compare_distance:
      return as_integer(semi_static::compare_distance(s(0), s(1), at));
    case predicate::in_wedge:
      return as_integer(semi_static::in_wedge(s(0), s(1), at));
    case predicate::dominates:
      return as_integer(semi_static::dominates(s(0), s(1), at));
    case predicate::edge_test:
      return as_integer(star_gap(s(0), s(3), s(2)).accepts(s(1)));
    default:
      return {};
  }
}
#else
uncertain_int ask_first_tier(const batch_record&) { return {}; }
#endif

asterism_status ask_c(const batch_record& r, int* answer) {
  const double* const n = r.numbers.data();
  switch (r.question) {
    case predicate::orientation:
      return asterism_orientation(n, n + 2, n + 4, answer);
    case predicate::is_positive_definite:
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
    case predicate::in_circle:
      return asterism_in_circle(n, n + 3, n + 5, n + 7, n + 9, answer);
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
  result.by_first_tier = ask_first_tier(record);
  result.kept_by_first_tier = current_environment() == before;
  return result;
}

}  // namespace asterism::abuse
