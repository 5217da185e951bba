// SPDX-License-Identifier: MIT
//
// Moves the sites of a finished fill towards the middle of their neighbours.
//
// A fill keeps distances and leaves no holes, but each site is where the last hole was: its edges
// are longer in the mean than those between the same number of evenly spread sites. Each site goes
// half the way to the mean of its neighbours, all at once, and once (docs/design/refinement.md). A
// site stays if it might come nearer to a neighbour than a fill allows, or make a triangle too
// large, whether the neighbours move or not: so the distances of a fill are kept, but for the
// variation of metrics on the way. Works in doubles; the result is a proposal.
#pragma once

#include <array>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/fill/domain_locator.hpp"
#include "asterism/mesh/fill/site_proposals.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

class relaxation {
 public:
  // Displacements from a site at its new place to a neighbour's old and new places, and their
  // squared lengths in the site's metric.
  struct ways_to_neighbour {
    vertex_index neighbour;
    std::array<point, 2> way;
    std::array<double, 2> squared;
  };

  // Takes a fill that has ended; does not use the index of its sites. `order` lists all sites so
  // that near ones follow each other; it must outlive the object.
  relaxation(const fill_parts& parts, const std::vector<vertex_index>& order)
      : parts_(parts), order_(order), locator_(parts.shape) {}

  // Moves the sites, without their stars. Sites of the domain and of its segments stay, and so do
  // sites that would encroach on a subsegment, leave the domain, or be where the metric is not
  // known. All stay if the run is stopped before.
  void run(double distance, const cancellation& stop);

 private:
  void find_places(const cancellation& stop);
  point middle_of_neighbours(vertex_index v) const;
  std::vector<vertex_index> those_that_may_go(double distance, const cancellation& stop) const;
  bool may_go(const filtered_kernel& kernel, vertex_index v, double distance) const;
  bool stays_clear(vertex_index v, double distance) const;
  bool keeps_distances(vertex_index v, const std::vector<ways_to_neighbour>& ways,
                       double distance) const;

  const point& here(vertex_index v) const { return parts_.sites[v].position; }

  fill_parts parts_;
  const std::vector<vertex_index>& order_;
  domain_locator locator_;
  std::vector<point> places_;  // where each site would go
};

}  // namespace asterism::internal
