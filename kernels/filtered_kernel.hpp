// SPDX-License-Identifier: MIT
//
// Decides every predicate exactly: by plain doubles with an error bound where that suffices, else
// by interval arithmetic, else by exact arithmetic (docs/math/tiers.md).
//
// Input: finite doubles; metric tensors positive definite; the sites of one call distinct.
// Other input is a caller's error: check with is_positive_definite first. Output: the exact
// answer for the doubles given, for any magnitude of the input. State: none; a kernel may be
// shared by any number of threads. A kernel with counters writes to them: give each thread its
// own, and add them up. Floating-point environment: any rounding mode, FTZ and DAZ may be set
// by the caller; they are neither trusted nor changed on return
// (core/floating_point_environment.hpp).
#pragma once

#include "asterism/core/export.h"
#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"
#include "asterism/kernels/tier_counters.hpp"

namespace asterism {

// The predicates, always right and fast. Example:
//
//   const filtered_kernel kernel;
//   const bool keep = kernel.edge_test(v, w, x, y);
class ASTERISM_EXPORT filtered_kernel {
 public:
  filtered_kernel() = default;
  // Counts in `decided`, which must outlive the kernel and its copies. For one thread.
  explicit filtered_kernel(tier_counters& decided) : decided_(&decided) {}

  // Predicates with the definitions in predicates/, one header each.
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
  // Decides the usual in-circle test, in the plane as it is.
  sign in_circle(const point& a, const point& b, const point& c, const point& p) const {
    return in_circle({1, 0, 1}, a, b, c, p);
  }

 private:
  tier_counters* decided_ = nullptr;
};

}  // namespace asterism
