// SPDX-License-Identifier: MIT
//
// What mesh/audit/voronoi_arc.hpp leaves undecided, in exact numbers: Voronoi vertices are real
// roots of polynomials in the parameter of a visible arc (docs/math/visible-arc.md). Complete:
// every question has an answer, ties included. Milliseconds each.
#pragma once

#include <optional>

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"
#include "asterism/kernels/exact_arc.hpp"
#include "asterism/mesh/audit/voronoi_arc.hpp"

namespace asterism::internal::audit_detail {

class exact_voronoi_arc {
 public:
  using parameter = exact::real_root;

  exact_voronoi_arc(const site& v, const site& u);

  // Of the point with f_v = f_u = f_x in the wedges of all three pairs, which is the only one when
  // the sites are not collinear (docs/math/voronoi-certificate.md, lemma 2); empty: there is none.
  std::optional<parameter> vertex(const site& x) const;
  // Of the point on the segment from v to u.
  static parameter on_segment();

  // The sign of a minus b. Parameters grow counter-clockwise around v.
  static sign order(parameter a, parameter b) { return compare(a, b); }

  // Is w nearer than v to some point strictly between? Both parameters on the arc, from < to.
  bool is_nearer(const site& w, parameter from, parameter to) const;

  // The point itself, as seen from v; errors are infinite when its size leaves the doubles.
  offset enclose(parameter at) const;

 private:
  site v_, u_;
  exact::arc on_;
};

// For equal metrics, where bisectors are lines: the sign of f_d - f_a at the Voronoi vertex of a,
// b, c, which turn counter-clockwise. Microseconds.
sign excess_at_centre(const metric_tensor& metric, const point& a, const point& b, const point& c,
                      const point& d);

}  // namespace asterism::internal::audit_detail
