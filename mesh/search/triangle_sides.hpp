// SPDX-License-Identifier: MIT
//
// Finds the triangle on the left of a directed edge, and decides which edges lie between regions.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/sort_by_counting.hpp"

namespace asterism::internal {

// The directed edges of all triangles of a mesh, sorted by their ends. Made in O(n log n).
class triangle_sides {
 public:
  struct side {
    std::array<vertex_index, 2> ends;
    vertex_index triangle;  // on the left
  };

  explicit triangle_sides(const mesh& m) {
    resize_in_threads(sides_, 3 * m.triangles.size());
    vertex_index most = 0;
    for (const triangle& t : m.triangles) most = std::max({most, t[0], t[1], t[2]});
    if (sides_.empty()) return;
    // Distributes the sides by their first ends, then sorts the few of each.
    first_ = sort_by_counting(
        sides_.size(), std::size_t{most} + 1,
        [&m](std::size_t i) { return std::size_t{m.triangles[i / 3][i % 3]}; },
        [&](std::size_t at, std::size_t i) {
          const triangle& t = m.triangles[i / 3];
          sides_[at] = {{t[i % 3], t[(i + 1) % 3]}, static_cast<vertex_index>(i / 3)};
        });
    constexpr std::size_t vertices_at_once = 4096;  // for a thread
    parallel_chunks(first_.size() - 1, vertices_at_once,
                    [this](std::size_t, std::size_t begin, std::size_t end) {
                      for (std::size_t v = begin; v < end; ++v) sort_from(v);
                    });
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
  void sort_from(std::size_t v) {
    std::sort(sides_.data() + first_[v], sides_.data() + first_[v + 1],
              [](const side& p, const side& q) {
                return p.ends[1] != q.ends[1] ? p.ends[1] < q.ends[1] : p.triangle < q.triangle;
              });
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
