// SPDX-License-Identifier: MIT
//
// Holds what all parts of the check of stars share: the sites in unit size, trees of them and of
// the subsegments, and the sites that changed since the audit before.
#pragma once

#include <optional>
#include <vector>

#include "asterism/mesh/audit/context.hpp"
#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/audit/subsegment_tree.hpp"

namespace asterism::internal::audit_detail {

struct star_surroundings {
  // The context must outlive this object.
  explicit star_surroundings(const audit_context& context);
  star_surroundings(const star_surroundings&) = delete;
  star_surroundings& operator=(const star_surroundings&) = delete;

  // True if an answer that depends on these sites may have changed.
  template <class... Vertices>
  bool concerns(Vertices... v) const {
    return is_changed.empty() || (is_changed[v] | ...);
  }

  // True if an answer about the star of v may have changed: v, or a corner of a triangle at v, has.
  bool concerns_star_of(vertex_index v) const { return is_near.empty() || is_near[v] != 0; }

  // Builds the tree of all sites, or takes that of the mesh's own sites unless they were scaled to
  // unit size.
  void plant(audit_context& context) {
    if (!unit.empty() && !of_unit) of_unit.emplace(unit);
    sites = unit.empty() ? &context.plant() : &*of_unit;
  }

  int power_of_squares = 0;     // of the factor of two of all squares of lengths in `at`
  std::vector<site> unit;       // empty where the sites are as they should be
  const std::vector<site>& at;  // those to ask about
  std::optional<site_tree> of_unit;
  const site_tree* sites = nullptr;
  std::vector<site> changed_list;  // the changed ones, in the context's order
  site_tree changed_sites;
  std::vector<char> is_changed;  // one flag a site; none where all is to be looked at
  std::vector<char> is_near;     // and of sites in a triangle with a changed one
  subsegment_tree subsegments;
};

}  // namespace asterism::internal::audit_detail
