// SPDX-License-Identifier: MIT
//
// Answers many questions in one call: structure of arrays, one column a number, question k in row k
// of every column. The semi-static tier runs over all rows at once, several to a vector register; a
// filtered_kernel decides the rows left undecided.
//
// Answers go into a column of signed char. They are those of filtered_kernel, -1, 0 or 1 for a
// sign, 0 or 1 for yes and no; always the same as row by row, whatever vectors the processor has.
// Errors: batch_status::length_mismatch when two columns, or the answers, differ in length; nothing
// is written then. No row is a valid batch. The columns of one call may overlap each other, but not
// the answers.
// Input, floating-point environment, state: as for filtered_kernel.
#pragma once

#include <span>

#include "asterism/core/export.h"
#include "asterism/kernels/batch_columns.hpp"
#include "asterism/kernels/filtered_kernel.hpp"

namespace asterism {

// Outcome of a batch: answered, or refused. After length_mismatch nothing was written.
enum class [[nodiscard]] batch_status{ok, length_mismatch};

// Answers one predicate for many rows. Without counters it may be shared by threads.
class ASTERISM_EXPORT batch_kernel {
 public:
  batch_kernel() = default;
  // Counts in `decided` the questions that each tier decides; it must outlive the kernel and its
  // copies. For one thread.
  explicit batch_kernel(tier_counters& decided) : decided_(&decided) {}

  batch_status orientation(const point_columns& p, const point_columns& q, const point_columns& r,
                           std::span<signed char> answers) const;
  batch_status in_circle(const metric_columns& m, const point_columns& a, const point_columns& b,
                         const point_columns& c, const point_columns& p,
                         std::span<signed char> answers) const;
  batch_status compare_distance(const site_columns& v, const site_columns& w,
                                const point_columns& q, std::span<signed char> answers) const;
  batch_status in_wedge(const site_columns& v, const site_columns& w, const point_columns& q,
                        std::span<signed char> answers) const;
  batch_status dominates(const site_columns& v, const site_columns& w, const point_columns& p,
                         std::span<signed char> answers) const;
  // Decides rows of four equal metrics in the first pass; filtered_kernel decides the others.
  batch_status edge_test(const site_columns& v, const site_columns& w, const site_columns& x,
                         const site_columns& y, std::span<signed char> answers) const;

 private:
  tier_counters* decided_ = nullptr;
};

}  // namespace asterism
