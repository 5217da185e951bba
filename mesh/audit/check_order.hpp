// SPDX-License-Identifier: MIT
//
// Orders the stars that the auditor looks at.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal::audit_detail {

// The vertices in the order in which they are checked, and where groups of vertices near each other
// begin; one more for the end.
struct check_order {
  std::vector<vertex_index> vertices;
  std::vector<std::size_t> groups;
  std::size_t together = 1;  // groups that follow each other and are checked together
};

// Has the vertices of a leaf in one group, and those of some neighbouring leaves together.
check_order in_order_of_tree(const site_tree& sites);

// Returns the vertices in the order of their numbers, eight in a group.
check_order in_order_of_mesh(std::size_t vertices);

}  // namespace asterism::internal::audit_detail
