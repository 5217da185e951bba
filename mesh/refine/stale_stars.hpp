// SPDX-License-Identifier: MIT
//
// Makes stars anew during refinement: stale ones, and those that a local search may have made
// wrongly.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "asterism/mesh/refine/bad_triangle_queue.hpp"
#include "asterism/mesh/refine/refine_state.hpp"
#include "asterism/mesh/refine/steepness.hpp"

namespace asterism::internal {

// Makes stars anew. Each function that makes stars returns true if a star changed.
class stale_stars {
 public:
  // Both references must outlive the object.
  stale_stars(refine_state& state, steepness& steep) : state_(state), steep_(steep) {}

  // Makes the stars in disagreeing triangles anew, offers their corners each other's neighbours,
  // and tests them against all sites, before a site is inserted there. Coarse stars keep neighbours
  // they should not have, and local searches miss some.
  bool rebuild_disagreeing(const bad_triangle_queue& queue);
  bool rebuild_all();
  // Tests every star against all sites that are not certainly out of its reach, since a local
  // search can have missed some. Does so once for each number of sites; sites that a star was
  // tested against need not be tested again when others are added.
  bool repair();
  // Lets rebuild_disagreeing() test stars against all sites once more before refinement gives up.
  // Returns false if it has tested them against the present sites already.
  bool confirm_again();

  // Returns the number of stars that repair() changed.
  std::size_t repairs() const { return repairs_; }

 private:
  bool rebuild(std::vector<vertex_index> stale, star_search search);
  bool exchange(const std::vector<triangle>& disagreeing);

  refine_state& state_;
  steepness& steep_;
  std::set<triangle>
      exchanged_;  // triangles whose corners were asked about each other's neighbours
  std::size_t repairs_ = 0;
  std::size_t repaired_at_ = 0, confirmed_at_ = 0;  // numbers of sites
};

}  // namespace asterism::internal
