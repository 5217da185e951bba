// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/star_pairs.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal::proof_detail {
namespace {

constexpr std::size_t most_met = 100000;

const site& site_at(const plane& all, vertex_index v) { return all.subject.sites[v]; }

sign turn_of(const plane& all, vertex_index a, vertex_index b, vertex_index c) {
  return filtered_kernel().orientation(all.position(a), all.position(b), all.position(c));
}

// Finds the triangles that the ball of a site meets, from the site outward.
class ball_walk {
 public:
  ball_walk(const plane& all, double squared_radius) : all_(all), squared_(squared_radius) {}

  // Fails if the ball meets the border of the rectangle, or more than `most_met` triangles.
  std::optional<error> run(vertex_index w) {
    met_.assign(all_.at.begin() + all_.at_start[w], all_.at.begin() + all_.at_start[w + 1]);
    for (std::size_t i = 0; i < met_.size(); ++i) {
      if (met_.size() > most_met) return failure(w, " meets too many triangles");
      for (std::uint32_t e = 3 * met_[i]; e < 3 * met_[i] + 3; ++e) {
        const vertex_index a = all_.corner(e), b = all_.corner(plane::next(e));
        if (a == w || b == w) continue;
        const std::uint32_t reverse = all_.across[e];
        const bool is_new = reverse == plane::none || !is_met(reverse / 3);
        if (!is_new || misses(w, a, b)) continue;
        if (reverse == plane::none) return failure(w, " meets the rim of the rectangle");
        met_.push_back(reverse / 3);
      }
    }
    return std::nullopt;
  }
  const std::vector<std::uint32_t>& met() const { return met_; }

 private:
  bool is_met(std::uint32_t t) const {
    return std::find(met_.begin(), met_.end(), t) != met_.end();
  }
  bool misses(vertex_index w, vertex_index a, vertex_index b) const {
    const site& from = site_at(all_, w);
    return decide([&](auto zero) {
      using number = decltype(zero);
      return is_out_of_reach(tensor<number>(from.metric),
                             way<number>(from.position, all_.position(a)),
                             way<number>(from.position, all_.position(b)), number(squared_));
    });
  }
  static error failure(vertex_index w, const char* what) {
    return {"the ball around vertex " + std::to_string(std::size_t{w} + 1) + what,
            error_code::invalid_mesh};
  }

  const plane& all_;
  double squared_;
  std::vector<std::uint32_t> met_;
};

// A gap whose region is not within its own triangle, and another triangle that the region may meet.
struct listing {
  std::uint32_t triangle = 0, gap = 0;

  friend bool operator<(const listing& l, const listing& r) {
    return l.triangle < r.triangle || (l.triangle == r.triangle && l.gap < r.gap);
  }
};

// True if the point, which is beyond the edge from x to y, is in the triangle on that edge's other
// side.
bool is_in_triangle_behind(const plane& all, std::uint32_t gap, const grid_point& q) {
  const std::uint32_t behind = all.across[plane::next(gap)];
  const gap_sites g = sites_of_gap(all, gap);
  const point& apex = all.position(all.corner(plane::previous(behind)));
  return decide([&](auto zero) {
    using number = decltype(zero);
    const vector2<number> x = way<number>(g.v.position, g.x.position),
                          y = way<number>(g.v.position, g.y.position),
                          d = way<number>(g.v.position, apex), at = place<number>(q, x, y);
    return reaches_zero(cross(d - x, at - x)) & reaches_zero(cross(y - d, at - d));
  });
}

// Triangles that contain the region of a gap's row: its own one; it and the one on the other side
// of the edge from x to y; or any.
enum class extent { own, behind, far };

extent extent_of(const plane& all, const gap_rows& gaps, std::uint32_t gap) {
  const proof_gap& row = gaps.plain(gap);
  if (row.on_x == 0 || row.on_x > grid_size || row.on_y > grid_size) return extent::far;
  const grid_point q = as_grid_point(row.between);
  if (q.a + q.b <= grid_size) return extent::own;
  return is_in_triangle_behind(all, gap, q) ? extent::behind : extent::far;
}

class pair_check {
 public:
  pair_check(const plane& all, const gap_rows& gaps, double squared_radius,
             const pair_question& ask)
      : all_(all), gaps_(gaps), squared_(squared_radius), ask_(ask) {}

  std::optional<error> run() {
    if (auto failed = list_gaps()) return failed;
    constexpr std::size_t chunk = 512;
    const std::size_t sites = all_.subject.sites.size();
    std::vector<std::optional<error>> failed(chunk_count(sites, chunk));
    parallel_chunks(sites, chunk, [&](std::size_t nth, std::size_t begin, std::size_t end) {
      ball_walk walk(all_, squared_);
      for (std::size_t w = begin; w < end && !failed[nth]; ++w)
        failed[nth] = hold(walk, static_cast<vertex_index>(w));
    });
    for (auto& one : failed)
      if (one) return one;
    return std::nullopt;
  }

