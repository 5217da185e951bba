// SPDX-License-Identifier: MIT
//
// Proposes places for the next sites of a fill, and chooses among them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/fill/approximate_star_store.hpp"
#include "asterism/mesh/fill/domain_locator.hpp"
#include "asterism/mesh/fill/placed_sites.hpp"
#include "asterism/mesh/fill/segment_intervals.hpp"
#include "asterism/mesh/fill/work_meter.hpp"

namespace asterism::internal {

struct site_proposal {
  site where;
  double squared_radius;  // to the sites around, as the first of them measures
};

// Objects that proposals are made from; all of them must outlive the proposals.
struct fill_parts {
  const domain& shape;
  bounding_box box;
  const metric_field& field;
  placed_sites& sites;
  const segment_intervals& segments;
  const approximate_star_store& stars;
  work_meter& work;
};

class site_proposals {
 public:
  // Takes the parts. With `uneven`, a gap without a Voronoi vertex proposes a point on the way to
  // the neighbour.
  site_proposals(const fill_parts& parts, bool uneven)
      : parts_(parts), uneven_(uneven), locator_(parts.shape) {}

  // Places sites farther than `distance` from each other all over the domain, before there is any
  // star, until no place keeps that distance or `sites` is full.
  void scatter(double distance);

  // Returns Voronoi vertices of the changed stars: those that are farther than `distance` from all
  // sites, encroach on no subsegment and are inside the domain. Fails where the field fails inside
  // the domain.
  result<std::vector<site_proposal>> collect(double distance) const;

  // Places as many of the proposals as keep their distance from each other, the farthest from
  // other sites first.
  void place(std::vector<site_proposal> proposals, double distance);

 private:
  struct attempt {
    site_proposal made;
    bool has_metric = true;  // false: the field failed there
  };

  // Returns the places at which the proposals for these sites evaluate the metric.
  std::vector<point> places_for(const std::vector<vertex_index>& which, double distance) const;
  void propose(const filtered_kernel& kernel, vertex_index v, double distance,
               std::uint64_t& looked_at, std::vector<attempt>& out) const;
  std::optional<site_proposal> vertex_of_gap(vertex_index v, std::size_t gap,
                                             double distance) const;
  bool scatter_at(const filtered_kernel& kernel, const point& q, const point& half,
                  double distance);
  bool is_allowed(const filtered_kernel& kernel, const site& s, double distance,
                  std::uint64_t& looked_at) const;
  bool has_room(const site_index& among, const site& s, double distance,
                std::uint64_t& looked_at) const;
  std::vector<std::uint32_t> in_order_of_placing(const std::vector<site_proposal>& proposals,
                                                 double distance) const;
  void leave_out_crowded(std::vector<const site_proposal*>& ready, const site_index& placed,
                         double distance);
  bool place_in_turn(const std::vector<const site_proposal*>& ready, double distance);

  fill_parts parts_;
  bool uneven_;
  domain_locator locator_;
};

}  // namespace asterism::internal
