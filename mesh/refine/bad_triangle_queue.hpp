// SPDX-License-Identifier: MIT
//
// Keeps the bad triangles of a mesh up to date, the worst first.
//
// A triangle is bad as in the thesis (section 4.1) when it disagrees, when an angle is below the
// bound from the perspective of any vertex, or, with a size limit, when it is too large. A wide gap
// of a star and the triangles of a star that did not settle count as disagreeing.
//
// Exempt from the angle bound is a domain corner's own angle, in metrics in which that angle is
// below the bound: no mesh meets the bound there. Another corner at the same vertex exempts
// nothing. Collateral are other low angles of triangles at such a corner, and those of triangles
// across a wedge below half the bound between two segments one of which is internal. All corners of
// a triangle across a wedge must be on these two segments, and the wedge's angle must be below the
// bound in the metric of each corner. Collateral triangles are bad only after demand_collateral():
// mending them may go on for ever (docs/math/refinement.md, "Corners"), so the rest is mended
// first.
//
// Examines a star again only when it, or a star it has triangles with, has changed.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <unordered_map>
#include <vector>

#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/refine/refine_state.hpp"
#include "asterism/mesh/stars/consistency.hpp"

namespace asterism::internal {

enum class badness { disagreeing, low_angle, too_large };

struct bad_triangle {
  badness why = badness::disagreeing;
  double rank = 0;  // smaller is worse: smallest angle in degrees, or minus the circumradius
  // Vertices of the triangle, counter-clockwise; for a wide gap they may repeat or run clockwise
  // (stars/consistency.hpp).
  triangle where{};

  friend bool operator<(const bad_triangle& a, const bad_triangle& b) {
    if (a.why != b.why) return a.why < b.why;
    if (a.rank != b.rank) return a.rank < b.rank;
    return a.where < b.where;
  }
};

class bad_triangle_queue {
 public:
  bad_triangle_queue(const refine_state& state, const angle_requirement& angle, bool limit_size);

  // Examines the stars touched since the last call, and those that depend on them.
  void update(refine_state& state);

  // Returns disagreeing triangles, then those with low angles, then large ones. Ties go by the
  // indices of the sites, so that the order is the same every time.
  const std::set<bad_triangle>& bad() const { return bad_; }
  // Returns the triangles at exempt corners with low angles elsewhere. Refinement tries to mend
  // them, but does not require it.
  const std::set<bad_triangle>& improvable() const { return improvable_; }
  // Returns the number of collateral triangles; those that must be mended count as bad instead.
  std::size_t collateral() const { return collateral_; }
  std::set<vertex_index> collateral_sites() const;
  // Makes collateral triangles bad from the next update on, except those beside the corners named.
  void demand_collateral(const std::set<vertex_index>& but_beside);
  // Returns the vertices of domain corners that have bad triangles with low angles beside them.
  std::set<vertex_index> corners_beside_low(const refine_state& state) const;
  std::size_t count(badness why) const { return counts_[static_cast<std::size_t>(why)]; }
  // Returns the triangles with an exempt angle below the bound in lexicographic order.
  std::vector<triangle> exempt() const;
  const std::vector<exempt_corner>& exempt_corners() const { return exempt_corners_; }

 private:
  // Bad triangles that one star reports.
  struct record {
    std::vector<triangle> disagreeing;  // may be found by several stars
    std::vector<bad_triangle> bad;      // low or large: by the star of the smallest index alone
    std::vector<bad_triangle> improvable;
    std::vector<triangle> exempt, collateral;
    std::vector<vertex_index> one_sided;  // neighbours that do not have the star's centre as theirs

    bool empty() const {
      return disagreeing.empty() && bad.empty() && improvable.empty() && exempt.empty() &&
             collateral.empty() && one_sided.empty();
    }
  };

  record examine(const refine_state& state, const star_predicates& kernel, vertex_index v) const;
  const domain_wedge* crossed_wedge(const refine_state& state, const triangle& t) const;
  bool judge_low(const refine_state& state, const site_oracle& oracle, const triangle& t,
                 record& into) const;
  void judge(const refine_state& state, const site_oracle& oracle, const triangle& t,
             record& into) const;
  void forget(vertex_index v);
  void remember(const refine_state& state, vertex_index v, record now);
  std::vector<vertex_index> dependents(refine_state& state);

  angle_requirement angle_;
  bool limit_size_;
  std::vector<exempt_corner> exempt_corners_;
  std::vector<domain_corner> corners_below_;  // the bound: a vertex may have wide ones beside them
  std::unordered_map<vertex_index, record> records_;        // those that are not empty
  std::map<triangle, std::pair<int, double>> disagreeing_;  // by how many stars, smallest angle
  std::unordered_map<vertex_index, std::vector<vertex_index>>
      claimed_by_;  // the other end of one_sided
  std::set<bad_triangle> bad_, improvable_;
  std::size_t counts_[3] = {0, 0, 0};
  std::size_t collateral_ = 0;
  bool demands_collateral_ = false;
  std::set<vertex_index> not_demanded_beside_;  // corners beside which it does not
  bool first_ = true;
};

// Returns the domain's corners below the bound, one for each vertex (its smallest), by vertex.
std::vector<exempt_corner> exempt_corners(const refine_state& state,
                                          const angle_requirement& angle);

triangle_sites sites_of(const refine_state& state, const triangle& t);

}  // namespace asterism::internal
