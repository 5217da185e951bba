// SPDX-License-Identifier: MIT
//
// Shows of most stars of a triangulation that they accept no site but their neighbours, without a
// tree: by a walk from each site over the triangles that its ball meets.
//
// A site w that a gap of v accepts is within R, as w measures, of a point that is in the gap's
// triangle, or in one behind it that the gap is listed with (docs/math/certificate.md, 4.4). So w
// is to be asked of those gaps alone whose triangles the ball of that radius around w meets, and
// these are joined to w, or to a piece of the boundary that the ball meets.
//
// It only ever shows that nothing is accepted. What may be accepted, or be where a walk does not
// come to, is left to who asks all sites in reach.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/mesh/audit/context.hpp"
#include "asterism/mesh/audit/star_surroundings.hpp"

namespace asterism::internal::audit_detail {

struct walk_outcome {
  // True if some site was not asked of all gaps that it is to be asked of: nothing is shown.
  bool has_failed = false;
  // One flag a site: its star is not shown to accept no others.
  std::vector<char> is_left;
  // Gaps that are listed with triangles behind their own, and those left; triangles met by balls,
  // but for those at their sites.
  std::size_t listed_gaps = 0, left_gaps = 0, triangles_met = 0;
};

// Looks at all stars, all sites against all. Counts pairs and work in the context. Requires what
// points 0 to 2 show, and sites that are not brought to unit size.
walk_outcome walk_stars(audit_context& context, const star_surroundings& around);

}  // namespace asterism::internal::audit_detail
