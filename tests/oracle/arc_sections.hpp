// SPDX-License-Identifier: MIT
//
// Finds the sections of Vor{v,w} on which the insertion test is constant, by sweeping the plane
// along the X axis, and which of them are good.
#pragma once

#include <vector>

#include "exact_numbers.hpp"

namespace asterism::oracle {

// Events at a critical abscissa. A set of events is the sum of their values.
enum critical_kind : unsigned {
  equidistant_from_x = 1,  // f_v = f_w = f_x at a point
  equidistant_from_y = 2,
  tangency = 4,    // a segment from a site touches a bisector, or the curve has a vertical tangent
  line_event = 8,  // the abscissa is on a line through two sites
};

// A maximal run of good sections along one branch. An end that does not exist is 0.
struct good_run {
  unsigned kinds_at_low_end = 0, kinds_at_high_end = 0;
};

struct swept_arc {
  std::vector<good_run> good_runs;
  // False only if certainly no point, real or complex, is equally far from all four sites.
  bool may_have_point_equidistant_from_four = false;
  // True if such a point may not be isolated, or a bisector may touch the curve or a segment from a
  // site there: first order then decides nothing.
  bool tie_may_be_beyond_first_order = false;
};

// Requires four distinct sites.
swept_arc sweep(const exact_site& v, const exact_site& w, const exact_site& x, const exact_site& y);

}  // namespace asterism::oracle