 private:
  // Lists each gap by the triangles, other than its own, that its region may meet: by none if its
  // own triangle contains the region, by the triangle behind the gap if that and its own contain
  // it, else by all triangles that the ball of the gap's centre meets.
  std::optional<error> list_gaps() {
    ball_walk walk(all_, squared_);
    for (std::uint32_t gap = 0; gap < gaps_.size(); ++gap) {
      if (!is_gap_asked(all_, gap)) continue;
      const extent reach = extent_of(all_, gaps_, gap);
      if (reach == extent::behind) listings_.push_back({all_.across[plane::next(gap)] / 3, gap});
      if (reach != extent::far) continue;
      if (auto failed = walk.run(all_.corner(gap))) return failed;
      for (const std::uint32_t t : walk.met())
        if (t != gap / 3) listings_.push_back({t, gap});
    }
    std::sort(listings_.begin(), listings_.end());
    return std::nullopt;
  }

  std::optional<error> hold(ball_walk& walk, vertex_index w) const {
    if (auto failed = walk.run(w)) return failed;
    for (const std::uint32_t t : walk.met()) {
      if (t < all_.inner_count())
        for (std::uint32_t gap = 3 * t; gap < 3 * t + 3; ++gap)
          if (!is_settled(gap, w)) return failure(gap, w);
      for (auto l = std::lower_bound(listings_.begin(), listings_.end(), listing{t, 0});
           l != listings_.end() && l->triangle == t; ++l)
        if (!is_settled(l->gap, w)) return failure(l->gap, w);
    }
    return std::nullopt;
  }

  bool is_settled(std::uint32_t gap, vertex_index w) const {
    const vertex_index v = all_.corner(gap), x = all_.corner(gap, 1), y = all_.corner(gap, 2);
    if (w == v || w == x || w == y || !is_gap_asked(all_, gap)) return true;
    if (turn_of(all_, v, x, w) != sign::positive || turn_of(all_, y, v, w) != sign::positive)
      return true;
    const gap_sites g = sites_of_gap(all_, gap);
    const site& other = site_at(all_, w);
    if (have_one_metric(g.v, g.x, g.y, other)) return !is_kept_in_one_metric(g.v, other, g.x, g.y);
    if (is_refused_by_row(gap, other)) return true;
    const std::uint32_t opposite = all_.across[plane::next(gap)];
    if (opposite != plane::none && opposite / 3 < all_.inner_count() &&
        all_.corner(plane::previous(opposite)) == w) {
      const std::uint32_t back = plane::previous(opposite);
      if (is_refused_by_row(back, g.v)) return true;
    }
    return ask_(gap, w);
  }

  bool is_refused_by_row(std::uint32_t gap, const site& w) const {
    return gaps_.with(gap,
                      [&](const gap_row& row) { return refuses(sites_of_gap(all_, gap), row, w); });
  }

  error failure(std::uint32_t gap, vertex_index w) const {
    return {"the gap at vertex " + std::to_string(std::size_t{all_.corner(gap)} + 1) +
                " of triangle " + std::to_string(gap / 3 + 1) + " is not shown to refuse vertex " +
                std::to_string(std::size_t{w} + 1),
            error_code::invalid_mesh};
  }

  const plane& all_;
  const gap_rows& gaps_;
  double squared_;
  const pair_question& ask_;
  std::vector<listing> listings_;
};

}  // namespace

gap_sites sites_of_gap(const plane& all, std::uint32_t gap) {
  return {site_at(all, all.corner(gap)), site_at(all, all.corner(gap, 1)),
          site_at(all, all.corner(gap, 2))};
}

edge_sites sites_of_edge(const plane& all, std::uint32_t edge) {
  return {site_at(all, all.corner(edge)), site_at(all, all.corner(edge, 1)),
          site_at(all, all.corner(plane::previous(all.across[edge]))),
          site_at(all, all.corner(edge, 2))};
}

bool is_edge_asked(const plane& all, std::uint32_t edge) {
  const std::uint32_t reverse = all.across[edge];
  if (reverse == plane::none || reverse < edge || all.is_segment[edge] ||
      reverse / 3 >= all.inner_count())
    return false;
  const vertex_index v = all.corner(edge), w = all.corner(edge, 1), y = all.corner(edge, 2),
                     x = all.corner(plane::previous(reverse));
  const auto asks = [&](vertex_index from, vertex_index to, vertex_index before,
                        vertex_index after) {
    return turn_of(all, from, before, after) == sign::positive &&
           turn_of(all, before, after, to) != sign::positive;
  };
  return asks(v, w, x, y) || asks(w, v, y, x);
}

bool has_one_metric(const mesh& subject) {
  return std::all_of(subject.sites.begin(), subject.sites.end(),
                     [&](const site& s) { return s.metric == subject.sites.front().metric; });
}

std::optional<error> check_pairs(const plane& all, const gap_rows& gaps, double squared_radius,
                                 const pair_question& ask) {
  return pair_check(all, gaps, squared_radius, ask).run();
}

}  // namespace asterism::internal::proof_detail
