// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/split_edges.hpp"

#include <algorithm>
#include <cstddef>

namespace asterism::internal {

std::vector<std::array<vertex_index, 2>> edges_across(const mesh& m) {
  using edge = std::array<vertex_index, 2>;
  std::vector<edge> sides;
  sides.reserve(3 * m.triangles.size());
  for (const triangle& t : m.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const vertex_index a = t[i], b = t[(i + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b)});
    }
  std::sort(sides.begin(), sides.end());
  std::vector<char> is_outer(m.sites.size(), 0);
  std::vector<edge> inner;
  for (std::size_t i = 0; i < sides.size();) {
    const bool is_shared = i + 1 < sides.size() && sides[i + 1] == sides[i];
    if (is_shared)
      inner.push_back(sides[i]);
    else
      is_outer[sides[i][0]] = is_outer[sides[i][1]] = 1;
    i += is_shared ? 2 : 1;
  }
  std::erase_if(inner, [&](const edge& e) { return is_outer[e[0]] == 0 || is_outer[e[1]] == 0; });
  return inner;
}

}  // namespace asterism::internal
