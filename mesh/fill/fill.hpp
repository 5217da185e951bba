// SPDX-License-Identifier: MIT
//
// Fills a domain: proposes where sites should go so that no point of it is farther than a wanted
// distance from the nearest, and no two sites are nearer than that.
//
// Farthest first, from coarse to fine: on each level the segments are divided, and Voronoi vertices
// of a net of plain stars (numerics/approximate_star.hpp) that are farther than the level's
// distance from all sites become sites, many in a round. It ends because sites of one level keep
// their distance: at most about (4/pi) eps^-2 of the metric area (docs/math/refinement.md). The
// rounds are bounded besides, and so is the work for each site, by counts.
//
// The result is a proposal, in doubles. Exact is that each site is strictly inside the domain, and
// the given vertices; everything else is for exact stars to judge.
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
  // For each segment the points that divide it, in its direction, ends left out.
  std::vector<std::vector<site>> divisions;
  // Sites inside the domain, in the order of a space-filling curve.
  std::vector<site> interior;
  // The neighbours of each site among all sites, counter-clockwise, as the fill saw them: a first
  // guess at its star. On a segment there may be some that the domain does not let it see. Numbered
  // are the vertices first, then the points of the divisions, then the interior. A list is empty
  // where the fill's stars disagree, and there are none where it did not come to its end. Marked
  // are those of which each neighbour is plainly one (numerics/approximate_star.hpp).
  neighbour_lists stars;
  std::size_t rounds = 0;
  bool complete = false;  // false: max_sites was reached, it is crowded, or stopped
  bool stopped = false;   // by options.stop
  // The most crowded site, if the fill was given up after the most work that is done for so many
  // sites: the metric varies so fast that each is near a part of all others.
  std::optional<crowded_site> crowded;
  // If not complete: about how many sites it would take, as far as can be told from coarser levels.
  double needed = 0;
  double work_units = 0;  // done, about, in the units of kernels/work_units.hpp
};

// Told the number of sites and about how many there will be (0 when that cannot be told yet).
using fill_progress = std::function<void(std::size_t sites, double needed)>;

// Fills the domain. `d` must have been accepted by check_domain. The same for any number of
// threads. Fails where the field does, and where lengths leave the range of doubles. `progress` is
// called now and then. Proposes nothing if segments alone need more than max_sites.
result<filled_domain> fill(const domain& d, const metric_field& field, const fill_options& options,
                           const fill_progress& progress = {});

}  // namespace asterism::internal
