// SPDX-License-Identifier: MIT
//
// What might make a finished mesh better: sites no triangle needs are left out, others move to
// where the triangles around them have a better shape.
//
// Judged in plain doubles on the triangles as they are, so it is a proposal and nothing more:
// whether the stars of what is left agree is for refinement to find out, which starts from it.
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
  // Sites of the mesh it was made from: those that go, the most useful first, and by number those
  // that move.
  std::vector<vertex_index> removed, moved;
  // Of every site of that mesh, where it is to be; for the removed ones where it was.
  std::vector<point> places;

  bool changes_nothing() const { return removed.empty() && moved.empty(); }
};

// `m` must be complete, and `segments` the number of its domain's. Given sites and those on the
// boundary stay, and so do those with `barred[v]` not zero. No two sites with a common edge are
// removed. The same for any number of threads. Where the field fails a site does not go.
improvement_proposal propose_improvement(const mesh& m, std::size_t segments,
                                         const metric_field& field, const improvement_goal& goal,
                                         const std::vector<char>& barred);

}  // namespace asterism::internal
