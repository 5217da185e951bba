// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/consistency.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "asterism/mesh/stars/canonical_triangle.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/sort_unique.hpp"

namespace asterism::internal {
namespace {

class checker {
 public:
  checker(const site_oracle& oracle, const star_set& stars) : oracle_(oracle), stars_(stars) {}

  consistency_report run() {
    for (vertex_index v = 0; v < stars_.size(); ++v) check_star(v);
    for (auto* list : {&report_.agreeing, &report_.disagreeing}) {
      sort_unique(*list);
    }
    return std::move(report_);
  }

 private:
  void check_star(vertex_index v) {
    if (stars_.is_unsettled(v))
      report_.defects.push_back({defect_kind::unsettled, v, v, {v, v, v}});
    for (const sector& s : stars_[v].sectors) {
      if (s.neighbours.empty()) report_.defects.push_back({defect_kind::wide_gap, v, v, {v, v, v}});
      for (std::size_t gap = 0; gap < s.gaps(); ++gap) {
        const triangle t{v, s.neighbours[gap], s.neighbours[s.after(gap)]};
        if (holds_triangle(oracle_, v, s, gap))
          check_triangle(t);
        else
          report_.defects.push_back({defect_kind::wide_gap, v, v, t});
      }
    }
  }

  void check_triangle(const triangle& t) {
    const auto [v, y, x] = t;
    const bool with_y = confirm(t, y, {y, x, v}), with_x = confirm(t, x, {x, v, y});
    if (with_y && with_x) {
      if (v < y && v < x) report_.agreeing.push_back(t);
    } else {
      report_.disagreeing.push_back(canonical(t));
    }
  }

  // True if the star of `other` has triangle t; otherwise reports the defect. `seen_from_other` is
  // t turned so that it starts at `other`.
  bool confirm(const triangle& t, vertex_index other, const triangle& seen_from_other) {
    const star& s = stars_[other];
    if (has_triangle(oracle_, other, s, seen_from_other[1], seen_from_other[2])) return true;
    const auto kind = s.contains(t[0]) ? defect_kind::missing_triangle : defect_kind::missing_edge;
    report_.defects.push_back({kind, t[0], other, t});
    return false;
  }

  const site_oracle& oracle_;
  const star_set& stars_;
  consistency_report report_;
};

// Calls visit(t) for each triangle of v's star of which v is the first corner.
template <class Visit>
void visit_own_triangles(const star_set& stars, vertex_index v, const Visit& visit) {
  for (const sector& s : stars[v].sectors)
    for (std::size_t gap = 0; gap < s.gaps(); ++gap) {
      const vertex_index y = s.neighbours[gap], x = s.neighbours[s.after(gap)];
      if (v < y && v < x) visit(triangle{v, y, x});
    }
}

}  // namespace

std::vector<triangle> triangles_of_consistent(const star_set& stars) {
  constexpr std::size_t chunk = 1024;
  std::vector<std::size_t> first(chunk_count(stars.size(), chunk) + 1, 0);
  parallel_chunks(stars.size(), chunk, [&](std::size_t i, std::size_t begin, std::size_t end) {
    for (auto v = static_cast<vertex_index>(begin); v < end; ++v)
      visit_own_triangles(stars, v, [&](const triangle&) { ++first[i + 1]; });
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<triangle> all(first.back());
  parallel_chunks(stars.size(), chunk, [&](std::size_t i, std::size_t begin, std::size_t end) {
    auto next = all.begin() + static_cast<std::ptrdiff_t>(first[i]);
    for (auto v = static_cast<vertex_index>(begin); v < end; ++v) {
      const auto first_of_star = next;
      visit_own_triangles(stars, v, [&](const triangle& t) { *next++ = t; });
      std::sort(first_of_star, next);
    }
  });
  return all;
}

consistency_report check_consistency(const site_oracle& oracle, const star_set& stars) {
  return checker(oracle, stars).run();
}

}  // namespace asterism::internal
