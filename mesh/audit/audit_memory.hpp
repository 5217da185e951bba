// SPDX-License-Identifier: MIT
//
// Holds what an audit of a mesh passes to the next one: about its stars, their reaches and open
// questions; and what was checked of the triangulation and of its angles. Internal to the library.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

namespace audit_detail {
class checked_triangulation;
class site_tree;
}  // namespace audit_detail

// Kind of an open question about a star: whether it accepts a neighbour, as it should; whether it
// accepts another site, as it should not; or any site at all, in a gap of unknown reach.
struct open_question {
  enum class about { neighbour, other_site, gap };

  // Vertices of the question: the centre of the star; the site in question, for a gap the centre
  // again; the neighbours before and after it.
  std::array<vertex_index, 4> sites;
  about what;
};

struct audit_memory {
  std::vector<open_question> open;  // questions that are left
  // Reach of each site's star, in the site's own metric; empty where reaches are not known.
  std::vector<double> reaches;
  // Exponent of the power of two by which the squares of these reaches are scaled: stars of very
  // large metrics are checked in other units, which depend on the largest number.
  int power_of_squares = 0;
  // The triangulation, if all checks of it that no tensor affects are passed; else null.
  std::shared_ptr<audit_detail::checked_triangulation> triangulation;
  // Tree of the triangulation's sites, with their metrics; null where none was needed.
  std::shared_ptr<audit_detail::site_tree> tree;
  // Bound of the angles of each of its triangles (audit_context::angle_bounds); may be empty.
  std::vector<double> angle_bounds;
};

}  // namespace asterism::internal
