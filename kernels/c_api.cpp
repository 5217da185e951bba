// SPDX-License-Identifier: MIT
#include "asterism/kernels/c_api.h"

#include <array>
#include <cstddef>
#include <tuple>

#include "asterism/kernels/batch_question.hpp"
#include "asterism/kernels/c_question.hpp"
#include "asterism/kernels/filtered_kernel.hpp"

namespace {

using namespace asterism;
using namespace asterism::internal;

// An argument of a question: its kind, where its numbers are, how many there are, and its value.
struct as_metric {
  static constexpr std::size_t width = 3;
  const double* numbers;
  metric_tensor value() const { return {numbers[0], numbers[1], numbers[2]}; }
};
struct as_point {
  static constexpr std::size_t width = 2;
  const double* numbers;
  point value() const { return {numbers[0], numbers[1]}; }
};
struct as_site {
  static constexpr std::size_t width = 5;
  const double* numbers;
  site value() const { return {{numbers[0], numbers[1]}, {numbers[2], numbers[3], numbers[4]}}; }
};

template <class Argument>
bool is_all_finite(const Argument& a) {
  bool finite = true;
  for (std::size_t k = 0; k < Argument::width; ++k) finite &= is_finite(a.numbers[k]);
  return finite;
}

// Tests the metrics of a question's sites, and the metric of a circle: they must be positive
// definite. Does not test the metrics of other questions, which may ask whether a metric is
// positive definite.
template <predicate Question, class Argument>
bool is_surely_sound(const Argument& a) {
  if (!is_all_finite(a)) return false;
  if constexpr (Argument::width == 5)
    return is_surely_positive_definite(a.numbers + 2);
  else if constexpr (Argument::width == 3 && Question == predicate::in_circle)
    return is_surely_positive_definite(a.numbers);
  else
    return true;
}

// True for two sites if their positions are certainly different; true for other arguments.
template <class First, class Second>
bool is_surely_apart(const First& a, const Second& b) {
  if constexpr (First::width == 5 && Second::width == 5)
    return are_surely_apart(a.numbers, b.numbers);
  else
    return true;
}

template <class Last>
bool are_sites_surely_apart(const Last&) {
  return true;
}
template <class First, class... Rest>
bool are_sites_surely_apart(const First& first, const Rest&... rest) {
  return (is_surely_apart(first, rest) && ...) && are_sites_surely_apart(rest...);
}

// Calls the kernel's function that has the question's name.
template <predicate Question, class... Values>
auto ask_of_values(const filtered_kernel& kernel, const Values&... values) {
  if constexpr (Question == predicate::orientation) return kernel.orientation(values...);
  if constexpr (Question == predicate::is_positive_definite)
    return kernel.is_positive_definite(values...);
  if constexpr (Question == predicate::compare_distance) return kernel.compare_distance(values...);
  if constexpr (Question == predicate::in_wedge) return kernel.in_wedge(values...);
  if constexpr (Question == predicate::dominates) return kernel.dominates(values...);
  if constexpr (Question == predicate::voronoi_vertex_count)
    return kernel.voronoi_vertex_count(values...);
  if constexpr (Question == predicate::arc_intersection_count)
    return kernel.arc_intersection_count(values...);
  if constexpr (Question == predicate::encroaches) return kernel.encroaches(values...);
  if constexpr (Question == predicate::insertion_test) return kernel.insertion_test(values...);
  if constexpr (Question == predicate::edge_test) return kernel.edge_test(values...);
  if constexpr (Question == predicate::in_circle) return kernel.in_circle(values...);
}

// Returns the fault of the arguments, by exact arithmetic where necessary.
template <class... Arguments>
[[gnu::noinline]] asterism_status check_slowly(predicate question, const Arguments&... arguments) {
  batch_record record{question, {}};
  std::size_t count = 0;
  const auto append = [&](const auto& a) {
    for (std::size_t k = 0; k < a.width; ++k) record.numbers[count++] = a.numbers[k];
  };
  (append(arguments), ...);
  return check_record(filtered_kernel(), record);
}

// Checks and answers. The checks in doubles pass nearly everything that check_record passes.
template <predicate Question, class... Arguments>
asterism_status answer_question(int* answer, tier_counters* counters,
                                const Arguments&... arguments) noexcept {
  if (answer == nullptr || ((arguments.numbers == nullptr) || ...)) return ASTERISM_NULL_POINTER;
  return without_exceptions([&] {
    if (!((is_surely_sound<Question>(arguments) && ...) && are_sites_surely_apart(arguments...)))
      if (const asterism_status bad = check_slowly(Question, arguments...); bad != ASTERISM_OK)
        return bad;
    const filtered_kernel kernel =
        counters == nullptr ? filtered_kernel() : filtered_kernel(*counters);
    *answer = as_integer(ask_of_values<Question>(kernel, arguments.value()...)).value();
    return ASTERISM_OK;
  });
}

// Answers a question whose arguments are given as one pointer each, in their order.
template <predicate Question, class... Arguments>
asterism_status answer_pointers(const double* const* from, int* answer, tier_counters* counters) {
  std::size_t next = 0;
  const std::tuple<Arguments...> arguments{Arguments{from[next++]}...};
  return std::apply(
      [&](const Arguments&... each) {
        return answer_question<Question>(answer, counters, each...);
      },
      arguments);
}

static_assert(static_cast<std::size_t>(predicate::in_circle) == ASTERISM_IN_CIRCLE &&
              predicate_count == ASTERISM_IN_CIRCLE + 1);

asterism_status answer_named(asterism_predicate question, const double* const* arguments,
                             int* answer, tier_counters* counters) {
  switch (question) {
    case ASTERISM_ORIENTATION:
      return answer_pointers<predicate::orientation, as_point, as_point, as_point>(
          arguments, answer, counters);
    case ASTERISM_IS_SPD:
      return answer_pointers<predicate::is_positive_definite, as_metric>(arguments, answer,
                                                                         counters);
    case ASTERISM_COMPARE_DISTANCE:
      return answer_pointers<predicate::compare_distance, as_site, as_site, as_point>(
          arguments, answer, counters);
    case ASTERISM_IN_WEDGE:
      return answer_pointers<predicate::in_wedge, as_site, as_site, as_point>(arguments, answer,
                                                                              counters);
    case ASTERISM_DOMINATES:
      return answer_pointers<predicate::dominates, as_site, as_site, as_point>(arguments, answer,
                                                                               counters);
    case ASTERISM_VORONOI_VERTEX_COUNT:
      return answer_pointers<predicate::voronoi_vertex_count, as_site, as_site, as_site>(
          arguments, answer, counters);
    case ASTERISM_ARC_INTERSECTION_COUNT:
      return answer_pointers<predicate::arc_intersection_count, as_site, as_site, as_site>(
          arguments, answer, counters);
    case ASTERISM_ENCROACHES:
      return answer_pointers<predicate::encroaches, as_site, as_site, as_site>(arguments, answer,
                                                                               counters);
    case ASTERISM_INSERTION_TEST:
      return answer_pointers<predicate::insertion_test, as_site, as_site, as_site, as_site>(
          arguments, answer, counters);
    case ASTERISM_EDGE_TEST:
      return answer_pointers<predicate::edge_test, as_site, as_site, as_site, as_site>(
          arguments, answer, counters);
    case ASTERISM_IN_CIRCLE:
      return answer_pointers<predicate::in_circle, as_metric, as_point, as_point, as_point,
                             as_point>(arguments, answer, counters);
  }
  return ASTERISM_OUT_OF_RANGE;
}

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
  return answer_question<predicate::orientation>(answer, nullptr, as_point{p}, as_point{q},
                                                 as_point{r});
}

