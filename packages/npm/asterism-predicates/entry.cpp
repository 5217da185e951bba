// SPDX-License-Identifier: MIT
//
// The functions that JavaScript calls in the module of asterism-predicates. Numbers lie in the
// module's memory, where api.mjs writes them; everything else is the C interface.
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "asterism/kernels/batch_question.hpp"
#include "asterism/kernels/c_api.h"
#include "asterism/kernels/c_batch.h"
#include "asterism/kernels/c_question.hpp"
#include "asterism/kernels/filtered_kernel.hpp"

#define ASTERISM_FOR_JAVASCRIPT(name) extern "C" __attribute__((export_name(#name), used))

namespace {

using namespace asterism;

constexpr std::size_t most_arguments = 5;

// Buffers for the numbers of one question, and of the rows of a batch that are answered at once.
constexpr std::size_t room = 16384;
double numbers[room];
signed char answers[room];
double failed_row;
// How many questions each tier decided, and the same as numbers that JavaScript reads.
tier_counters counters;
double decided[predicate_count][tier_count];

// A number below every answer. A refusal returns it minus the status.
constexpr int refusal_base = -16;

// Returns the answer to the question with these numbers, or refusal_base minus the status.
int ask_one(predicate question, const double* from) {
  batch_record record{question, {}};
  std::copy(from, from + numbers_of(question), record.numbers.begin());
  if (const asterism_status bad = internal::check_record(filtered_kernel(), record);
      bad != ASTERISM_OK)
    return refusal_base - bad;
  return ask(filtered_kernel(counters), record).value();
}

// Returns `value` if its sign is the given one, else a number next to zero with that sign.
double with_sign(double value, int sign) {
  if (sign == 0) return 0;
  const bool agrees = sign > 0 ? value > 0 : value < 0;
  return agrees ? value : sign * std::numeric_limits<double>::denorm_min();
}

asterism_status ask_rows(unsigned question, std::size_t count, const asterism_rows* a,
                         asterism_batch_report* report) {
  switch (question) {
    case ASTERISM_ORIENTATION:
      return asterism_orientations(count, a[0], a[1], a[2], answers, report);
    case ASTERISM_IS_SPD:
      return asterism_are_spd(count, a[0], answers, report);
    case ASTERISM_COMPARE_DISTANCE:
      return asterism_compare_distances(count, a[0], a[1], a[2], answers, report);
    case ASTERISM_IN_WEDGE:
      return asterism_in_wedges(count, a[0], a[1], a[2], answers, report);
    case ASTERISM_DOMINATES:
      return asterism_dominations(count, a[0], a[1], a[2], answers, report);
    case ASTERISM_VORONOI_VERTEX_COUNT:
      return asterism_voronoi_vertex_counts(count, a[0], a[1], a[2], answers, report);
    case ASTERISM_ARC_INTERSECTION_COUNT:
      return asterism_arc_intersection_counts(count, a[0], a[1], a[2], answers, report);
    case ASTERISM_ENCROACHES:
      return asterism_encroachments(count, a[0], a[1], a[2], answers, report);
    case ASTERISM_INSERTION_TEST:
      return asterism_insertion_tests(count, a[0], a[1], a[2], a[3], answers, report);
    case ASTERISM_EDGE_TEST:
      return asterism_edge_tests(count, a[0], a[1], a[2], a[3], answers, report);
    case ASTERISM_IN_CIRCLE:
      return asterism_in_circles(count, a[0], a[1], a[2], a[3], a[4], answers, report);
    default:
      return ASTERISM_OUT_OF_RANGE;
  }
}

}  // namespace

