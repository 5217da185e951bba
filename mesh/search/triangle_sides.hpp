// SPDX-License-Identifier: MIT
//
// Finds the triangle on the left of a directed edge, and decides which edges lie between regions.
#pragma once

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// The directed edges of all triangles of a mesh, sorted by their ends. Made in O(n log n).
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
    tbb::parallel_sort(sides_.begin(), sides_.end(), [](const side& p, const side& q) {
      return key(p.ends) != key(q.ends) ? key(p.ends) < key(q.ends) : p.triangle < q.triangle;
    });
    if (sides_.empty()) return;
    first_.assign(std::size_t{sides_.back().ends[0]} + 2, 0);
    for (const side& s : sides_) ++first_[s.ends[0] + std::size_t{1}];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  }

  const std::vector<side>& all() const { return sides_; }

  // Returns null where no triangle is on the left of a -> b.
  const side* find(vertex_index a, vertex_index b) const {
    const auto from_a = from(a);
    const auto at =
        std::find_if(from_a.begin(), from_a.end(), [b](const side& s) { return s.ends[1] >= b; });
    return at != from_a.end() && at->ends[1] == b ? &*at : nullptr;
  }

  // Calls act(b) for each side a -> b.
  template <class Act>
  void each_from(vertex_index a, const Act& act) const {
    for (const side& s : from(a)) act(s.ends[1]);
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
  static std::uint64_t key(const std::array<vertex_index, 2>& ends) {
    return std::uint64_t{ends[0]} << 32U | ends[1];
  }
  // Returns the sides that begin at a vertex.
  std::span<const side> from(vertex_index a) const {
    if (std::size_t{a} + 1 >= first_.size()) return {};
    return std::span(sides_).subspan(first_[a], first_[a + std::size_t{1}] - first_[a]);
  }

  std::vector<side> sides_;
  std::vector<std::size_t> first_;  // of each vertex
};

}  // namespace asterism::internal
