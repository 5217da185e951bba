// SPDX-License-Identifier: MIT
#include "asterism/mesh/delivery/assign_regions.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace asterism::internal {

namespace {

// A directed edge and the triangle on its left.
struct triangle_side {
  std::array<vertex_index, 2> ends{};
  std::size_t triangle = 0;
  bool on_subsegment = false;
};

class region_spread {
 public:
  region_spread(const mesh& m, const domain& d) : regions_(m.triangles.size(), 0) {
    for (std::size_t t = 0; t < m.triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i)
        sides_.push_back({{m.triangles[t][i], m.triangles[t][(i + 1) % 3]}, t});
    std::sort(sides_.begin(), sides_.end(),
              [](const triangle_side& p, const triangle_side& q) { return p.ends < q.ends; });
    reached_.assign(m.triangles.size(), false);
    for (const boundary_edge& e : m.boundary) {
      const segment& s = d.segments[e.segment];
      start_at({e.a, e.b}, s.left_region);
      if (e.internal) start_at({e.b, e.a}, s.right_region);
    }
  }

  std::vector<int> run(const mesh& m) {
    while (!open_.empty()) {
      const std::size_t t = open_.back();
      open_.pop_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const triangle_side* across = side({m.triangles[t][(i + 1) % 3], m.triangles[t][i]});
        if (across != nullptr && !across->on_subsegment) reach(across->triangle, regions_[t]);
      }
    }
    return std::move(regions_);
  }

 private:
  triangle_side* side(const std::array<vertex_index, 2>& ends) {
    const auto at =
        std::lower_bound(sides_.begin(), sides_.end(), ends,
                         [](const triangle_side& s, const std::array<vertex_index, 2>& key) {
                           return s.ends < key;
                         });
    return at != sides_.end() && at->ends == ends ? &*at : nullptr;
  }

  void start_at(const std::array<vertex_index, 2>& ends, int region) {
    triangle_side* const beside = side(ends);
    if (beside == nullptr) return;
    beside->on_subsegment = true;
    reach(beside->triangle, region);
  }

  void reach(std::size_t t, int region) {
    if (reached_[t]) return;
    reached_[t] = true;
    regions_[t] = region;
    open_.push_back(t);
  }

  std::vector<triangle_side> sides_;  // sorted by their ends
  std::vector<int> regions_;
  std::vector<bool> reached_;
  std::vector<std::size_t> open_;
};

}  // namespace

void assign_regions(mesh& m, const domain& d) {
  m.regions.clear();
  const bool plain = std::all_of(d.segments.begin(), d.segments.end(), [](const segment& s) {
    return s.left_region == 1 && (!s.internal || s.right_region == 1);
  });
  if (!plain) m.regions = region_spread(m, d).run(m);
}

}  // namespace asterism::internal
