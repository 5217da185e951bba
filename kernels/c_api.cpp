// SPDX-License-Identifier: MIT
#include "asterism/kernels/c_api.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "asterism/kernels/batch_question.hpp"
#include "asterism/kernels/filtered_kernel.hpp"

namespace {

using asterism::batch_record;
using asterism::predicate;

// By the bits, because the caller may have switched subnormal numbers off, to which == then is
// blind.
bool is_finite(double x) {
  constexpr std::uint64_t exponent = 0x7FF0000000000000U;
  return (std::bit_cast<std::uint64_t>(x) & exponent) != exponent;
}
bool is_same(double x, double y) {
  const auto a = std::bit_cast<std::uint64_t>(x), b = std::bit_cast<std::uint64_t>(y);
  return a == b || ((a | b) << 1U) == 0;
}

asterism_status check_sites(const asterism::filtered_kernel& kernel, const batch_record& record) {
  const std::size_t sites = asterism::shape_of(record.question).sites;
  for (std::size_t i = 0; i < sites; ++i)
    if (!kernel.is_positive_definite(site_at(record, i).metric))
      return ASTERISM_NOT_POSITIVE_DEFINITE;
  for (std::size_t i = 0; i < sites; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (is_same(record.numbers[5 * i], record.numbers[5 * j]) &&
          is_same(record.numbers[5 * i + 1], record.numbers[5 * j + 1]))
        return ASTERISM_EQUAL_SITES;
  return ASTERISM_OK;
}

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
  for (const double number : record.numbers)
    if (!is_finite(number)) return ASTERISM_NOT_FINITE;
  // Whatever is thrown below must not reach a caller that may not be C++.
  try {
    const asterism::filtered_kernel kernel;
    if (const asterism_status status = check_sites(kernel, record); status != ASTERISM_OK)
      return status;
    *answer = ask(kernel, record).value();
    return ASTERISM_OK;
  } catch (...) {
    return ASTERISM_INTERNAL_FAILURE;
  }
}

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
  }
  return "not a status of this library";
}

asterism_status asterism_orientation(const double p[2], const double q[2], const double r[2],
                                     int* answer) {
  return answer_question(predicate::orientation, std::array{as_point(p), as_point(q), as_point(r)},
                         answer);
}

asterism_status asterism_is_spd(const double metric[3], int* answer) {
  return answer_question(predicate::is_positive_definite, std::array{argument{metric, 3}}, answer);
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
