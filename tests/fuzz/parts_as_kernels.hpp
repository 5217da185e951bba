// SPDX-License-Identifier: MIT
//
// Makes kernels of parts of the filtered kernel, so that a question can be put to one part
// alone. Undecided where the part is undecided, and for questions that the part does not
// answer.
#pragma once

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"

namespace asterism::fuzz {

class undecided_kernel {
 public:
  uncertain_sign orientation(const point&, const point&, const point&) const { return {}; }
  uncertain_bool is_positive_definite(const metric_tensor&) const { return {}; }
  uncertain_sign compare_distance(const site&, const site&, const point&) const { return {}; }
  uncertain_bool in_wedge(const site&, const site&, const point&) const { return {}; }
  uncertain_sign dominates(const site&, const site&, const point&) const { return {}; }
  uncertain_int voronoi_vertex_count(const site&, const site&, const site&) const { return {}; }
  uncertain_int arc_intersection_count(const site&, const site&, const site&) const { return {}; }
  uncertain_bool encroaches(const site&, const site&, const site&) const { return {}; }
  uncertain_bool insertion_test(const site&, const site&, const site&, const site&) const {
    return {};
  }
  uncertain_bool edge_test(const site&, const site&, const site&, const site&) const { return {}; }
  uncertain_sign in_circle(const metric_tensor&, const point&, const point&, const point&,
                           const point&) const {
    return {};
  }
};

// star_gap: the gap of v between x and y, and the one between y and x. Nothing is known of where
// the sites stand, so the gap has to notice itself what it cannot answer.
class gap_of_v_kernel : public undecided_kernel {
 public:
  uncertain_bool edge_test(const site& v, const site& w, const site& x, const site& y) const;
};
// Evaluates the question from the side of w.
class gap_of_w_kernel : public undecided_kernel {
 public:
  uncertain_bool edge_test(const site& v, const site& w, const site& x, const site& y) const;
};

class fixed_width_kernel : public undecided_kernel {
 public:
  uncertain_sign orientation(const point& p, const point& q, const point& r) const;
  uncertain_bool is_positive_definite(const metric_tensor& metric) const;
  uncertain_sign compare_distance(const site& v, const site& w, const point& q) const;
  uncertain_bool in_wedge(const site& v, const site& w, const point& q) const;
  uncertain_sign dominates(const site& v, const site& w, const point& p) const;
  uncertain_bool insertion_test(const site& v, const site& w, const site& x, const site& y) const;
  uncertain_bool edge_test(const site& v, const site& w, const site& x, const site& y) const;
  uncertain_sign in_circle(const metric_tensor& m, const point& a, const point& b, const point& c,
                           const point& p) const;
};

// batch_kernel with the question in every row: a block of rows side by side, and one row alone.
class block_of_rows_kernel : public undecided_kernel {
 public:
  uncertain_sign orientation(const point& p, const point& q, const point& r) const;
  uncertain_sign compare_distance(const site& v, const site& w, const point& q) const;
  uncertain_bool in_wedge(const site& v, const site& w, const point& q) const;
  uncertain_sign dominates(const site& v, const site& w, const point& p) const;
  uncertain_bool edge_test(const site& v, const site& w, const site& x, const site& y) const;
  uncertain_sign in_circle(const metric_tensor& m, const point& a, const point& b, const point& c,
                           const point& p) const;
};
class single_row_kernel : public undecided_kernel {
 public:
  uncertain_sign orientation(const point& p, const point& q, const point& r) const;
  uncertain_sign compare_distance(const site& v, const site& w, const point& q) const;
  uncertain_bool in_wedge(const site& v, const site& w, const point& q) const;
  uncertain_sign dominates(const site& v, const site& w, const point& p) const;
  uncertain_bool edge_test(const site& v, const site& w, const site& x, const site& y) const;
  uncertain_sign in_circle(const metric_tensor& m, const point& a, const point& b, const point& c,
                           const point& p) const;
};

}  // namespace asterism::fuzz