asterism_status asterism_is_spd(const double metric[3], int* answer) {
  return answer_question<predicate::is_positive_definite>(answer, nullptr, as_metric{metric});
}

asterism_status asterism_in_circle(const double metric[3], const double a[2], const double b[2],
                                   const double c[2], const double p[2], int* answer) {
  return answer_question<predicate::in_circle>(answer, nullptr, as_metric{metric}, as_point{a},
                                               as_point{b}, as_point{c}, as_point{p});
}

asterism_status asterism_in_circle_plane(const double a[2], const double b[2], const double c[2],
                                         const double p[2], int* answer) {
  constexpr std::array<double, 3> plane = {1, 0, 1};
  return asterism_in_circle(plane.data(), a, b, c, p, answer);
}

asterism_status asterism_compare_distance(const double v[5], const double w[5], const double q[2],
                                          int* answer) {
  return answer_question<predicate::compare_distance>(answer, nullptr, as_site{v}, as_site{w},
                                                      as_point{q});
}

asterism_status asterism_in_wedge(const double v[5], const double w[5], const double q[2],
                                  int* answer) {
  return answer_question<predicate::in_wedge>(answer, nullptr, as_site{v}, as_site{w}, as_point{q});
}

asterism_status asterism_dominates(const double v[5], const double w[5], const double p[2],
                                   int* answer) {
  return answer_question<predicate::dominates>(answer, nullptr, as_site{v}, as_site{w},
                                               as_point{p});
}

asterism_status asterism_voronoi_vertex_count(const double u[5], const double v[5],
                                              const double w[5], int* answer) {
  return answer_question<predicate::voronoi_vertex_count>(answer, nullptr, as_site{u}, as_site{v},
                                                          as_site{w});
}

asterism_status asterism_arc_intersection_count(const double v[5], const double w[5],
                                                const double x[5], int* answer) {
  return answer_question<predicate::arc_intersection_count>(answer, nullptr, as_site{v}, as_site{w},
                                                            as_site{x});
}

asterism_status asterism_encroaches(const double a[5], const double b[5], const double w[5],
                                    int* answer) {
  return answer_question<predicate::encroaches>(answer, nullptr, as_site{a}, as_site{b},
                                                as_site{w});
}

asterism_status asterism_insertion_test(const double v[5], const double w[5], const double x[5],
                                        const double y[5], int* answer) {
  return answer_question<predicate::insertion_test>(answer, nullptr, as_site{v}, as_site{w},
                                                    as_site{x}, as_site{y});
}

asterism_status asterism_edge_test(const double v[5], const double w[5], const double x[5],
                                   const double y[5], int* answer) {
  return answer_question<predicate::edge_test>(answer, nullptr, as_site{v}, as_site{w}, as_site{x},
                                               as_site{y});
}

asterism_status asterism_ask(asterism_predicate question, const double* const* arguments,
                             int* answer, asterism_tier_counts* counts) {
  if (arguments == nullptr) return ASTERISM_NULL_POINTER;
  if (counts == nullptr) return answer_named(question, arguments, answer, nullptr);
  tier_counters counted;
  const asterism_status status = answer_named(question, arguments, answer, &counted);
  if (status != ASTERISM_OK) return status;
  const auto decided_by = [&](tier by) {
    return static_cast<size_t>(counted.at(static_cast<predicate>(question), by));
  };
  counts->by_semi_static += decided_by(tier::semi_static);
  counts->by_interval += decided_by(tier::interval);
  counts->by_exact += decided_by(tier::exact);
  return status;
}
