// SPDX-License-Identifier: MIT
//
// Proposes changes that might make a finished mesh better: sites no triangle needs are left out,
// others move to where the triangles around them have a better shape.
//
// Judges in plain doubles on the triangles as they are, so that it is a proposal and nothing more.
// Refinement starts from it and finds out whether the stars of what is left agree.
#pragma once

#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/fill/fill.hpp"

namespace asterism::internal {

struct improvement_goal {
  double least_angle = 0;   // degrees; of the triangles that fill the hole a site leaves
  double mean_quality = 0;  // of the whole mesh, as it is
  double largest_radius =
      0;  // their metric circumradius (numerics/triangle_quality.hpp); may be infinite
};

struct improvement_proposal {
  filled_domain filling;  // for refine_state::start
  // Sites to leave out, the greatest gain first, and sites to move, by number. Both are numbered as
  // in the mesh the proposal was made from.
  std::vector<vertex_index> removed, moved;
  // Places proposed for the sites of that mesh, one for each; for a removed site where it was.
  std::vector<point> places;

  bool changes_nothing() const { return removed.empty() && moved.empty(); }
};

// Proposes sites to remove and to move. `m` must be complete, and `segments` the number of its
// domain's. Given sites and those on the boundary stay, and so do those with `barred[v]` not zero.
// No two sites with a common edge are removed. No site moves to where the field fails. Returns the
// same for any number of threads.
improvement_proposal propose_improvement(const mesh& m, std::size_t segments,
                                         const metric_field& field, const improvement_goal& goal,
                                         const std::vector<char>& barred);

}  // namespace asterism::internal
