// SPDX-License-Identifier: MIT
//
// Answers every predicate by interval arithmetic: a certain answer is the exact one; where the
// intervals cannot decide the answer is empty, never a sign. Same questions and input as
// filtered_kernel; no state at all.
#pragma once

#include "asterism/core/export.h"
#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"

namespace asterism {

// The predicates by interval arithmetic: right or undecided, never wrong.
class ASTERISM_EXPORT interval_kernel {
 public:
  uncertain_sign orientation(const point& p, const point& q, const point& r) const;
  uncertain_bool is_positive_definite(const metric_tensor& metric) const;
  uncertain_sign compare_distance(const site& v, const site& w, const point& q) const;
  uncertain_bool in_wedge(const site& v, const site& w, const point& q) const;
  uncertain_sign dominates(const site& v, const site& w, const point& p) const;
  uncertain_int voronoi_vertex_count(const site& u, const site& v, const site& w) const;
  uncertain_int arc_intersection_count(const site& v, const site& w, const site& x) const;
  uncertain_bool encroaches(const site& a, const site& b, const site& w) const;
  uncertain_bool insertion_test(const site& v, const site& w, const site& x, const site& y) const;
  uncertain_bool edge_test(const site& v, const site& w, const site& x, const site& y) const;
  uncertain_sign in_circle(const metric_tensor& m, const point& a, const point& b, const point& c,
                           const point& p) const;
};

}  // namespace asterism
