// SPDX-License-Identifier: MIT
//
// Answers every predicate in plain doubles: no error bound, no fallback, sometimes wrong. It serves
// as a baseline in bench/ and as an example of failures in tests/; nothing that must be right uses
// it. Same questions and input as filtered_kernel; no state at all.
#pragma once

#include "asterism/core/export.h"
#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"

namespace asterism {

// The predicates in plain doubles, sometimes wrong: a baseline for measurements.
class ASTERISM_EXPORT double_kernel {
 public:
  sign orientation(const point& p, const point& q, const point& r) const;
  bool is_positive_definite(const metric_tensor& metric) const;
  sign compare_distance(const site& v, const site& w, const point& q) const;
  bool in_wedge(const site& v, const site& w, const point& q) const;
  sign dominates(const site& v, const site& w, const point& p) const;
  int voronoi_vertex_count(const site& u, const site& v, const site& w) const;
  int arc_intersection_count(const site& v, const site& w, const site& x) const;
  bool encroaches(const site& a, const site& b, const site& w) const;
  bool insertion_test(const site& v, const site& w, const site& x, const site& y) const;
  bool edge_test(const site& v, const site& w, const site& x, const site& y) const;
  sign in_circle(const metric_tensor& m, const point& a, const point& b, const point& c,
                 const point& p) const;
};

}  // namespace asterism
