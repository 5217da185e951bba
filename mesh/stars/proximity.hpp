// SPDX-License-Identifier: MIT
//
// Finds the sites and boundary subsegments near a place in a growing mesh, so that stars,
// visibility and encroachment test a few of them only. Follows the mesh's own lists; holds no
// copy.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/search/box_index.hpp"
#include "asterism/mesh/search/site_index.hpp"
#include "asterism/mesh/stars/boundary.hpp"

namespace asterism::internal {

class proximity {
 public:
  proximity() = default;
  // Indexes all sites and subsegments.
  proximity(const std::vector<site>& sites, const boundary& edges);

  const site_index& sites() const { return sites_; }
  const box_index& subsegments() const { return subsegments_; }
  // Returns the subsegments, indexed by the box of the sites that could encroach on them.
  const box_index& influences() const { return influences_; }
  // Returns the sites along a space-filling curve, those added later after all others.
  const std::vector<vertex_index>& order() const { return order_; }
  // Returns the numbers of the sites in their order along the space-filling curve; a few sites that
  // were added later may be at the end.
  // Loops in this order find what they read in the cache.
  std::vector<vertex_index> order_anew(const std::vector<site>& sites) const;
  // Returns the box around all sites; some may lie outside it by rounding.
  const bounding_box& box() const { return box_; }

  // Adds the new site sites[w].
  void add_site(const std::vector<site>& sites, vertex_index w) {
    sites_.insert(sites, w);
    order_.push_back(w);
  }
  // Follows a renumbering: the former site w is now site to[w].
  void renumber(const std::vector<vertex_index>& to) {
    sites_.renumber(to);
    for (vertex_index& w : order_) w = to[w];
  }
  // Removes a subsegment from the index, or adds its parts. Must be called before and after
  // edges.split(subsegment, ...). `twin` is the subsegment's twin, if any; `first_new` is the
  // number of subsegments before the split.
  void before_split(const std::vector<site>& sites, const boundary& edges, std::size_t subsegment);
  void after_split(const std::vector<site>& sites, const boundary& edges, std::size_t subsegment,
                   std::optional<std::size_t> twin, std::size_t first_new);

 private:
  void insert_subsegment(const std::vector<site>& sites, const boundary& edges,
                         std::size_t subsegment);
  void remove_subsegment(const std::vector<site>& sites, const boundary& edges,
                         std::size_t subsegment);

  bounding_box box_;
  std::vector<vertex_index> order_;
  std::size_t along_curve_ = 0;  // the first so many of these
  site_index sites_;
  box_index subsegments_, influences_;
};

}  // namespace asterism::internal
