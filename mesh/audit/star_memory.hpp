// SPDX-License-Identifier: MIT
//
// Holds what an audit of a mesh passes to the next one about its stars. Internal to the library.
#pragma once

#include <array>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Open question about a star: whether it accepts a neighbour, as it should, or another site, as it
// should not, or any other site in a gap of unknown reach.
struct open_question {
  enum class about { neighbour, other_site, gap };

  // The centre of the star; the site, of a gap the centre again; the neighbours before and after
  // it.
  std::array<vertex_index, 4> sites;
  about what;
};

struct star_memory {
  std::vector<open_question> open;  // questions that are left
  // How far each site's star reaches, in its own metric; empty where that is not known.
  std::vector<double> reaches;
  // Power of the factor of two of squares of these lengths: a metric of very large numbers is asked
  // about in other units, which depend on the largest.
  int power_of_squares = 0;
};

}  // namespace asterism::internal
