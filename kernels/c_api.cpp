// SPDX-License-Identifier: MIT
#include "asterism/kernels/c_api.h"

#include <array>
#include <cstddef>
#include <span>

#include "asterism/kernels/batch_question.hpp"
#include "asterism/kernels/c_question.hpp"
#include "asterism/kernels/filtered_kernel.hpp"

namespace {

using namespace asterism;
using namespace asterism::internal;

struct argument {
  const double* first;
  std::size_t count;
};

asterism_status answer_question(predicate question, std::span<const argument> arguments,
                                int* answer) noexcept {
  if (answer == nullptr) return ASTERISM_NULL_POINTER;
  batch_record record{question, {}};
  std::size_t count = 0;
  for (const argument& a : arguments) {
    if (a.first == nullptr) return ASTERISM_NULL_POINTER;
    for (std::size_t k = 0; k < a.count; ++k) record.numbers[count++] = a.first[k];
  }
  return without_exceptions([&] {
    const filtered_kernel kernel;
    if (const asterism_status bad = check_record(kernel, record); bad != ASTERISM_OK) return bad;
    *answer = ask(kernel, record).value();
    return ASTERISM_OK;
  });
}

argument as_metric(const double* m) { return {m, 3}; }
argument as_point(const double* p) { return {p, 2}; }
argument as_site(const double* s) { return {s, 5}; }

}  // namespace

const char* asterism_status_message(asterism_status status) {
  switch (status) {
    case ASTERISM_OK:
      return "answered";
    case ASTERISM_NULL_POINTER:
      return "an argument is a null pointer";
    case ASTERISM_NOT_FINITE:
      return "a number is infinite or not a number";
    case ASTERISM_NOT_POSITIVE_DEFINITE:
      return "the metric of a site is not positive definite";
    case ASTERISM_EQUAL_SITES:
      return "two sites are at the same position";
    case ASTERISM_INTERNAL_FAILURE:
      return "the library could not finish";
    case ASTERISM_OUT_OF_MEMORY:
      return "there is not enough memory";
    case ASTERISM_OUT_OF_RANGE:
      return "an index, count or option is out of range";
    case ASTERISM_REFUSED:
      return "the input was refused, for the reason in the message";
  }
  return "not a status of this library";
}

int asterism_version(void) { return ASTERISM_VERSION; }
const char* asterism_version_text(void) { return ASTERISM_VERSION_TEXT; }

asterism_status asterism_orientation(const double p[2], const double q[2], const double r[2],
                                     int* answer) {
  return answer_question(predicate::orientation, std::array{as_point(p), as_point(q), as_point(r)},
                         answer);
}

asterism_status asterism_is_spd(const double metric[3], int* answer) {
  return answer_question(predicate::is_positive_definite, std::array{as_metric(metric)}, answer);
}

asterism_status asterism_in_circle(const double metric[3], const double a[2], const double b[2],
                                   const double c[2], const double p[2], int* answer) {
  return answer_question(
      predicate::in_circle,
      std::array{as_metric(metric), as_point(a), as_point(b), as_point(c), as_point(p)}, answer);
}

asterism_status asterism_in_circle_plane(const double a[2], const double b[2], const double c[2],
                                         const double p[2], int* answer) {
  const std::array<double, 3> plane = {1, 0, 1};
  return asterism_in_circle(plane.data(), a, b, c, p, answer);
}

asterism_status asterism_compare_distance(const double v[5], const double w[5], const double q[2],
                                          int* answer) {
  return answer_question(predicate::compare_distance,
                         std::array{as_site(v), as_site(w), as_point(q)}, answer);
}

asterism_status asterism_in_wedge(const double v[5], const double w[5], const double q[2],
                                  int* answer) {
  return answer_question(predicate::in_wedge, std::array{as_site(v), as_site(w), as_point(q)},
                         answer);
}

asterism_status asterism_dominates(const double v[5], const double w[5], const double p[2],
                                   int* answer) {
  return answer_question(predicate::dominates, std::array{as_site(v), as_site(w), as_point(p)},
                         answer);
}

asterism_status asterism_voronoi_vertex_count(const double u[5], const double v[5],
                                              const double w[5], int* answer) {
  return answer_question(predicate::voronoi_vertex_count,
                         std::array{as_site(u), as_site(v), as_site(w)}, answer);
}

asterism_status asterism_arc_intersection_count(const double v[5], const double w[5],
                                                const double x[5], int* answer) {
  return answer_question(predicate::arc_intersection_count,
                         std::array{as_site(v), as_site(w), as_site(x)}, answer);
}

asterism_status asterism_encroaches(const double a[5], const double b[5], const double w[5],
                                    int* answer) {
  return answer_question(predicate::encroaches, std::array{as_site(a), as_site(b), as_site(w)},
                         answer);
}

asterism_status asterism_insertion_test(const double v[5], const double w[5], const double x[5],
                                        const double y[5], int* answer) {
  return answer_question(predicate::insertion_test,
                         std::array{as_site(v), as_site(w), as_site(x), as_site(y)}, answer);
}

asterism_status asterism_edge_test(const double v[5], const double w[5], const double x[5],
                                   const double y[5], int* answer) {
  return answer_question(predicate::edge_test,
                         std::array{as_site(v), as_site(w), as_site(x), as_site(y)}, answer);
}