ASTERISM_FOR_JAVASCRIPT(numbers) double* numbers_for_javascript() { return numbers; }
ASTERISM_FOR_JAVASCRIPT(room) std::size_t room_for_javascript() { return room; }
ASTERISM_FOR_JAVASCRIPT(answers) signed char* answers_for_javascript() { return answers; }
ASTERISM_FOR_JAVASCRIPT(decided) double* decided_for_javascript() {
  for (std::size_t p = 0; p < predicate_count; ++p)
    for (std::size_t t = 0; t < tier_count; ++t)
      decided[p][t] = static_cast<double>(counters.decided[p][t]);
  return &decided[0][0];
}
ASTERISM_FOR_JAVASCRIPT(resetCounters) void reset_counters_for_javascript() { counters = {}; }
ASTERISM_FOR_JAVASCRIPT(failedRow) double failed_row_for_javascript() { return failed_row; }
ASTERISM_FOR_JAVASCRIPT(message) const char* message_for_javascript(int status) {
  return asterism_status_message(static_cast<asterism_status>(status));
}
ASTERISM_FOR_JAVASCRIPT(version) const char* version_for_javascript() {
  return asterism_version_text();
}

// Answers one question, whose numbers are at the start of `numbers`.
ASTERISM_FOR_JAVASCRIPT(ask) int ask_for_javascript(unsigned question) {
  return ask_one(static_cast<predicate>(question), numbers);
}

// Answers `count` questions into `answers`. The arguments are in `numbers`, one after another, as
// rows. Bit k of `constant` is set where argument k is one row for all questions.
ASTERISM_FOR_JAVASCRIPT(askMany)
int ask_many_for_javascript(unsigned question, std::size_t count, unsigned constant) {
  asterism_rows arguments[most_arguments];
  const record_shape shape = record_shapes[question];
  const double* from = numbers;
  for (std::size_t k = 0; k < shape.metrics + shape.sites + shape.points; ++k) {
    const std::size_t width = k < shape.metrics ? 3 : k < shape.metrics + shape.sites ? 5 : 2;
    const bool one = ((constant >> k) & 1U) != 0;
    arguments[k] = {from, one ? 0 : width};
    from += one ? width : count * width;
  }
  asterism_batch_report report{};
  const asterism_status status = ask_rows(question, count, arguments, &report);
  failed_row = static_cast<double>(report.failed_row);
  const auto add = [question](tier by, std::size_t count_of_tier) {
    counters.at(static_cast<predicate>(question), by) += count_of_tier;
  };
  add(tier::semi_static, report.by_semi_static);
  add(tier::interval, report.by_interval);
  add(tier::exact, report.by_exact);
  return status;
}

// orient2d of robust-predicates: positive where a, b, c turn clockwise with y upwards, which is
// counterclockwise on a screen. Its value approximates twice the area of the triangle. NaN where a
// number is not finite.
ASTERISM_FOR_JAVASCRIPT(orient2d)
double orient2d_for_javascript(double ax, double ay, double bx, double by, double cx, double cy) {
  for (const double x : {ax, ay, bx, by, cx, cy})
    if (!internal::is_finite(x)) return std::numeric_limits<double>::quiet_NaN();
  const sign turn = filtered_kernel(counters).orientation({ax, ay}, {bx, by}, {cx, cy});
  return with_sign((ay - cy) * (bx - cx) - (ax - cx) * (by - cy), -to_int(turn));
}

// incircle of robust-predicates: positive where d lies in the circle of a, b, c that turn
// counterclockwise with y upwards. NaN where a number is not finite.
ASTERISM_FOR_JAVASCRIPT(incircle)
double incircle_for_javascript(double ax, double ay, double bx, double by, double cx, double cy,
                               double dx, double dy) {
  for (const double x : {ax, ay, bx, by, cx, cy, dx, dy})
    if (!internal::is_finite(x)) return std::numeric_limits<double>::quiet_NaN();
  const sign place = filtered_kernel(counters).in_circle({ax, ay}, {bx, by}, {cx, cy}, {dx, dy});
  const double adx = ax - dx, ady = ay - dy, bdx = bx - dx, bdy = by - dy, cdx = cx - dx,
               cdy = cy - dy;
  return with_sign((adx * adx + ady * ady) * (bdx * cdy - cdx * bdy) +
                       (bdx * bdx + bdy * bdy) * (cdx * ady - adx * cdy) +
                       (cdx * cdx + cdy * cdy) * (adx * bdy - bdx * ady),
                   to_int(place));
}
