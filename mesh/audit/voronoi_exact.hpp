// SPDX-License-Identifier: MIT
//
// Decides what mesh/audit/voronoi_arc.hpp leaves open, in exact numbers: Voronoi vertices are real
// roots of polynomials in the parameter of a visible arc (docs/math/visible-arc.md). Every question
// has an answer, ties included. Each takes milliseconds.
#pragma once

#include <optional>

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"
#include "asterism/kernels/exact_arc.hpp"
#include "asterism/mesh/audit/voronoi_arc.hpp"

namespace asterism::internal::audit_detail {

// Result of comparing a site with the owners on a part of an arc: `nearer` at some point, equally
// near at some point strictly `between` the ends, or equally near at an end.
struct arc_meeting {
  bool nearer = false, between = false, at_from = false, at_to = false;
};

// Result of comparing, at each point of the segment between two sites, the distance of a third site
// with that of the nearer end.
enum class segment_meeting {
  apart,      // farther at every point
  at_middle,  // as near where both ends are equally far, and farther elsewhere
  as_near,    // at another point, or nearer somewhere
};

class exact_voronoi_arc {
 public:
  using parameter = exact::real_root;

  exact_voronoi_arc(const site& v, const site& u);

  // Returns the point with f_v = f_u = f_x in the wedges of all three pairs, if there is one; it is
  // the only one if they are not collinear (docs/math/voronoi-certificate.md, lemma 2).
  std::optional<parameter> vertex(const site& x) const;
  // Returns the parameter of the point on the segment from v to u.
  static parameter on_segment();

  // Returns the sign of a minus b. Parameters grow counter-clockwise around v.
  static sign order(parameter a, parameter b) { return compare(a, b); }

  // Returns the comparison of w with both owners between two parameters on the arc, from < to.
  arc_meeting meeting_with(const site& w, parameter from, parameter to) const;
  // True if the point is in the wedges of w and of each owner.
  bool is_wedged_with(const site& w, parameter at) const;

  // Returns the point in doubles with error bounds, relative to v; the bounds are infinite when its
  // size leaves the doubles.
  offset enclose(parameter at) const;

 private:
  site v_, u_;
  exact::arc on_;
};

// Compares w with the nearer of a and b along the segment from a to b. Requires that w does not
// encroach on the segment.
segment_meeting meeting_with_segment(const site& a, const site& b, const site& w);

// Returns, for equal metrics, where bisectors are lines, the sign of f_d - f_a at the Voronoi
// vertex of a, b, c, which turn counter-clockwise. Takes microseconds.
sign excess_at_centre(const metric_tensor& metric, const point& a, const point& b, const point& c,
                      const point& d);

}  // namespace asterism::internal::audit_detail
