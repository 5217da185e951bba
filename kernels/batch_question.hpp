// SPDX-License-Identifier: MIT
//
// Turns a record of the batch protocol into a question that can be put to any kernel, for the batch
// evaluator, the kernel checker and the tests that compare kernels.
//
// Answers are integers as in the batch protocol; empty where a kernel is undecided.
#pragma once

#include <array>
#include <cstddef>

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"
#include "asterism/kernels/tier_counters.hpp"

namespace asterism {

inline constexpr std::size_t longest_record = 20;  // numbers: those of four sites

// A question and its numbers: metrics first, then sites, then points. Those beyond the predicate's
// own are 0.
struct batch_record {
  predicate question = predicate::orientation;
  std::array<double, longest_record> numbers{};
};

// Shape of a predicate's record: the numbers of its metrics, sites and points.
struct record_shape {
  std::size_t metrics, sites, points;
};
// Shapes of the records of all predicates, in the order of `predicate`.
inline constexpr std::array<record_shape, predicate_count> record_shapes = {{
    {0, 0, 3},  // orientation
    {1, 0, 0},  // is_spd
    {0, 2, 1},  // compare_distance
    {0, 2, 1},  // in_wedge
    {0, 2, 1},  // dominates
    {0, 3, 0},  // voronoi_vertex_count
    {0, 3, 0},  // arc_intersection_count
    {0, 3, 0},  // encroaches
    {0, 4, 0},  // insertion_test
    {0, 4, 0},  // edge_test
    {1, 0, 4},  // in_circle
}};
// Returns how many sites and points the predicate takes.
constexpr record_shape shape_of(predicate question) {
  return record_shapes[static_cast<std::size_t>(question)];
}
// Returns how many numbers the predicate takes.
constexpr std::size_t numbers_of(predicate question) {
  const record_shape shape = shape_of(question);
  return 3 * shape.metrics + 5 * shape.sites + 2 * shape.points;
}

// Returns the point whose first number has the index `first`, which need not be the first number of
// a site: any two successive numbers of a record can be read as a point.
constexpr point point_at(const batch_record& record, std::size_t first) {
  return {record.numbers[first], record.numbers[first + 1]};
}
// Returns the tensor whose first number has the index `first`.
constexpr metric_tensor metric_at(const batch_record& record, std::size_t first) {
  return {record.numbers[first], record.numbers[first + 1], record.numbers[first + 2]};
}
// Returns the site number `which`, from 0, of a record without metrics of their own.
constexpr site site_at(const batch_record& record, std::size_t which) {
  return {point_at(record, 5 * which), metric_at(record, 5 * which + 2)};
}

// Returns -1, 0 or 1.
constexpr uncertain_int as_integer(sign s) { return to_int(s); }
// Returns 1 for yes, 0 for no.
constexpr uncertain_int as_integer(bool yes) { return yes ? 1 : 0; }
// Returns the count unchanged: the answer of a predicate that counts is its integer already.
constexpr uncertain_int as_integer(int count) { return count; }
// Returns the answer as an integer of the batch protocol; undecided stays so.
template <class T>
constexpr uncertain_int as_integer(uncertain<T> answer) {
  return answer.certain() ? as_integer(answer.value()) : uncertain_int();
}

// Evaluates the record by the kernel. Requires a record that the kernel accepts: finite, positive
// definite, sites distinct.
template <class Kernel>
uncertain_int ask(const Kernel& kernel, const batch_record& r) {
  const auto s = [&r](std::size_t which) { return site_at(r, which); };
  switch (r.question) {
    case predicate::orientation:
      return as_integer(kernel.orientation(point_at(r, 0), point_at(r, 2), point_at(r, 4)));
    case predicate::is_positive_definite:
      return as_integer(kernel.is_positive_definite(metric_at(r, 0)));
    case predicate::compare_distance:
      return as_integer(kernel.compare_distance(s(0), s(1), point_at(r, 10)));
    case predicate::in_wedge:
      return as_integer(kernel.in_wedge(s(0), s(1), point_at(r, 10)));
    case predicate::dominates:
      return as_integer(kernel.dominates(s(0), s(1), point_at(r, 10)));
    case predicate::voronoi_vertex_count:
      return as_integer(kernel.voronoi_vertex_count(s(0), s(1), s(2)));
    case predicate::arc_intersection_count:
      return as_integer(kernel.arc_intersection_count(s(0), s(1), s(2)));
    case predicate::encroaches:
      return as_integer(kernel.encroaches(s(0), s(1), s(2)));
    case predicate::insertion_test:
      return as_integer(kernel.insertion_test(s(0), s(1), s(2), s(3)));
    case predicate::edge_test:
      return as_integer(kernel.edge_test(s(0), s(1), s(2), s(3)));
    case predicate::in_circle:
      return as_integer(kernel.in_circle(metric_at(r, 0), point_at(r, 3), point_at(r, 5),
                                         point_at(r, 7), point_at(r, 9)));
  }
  return {};
}

}  // namespace asterism
