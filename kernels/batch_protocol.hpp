// SPDX-License-Identifier: MIT
//
// Answers the predicates in text: one record a line in, one integer a line out.
//
//   record   name, then numbers, separated by blanks (space, tab, CR, VT, FF)
//   number   decimal or C99 hexadecimal (0x1.8p-3), optional sign; read as the nearest double
//            whatever the locale. A number too small for a double is read as the zero or subnormal
//            number nearest to it; one too large is not finite.
//   point    two numbers x y;  site: five numbers x y m11 m12 m22
//   comment  a line whose first character that is not blank is '#', or a line of blanks: no answer
//
//   orientation p q r            is_spd m11 m12 m22         compare_distance v w q
//   in_wedge v w q               dominates v w p            voronoi_vertex_count u v w
//   arc_intersection_count v w x encroaches a b w           insertion_test v w x y
//   edge_test v w x y            in_circle m11 m12 m22 a b c p
//   orient2d p q r               incircle a b c p           (in the plane, by their usual names)
//
// Answers: a sign as -1, 0, 1; a yes as 1, a no as 0; a count as itself. `?` where the interval
// kernel cannot decide. `error: ...`, naming the field (the name is field 1) where there is
// one, for: an unknown name, a token that is no number, a wrong number of numbers, a number that is
// not finite, a metric that is not positive definite (decided exactly), two sites at one position.
//
// Two sites at one position are refused even when their metrics differ: the bisector is then a pair
// of lines through the common position or that position alone, and neither site has a cell. A point
// may coincide with a site or with another point. is_spd refuses only what is not finite.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string_view>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/core/sign.hpp"
#include "asterism/kernels/batch_question.hpp"
#include "asterism/kernels/double_kernel.hpp"
#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/kernels/interval_kernel.hpp"
#include "asterism/kernels/tier_counters.hpp"

namespace asterism {

// Reads one line; nothing for a comment or a blank line. `line` comes without its end of line; a
// final CR is a blank.
ASTERISM_EXPORT result<std::optional<batch_record>> parse_record(std::string_view line);

// Kinds of kernels that can answer.
enum class kernel_choice { filtered, exact, interval, plain_double };

// The tier or kernel that settled a record; `undecided` only with the interval kernel.
enum class settled_by : std::size_t { semi_static, interval, exact, plain_double, undecided };
// Number of tiers and kernels in settled_by.
inline constexpr std::size_t settled_by_count = 5;
// Names of the tiers and kernels in settled_by, in order.
inline constexpr std::array<std::string_view, settled_by_count> settled_by_names = {
    "semi-static", "interval", "exact", "double", "undecided"};

// Numbers of records that each tier or kernel settled, by predicate.
struct batch_statistics {
  std::array<std::array<std::uint64_t, settled_by_count>, predicate_count> settled{};
  std::uint64_t answers = 0;  // records that got an integer or `?`
  std::uint64_t errors = 0;   // records answered by `error: ...`
};

// Evaluates records with one kernel and counts what settled them. Not to be shared by threads.
class ASTERISM_EXPORT batch_evaluator {
 public:
  explicit batch_evaluator(kernel_choice choice) : choice_(choice) {}

  // Returns the answer; empty where the interval kernel cannot decide.
  uncertain_int answer(const batch_record& record);

  // Writes one answer for each line of `in`, in order, to the end of `in`. Flushes `out` whenever
  // the next read may have to wait, so that a program or a person asking one question at a time
  // gets each answer.
  void answer_all(std::istream& in, std::ostream& out);

  const batch_statistics& statistics() const { return statistics_; }

 private:
  uncertain_int filtered_answer(const batch_record& record, settled_by& how);

  kernel_choice choice_;
  batch_statistics statistics_;
};

// Writes a table with a line for each predicate asked: how many of its records each tier
// settled.
ASTERISM_EXPORT void write_statistics(std::ostream& out, const batch_statistics& statistics);

}  // namespace asterism
