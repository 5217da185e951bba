// SPDX-License-Identifier: MIT
//
// The order in which the auditor looks at the stars.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal::audit_detail {

// The vertices in the order in which they are checked, and where groups of them begin that are
// near each other; one more for the end.
struct check_order {
  std::vector<vertex_index> vertices;
  std::vector<std::size_t> groups;
  std::size_t together = 1;  // groups that follow each other and are checked together
};

// Has the vertices of a leaf in one group, and those of some neighbouring leaves together.
check_order in_order_of_tree(const site_tree& sites);

// Has a few vertices that follow each other in one group.
check_order in_order_of_mesh(std::size_t vertices);

// Leaves out what is not flagged; one flag a vertex.
check_order part_of(const check_order& all, const std::vector<char>& flags);

}  // namespace asterism::internal::audit_detail
