// SPDX-License-Identifier: MIT
//
// Excludes sites from gaps of a star by the gaps' outline.
//
// A site w that a gap accepts meets the gap's kite (docs/math/certificate.md, section 4.3): for
// every covector g,
//   g . (w - v) <= max(0, g . p + |g|_w length(p)) over the points p,
// where the points are the corners of the kite other than v, with their distances from v, and the
// two neighbours, with the length 0. So a site for which one covector exceeds that for all points
// is accepted in no gap. The covector is a free choice: for one kite that of the way to w from the
// corner towards the Voronoi vertex, in the metric of w.
#pragma once

#include <span>

#include "asterism/core/site.hpp"

namespace asterism::internal::audit_detail {

// A point relative to v.
struct outline_point {
  point at;
  double length = 0;  // no less than its distance from v, or 0 for a neighbour
};

// A neighbour of v, and the point up to which the way to it belongs to the kites beside it.
struct kite_side {
  point neighbour;
  outline_point on_way;
};

// True if certainly the site w, at `to` from v, is not accepted in the gap of a kite: for the half
// of the kite on either side of its vertex, one of two covectors suffices.
bool is_outside_kite(const point& to, const metric_tensor& metric, const outline_point& vertex,
                     std::span<const kite_side> sides);

}  // namespace asterism::internal::audit_detail
