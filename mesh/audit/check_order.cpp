// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/check_order.hpp"

#include <numeric>

namespace asterism::internal::audit_detail {

// Checks the stars of two leaves together: of one, two and four leaves, tried on a random mesh with
// 160,000 sites, two took the least time.
check_order in_order_of_tree(const site_tree& sites) {
  constexpr std::size_t together = 2;
  return {sites.order(), sites.groups(), together};
}

check_order in_order_of_mesh(std::size_t vertices) {
  constexpr std::size_t together = 8;
  check_order order;
  order.vertices.resize(vertices);
  std::iota(order.vertices.begin(), order.vertices.end(), vertex_index{0});
  for (std::size_t first = 0; first < vertices; first += together) order.groups.push_back(first);
  order.groups.push_back(vertices);
  return order;
}

}  // namespace asterism::internal::audit_detail
