// SPDX-License-Identifier: MIT
//
// Fills a domain: proposes where sites should go so that no point of it is farther than a wanted
// distance from the nearest, and no two sites are nearer than that.
//
// Farthest first, from coarse to fine: on each level the segments are divided, and Voronoi vertices
// of a net of plain stars (numerics/approximate_star.hpp) that are farther than the level's
// distance from all sites become sites, many in a round. It ends because sites of one level keep
// their distance: at most about (4/pi) eps^-2 of the metric area (docs/math/refinement.md). The
// number of rounds is bounded as well, and so is the work for each site, by counts.
//
// The result is a proposal, in doubles. Two things are exact: each site is strictly inside the
// domain, and the given vertices are kept. Exact stars judge everything else.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/neighbour_lists.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/fill/fill_options.hpp"

namespace asterism::internal {

struct filled_domain {
  // Sites that divide each segment, in its direction, ends left out.
  std::vector<std::vector<site>> divisions;
  // Sites inside the domain, in the order of a space-filling curve.
  std::vector<site> interior;
  // The neighbours of each site among all sites, counter-clockwise, by the fill's approximate
  // stars: a first guess at its star. A site on a segment may have neighbours that it does not see
  // in the domain. Numbers count the vertices first, then the points of the divisions, then the
  // interior. A list is empty where the fill's stars disagree, and there are no lists where the
  // fill did not end. Marks are set for sites whose neighbours are all accepted without doubt
  // (numerics/approximate_star.hpp).
  neighbour_lists stars;
  std::size_t rounds = 0;
  bool complete = false;  // false: max_sites was reached, it is crowded, or stopped
  bool stopped = false;   // by options.stop
  // The most crowded site, if the fill was given up at the work limit for its number of sites: the
  // metric varies so fast that each site is near a large part of all others.
  std::optional<crowded_site> crowded;
  // Estimate, from the coarser levels, of the number of sites that a complete fill takes; for a
  // fill that is not complete.
  double needed = 0;
  double work_units = 0;  // done, about, in the units of kernels/work_units.hpp
};

// Function that a fill calls with its number of sites and the estimate of the final one (0 while
// there is none).
using fill_progress = std::function<void(std::size_t sites, double needed)>;

// Fills the domain. `d` must have been accepted by check_domain. The same for any number of
// threads. Fails where the field does, and where lengths leave the range of doubles. `progress` is
// called from time to time. Proposes nothing if segments alone need more than max_sites.
result<filled_domain> fill(const domain& d, const metric_field& field, const fill_options& options,
                           const fill_progress& progress = {});

}  // namespace asterism::internal
