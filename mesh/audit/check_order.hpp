// SPDX-License-Identifier: MIT
//
// Orders the stars that the auditor checks, near ones together.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal::audit_detail {

// Vertices in the order in which they are checked, and the start of each group of vertices near
// each other, followed by the number of vertices.
struct check_order {
  std::vector<vertex_index> vertices;
  std::vector<std::size_t> groups;
  std::size_t together = 1;  // groups that follow each other and are checked together
};

// Returns the vertices in the order of the tree, with a group for each leaf. Two groups are checked
// together.
check_order in_order_of_tree(const site_tree& sites);

// Returns the vertices in the order of their numbers, eight in a group.
check_order in_order_of_mesh(std::size_t vertices);

}  // namespace asterism::internal::audit_detail
