// SPDX-License-Identifier: MIT
//
// Finds the triangle on the left of a directed edge, and tells which edges lie between regions.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// The directed edges of all triangles of a mesh, sorted by their ends. O(n log n) to make.
class triangle_sides {
 public:
  struct side {
    std::array<vertex_index, 2> ends;
    vertex_index triangle;  // on the left
  };

  explicit triangle_sides(const mesh& m) {
    sides_.reserve(3 * m.triangles.size());
    for (vertex_index t = 0; t < m.triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i)
        sides_.push_back({{m.triangles[t][i], m.triangles[t][(i + 1) % 3]}, t});
    std::sort(sides_.begin(), sides_.end(), [](const side& p, const side& q) {
      return p.ends != q.ends ? p.ends < q.ends : p.triangle < q.triangle;
    });
  }

  const std::vector<side>& all() const { return sides_; }

  // Returns null where no triangle is on the left of a -> b.
  const side* find(vertex_index a, vertex_index b) const {
    const std::array ends{a, b};
    const auto at = std::lower_bound(sides_.begin(), sides_.end(), ends,
                                     [](const side& s, const auto& key) { return s.ends < key; });
    return at != sides_.end() && at->ends == ends ? &*at : nullptr;
  }

  // Calls act(b) for each side a -> b.
  template <class Act>
  void each_from(vertex_index a, const Act& act) const {
    auto at = std::lower_bound(sides_.begin(), sides_.end(), a,
                               [](const side& s, vertex_index key) { return s.ends[0] < key; });
    for (; at != sides_.end() && at->ends[0] == a; ++at) act(at->ends[1]);
  }

  // True if triangles of different regions are on the two sides of the edge. `regions` has one for
  // each triangle, or is empty.
  bool divides_regions(const std::vector<int>& regions, vertex_index a, vertex_index b) const {
    if (regions.empty()) return false;
    const side *const left = find(a, b), *const right = find(b, a);
    return left != nullptr && right != nullptr &&
           regions[left->triangle] != regions[right->triangle];
  }

 private:
  std::vector<side> sides_;
};

}  // namespace asterism::internal
