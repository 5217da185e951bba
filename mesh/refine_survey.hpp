// SPDX-License-Identifier: MIT
//
// What is still wrong with a mesh: its bad triangles, the worst first.
//
// Bad is what the thesis (section 4.1) calls bad: a disagreeing triangle, an angle below the bound
// from the perspective of any vertex, or, with a size limit, a triangle too large. A wide gap of a
// star and the triangles of a star that did not settle count as disagreeing.
// Exempt from the angle bound, and listed, are triangles at a corner of the domain whose own angle
// is below it: no mesh meets the bound there.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/mesh/consistency.hpp"
#include "asterism/mesh/refine_quality.hpp"
#include "asterism/mesh/refine_state.hpp"

namespace asterism {

enum class badness { disagreeing, low_angle, too_large };

struct bad_triangle {
  badness why = badness::disagreeing;
  double rank = 0;  // within its kind, smaller is worse: the smallest angle, or minus the size
  // Counter-clockwise; for a wide gap the indices may repeat or run clockwise (consistency.hpp).
  triangle where{};
};

// What there is to know of a triangle's shape; it never changes, as its sites never do.
struct triangle_shape {
  bool is_low = false;
  double smallest_angle = 0;  // measured only when is_low
  double circumradius = 0;    // metric_circumradius; measured only with a size limit
};

struct survey {
  consistency_report consistency;
  std::vector<triangle_shape> shapes;  // of consistency.agreeing, in its order
  std::vector<bad_triangle> bad;       // disagreeing, then low angles, then large; deterministic
  std::size_t disagreeing = 0, low_angle = 0, too_large = 0;
  std::vector<triangle> exempt;
  // Those of them that are low elsewhere than at the exempt corner: worth trying, not demanded.
  std::vector<bad_triangle> improvable;
};

// `previous` saves measuring what has not changed since: a survey of the same state, taken earlier
// with the same requirement and limit, or an empty one.
survey take_survey(const refine_state& state, const angle_requirement& angle, bool limit_size,
                   const survey& previous);

// The domain's corners below the bound, one for each vertex (its smallest), by vertex.
std::vector<exempt_corner> exempt_corners(const refine_state& state,
                                          const angle_requirement& angle);

triangle_sites sites_of(const refine_state& state, const triangle& t);

}  // namespace asterism
