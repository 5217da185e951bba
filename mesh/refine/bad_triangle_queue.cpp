// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/bad_triangle_queue.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "asterism/mesh/stars/canonical_triangle.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/sort_unique.hpp"

namespace asterism::internal {
namespace {

// True if the triangle v, y, x lies in the corner c of the domain at v. Both turn by less than 180
// degrees.
bool lies_in(const site_oracle& oracle, const domain_corner& c, vertex_index v, vertex_index y,
             vertex_index x) {
  const boundary_corner ends = oracle.edges().corners(v)[c.sector];
  return oracle.orientation(v, ends.first, y) != sign::negative &&
         oracle.orientation(v, x, ends.last) != sign::negative &&
         oracle.orientation(v, y, ends.last) == sign::positive;
}

// Corners of the domain that contain the corners of a triangle; null where none does.
using corners_of_domain = std::array<const domain_corner*, 3>;

// Returns the domain corners that contain the triangle's corners. `list` is sorted by vertex.
corners_of_domain corners_in(const site_oracle& oracle, const triangle& t,
                             const std::vector<domain_corner>& corners) {
  corners_of_domain in{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [first, last] = std::equal_range(
        corners.begin(), corners.end(), domain_corner{t[i], 0, 0},
        [](const domain_corner& a, const domain_corner& b) { return a.vertex < b.vertex; });
    const auto found = std::find_if(first, last, [&](const domain_corner& c) {
      return lies_in(oracle, c, t[i], t[(i + 1) % 3], t[(i + 2) % 3]);
    });
    if (found != last) in[i] = &*found;
  }
  return in;
}

// Marks, in all three metrics, the angles of the triangle that fill a whole corner of the domain,
// from one subsegment to the other. Where edges divide the corner, other edges could give it wider
// parts.
angle_set unavoidable(const boundary& edges, const triangle& t, const corners_of_domain& in) {
  angle_set at;
  for (std::size_t i = 0; i < 3; ++i)
    if (in[i] != nullptr && edges.is_subsegment(t[i], t[(i + 1) % 3]) &&
        edges.is_subsegment(t[(i + 2) % 3], t[i]))
      at.which[i].fill(true);
  return at;
}

// Returns the angles that the auditor exempts: angles at these domain corners, in metrics in which
// the domain's own angle there is below the bound. Errors can only make the set smaller.
angle_set exempt_angles(const refine_state& state, const triangle& t, const corners_of_domain& in,
                        double bound) {
  constexpr double guard = 1 - 1e-9;
  angle_set exempt;
  for (std::size_t i = 0; i < 3; ++i) {
    if (in[i] == nullptr) continue;
    const std::vector<site>& sites = state.sites();
    const boundary_corner ends = state.edges().corners(t[i])[in[i]->sector];
    for (std::size_t j = 0; j < 3; ++j)
      exempt.which[i][j] =
          corner_angle({sites[t[i]].position, sites[t[j]].metric}, sites[ends.first].position,
                       sites[ends.last].position) < guard * bound;
  }
  return exempt;
}

// Returns the cost of comparing the star of v with its neighbours' stars, in neighbours visited:
// the square of a degree where vertices of high degree are neighbours.
std::size_t neighbours_of_neighbours(const star_set& stars, vertex_index v) {
  std::size_t all = 0;
  for (const sector& s : stars[v].sectors)
    for (const vertex_index u : s.neighbours)
      for (const sector& of_u : stars[u].sectors) all += of_u.size();
  return all;
}

angle_set all_but(angle_set angles) {
  for (auto& corner : angles.which)
    for (bool& angle : corner) angle = !angle;
  return angles;
}

}  // namespace

triangle_sites sites_of(const refine_state& state, const triangle& t) {
  return {state.sites()[t[0]], state.sites()[t[1]], state.sites()[t[2]]};
}

std::vector<exempt_corner> exempt_corners(const refine_state& state,
                                          const angle_requirement& angle) {
  std::map<vertex_index, double> smallest;
  for (const domain_corner& c : state.segments().corners()) {
    if (!(c.angle < angle.degrees())) continue;
    const auto [at, added] = smallest.try_emplace(c.vertex, c.angle);
    if (!added) at->second = std::min(at->second, c.angle);
  }
  std::vector<exempt_corner> corners;
  corners.reserve(smallest.size());
  for (const auto& [vertex, degrees] : smallest) corners.push_back({vertex, degrees});
  return corners;
}

bad_triangle_queue::bad_triangle_queue(const refine_state& state, const angle_requirement& angle,
                                       bool limit_size)
    : angle_(angle),
      limit_size_(limit_size),
      exempt_corners_(asterism::internal::exempt_corners(state, angle)) {
  for (const domain_corner& c : state.segments().corners())
    if (c.angle < angle.degrees()) corners_below_.push_back(c);
}

std::vector<triangle> bad_triangle_queue::exempt() const {
  std::vector<triangle> all;
  for (const auto& [v, r] : records_) all.insert(all.end(), r.exempt.begin(), r.exempt.end());
  std::sort(all.begin(), all.end());
  return all;
}

void bad_triangle_queue::demand_collateral(const std::set<vertex_index>& but_beside) {
  demands_collateral_ = true;
  not_demanded_beside_ = but_beside;
  first_ = true;  // all is judged anew
}

std::set<vertex_index> bad_triangle_queue::collateral_sites() const {
  std::set<vertex_index> all;
  for (const auto& [v, r] : records_)
    for (const triangle& t : r.collateral) all.insert(t.begin(), t.end());
  return all;
}

std::set<vertex_index> bad_triangle_queue::corners_beside_low(const refine_state& state) const {
  std::set<vertex_index> all;
  for (const bad_triangle& b : bad_) {
    if (b.why != badness::low_angle) continue;
    for (const domain_corner* c : corners_in(state.oracle(), b.where, corners_below_))
      if (c != nullptr) all.insert(c->vertex);
    if (const domain_wedge* w = crossed_wedge(state, b.where)) all.insert(w->corner.vertex);
  }
  return all;
}

// Returns the wedge, below half the bound and with an internal segment, whose two segments hold all
// corners of the triangle; null if there is none.
const domain_wedge* bad_triangle_queue::crossed_wedge(const refine_state& state,
                                                      const triangle& t) const {
  const auto accepts = [&](const domain_wedge& w) {
    return w.internal && is_narrower(state.sites(), w, w.corner.vertex, angle_.degrees() / 2) &&
           std::all_of(t.begin(), t.end(), [&](vertex_index v) {
             return is_narrower(state.sites(), w, v, angle_.degrees());
           });
  };
  return state.segments().wedges().across(t, accepts);
}

// Records a triangle with a low angle, as exempt, bad or collateral. Returns true if it is
// bad.
bool bad_triangle_queue::judge_low(const refine_state& state, const site_oracle& oracle,
                                   const triangle& t, record& into) const {
  const triangle_sites sites = sites_of(state, t);
  const bad_triangle low{badness::low_angle, smallest_angle(sites), t};
  const corners_of_domain in = corners_in(oracle, t, corners_below_);
  const bool at_corner = in[0] != nullptr || in[1] != nullptr || in[2] != nullptr;
  const angle_set exempt = exempt_angles(state, t, in, angle_.degrees());
  if (at_corner && angle_.is_low(sites, all_but(exempt))) into.exempt.push_back(t);
  if (angle_.is_low(sites, exempt)) {
    const domain_wedge* const wedge = at_corner ? nullptr : crossed_wedge(state, t);
    const auto spares = [&](const domain_corner* c) {
      return c != nullptr && not_demanded_beside_.contains(c->vertex);
    };
    const bool is_left = std::any_of(in.begin(), in.end(), spares) ||
                         (wedge != nullptr && not_demanded_beside_.contains(wedge->corner.vertex));
    if (demands_collateral_ ? !is_left : !(at_corner || wedge != nullptr)) {
      into.bad.push_back(low);
      return true;
    }
    into.collateral.push_back(t);
  }
  if (at_corner && angle_.is_low(sites, unavoidable(state.edges(), t, in)))
    into.improvable.push_back(low);
  return false;
}

void bad_triangle_queue::judge(const refine_state& state, const site_oracle& oracle,
                               const triangle& t, record& into) const {
  const triangle_sites sites = sites_of(state, t);
  if (angle_.is_low(sites) && judge_low(state, oracle, t, into)) return;
  if (!limit_size_) return;
  const double circumradius = metric_circumradius(sites);
  if (circumradius > largest_circumradius)
    into.bad.push_back({badness::too_large, -circumradius, t});
}

bad_triangle_queue::record bad_triangle_queue::examine(const refine_state& state,
                                                       const star_predicates& kernel,
                                                       vertex_index v) const {
  record found;
  const site_oracle oracle = state.oracle().with_kernel(kernel);
  const star_set& stars = state.stars();
  const auto has = [&](vertex_index u, vertex_index y, vertex_index x) {
    return std::any_of(stars[u].sectors.begin(), stars[u].sectors.end(),
                       [&](const sector& s) { return gap_from(oracle, u, s, y, x).has_value(); });
  };
  for (const sector& s : stars[v].sectors) {
    const std::size_t before = found.disagreeing.size();
    if (s.neighbours.empty()) found.disagreeing.push_back({v, v, v});
    for (std::size_t gap = 0; gap < s.gaps(); ++gap) {
      const triangle t{v, s.neighbours[gap], s.neighbours[s.after(gap)]};
      if (!holds_triangle(oracle, v, s, gap)) {
        found.disagreeing.push_back(t);  // a wide gap
      } else if (!has(t[1], t[2], v) || !has(t[2], v, t[1]) || stars.is_unsettled(v)) {
        // Rotates the triangle so that its least vertex comes first, for all three stars alike. Its
        // orientation stays positive.
        found.disagreeing.push_back(canonical(t));
      } else if (v < t[1] && v < t[2]) {
        judge(state, oracle, t, found);
      }
    }
    // If all triangles of v agree, the star of each neighbour contains v: no neighbour is
    // one-sided.
    const bool all_agree = s.gaps() > 0 && found.disagreeing.size() == before;
    for (std::size_t i = 0; !all_agree && i < s.neighbours.size(); ++i)
      if (!stars[s.neighbours[i]].contains(v)) found.one_sided.push_back(s.neighbours[i]);
  }
  return found;
}

void bad_triangle_queue::forget(vertex_index v) {
  const auto at = records_.find(v);
  if (at == records_.end()) return;
  const record& old = at->second;
  for (const triangle& t : old.disagreeing) {
    const auto entry = disagreeing_.find(t);
    if (--entry->second.first > 0) continue;
    bad_.erase({badness::disagreeing, entry->second.second, t});
    --counts_[0];
    disagreeing_.erase(entry);
  }
  for (const bad_triangle& b : old.bad) {
    bad_.erase(b);
    --counts_[static_cast<std::size_t>(b.why)];
  }
  for (const bad_triangle& b : old.improvable) improvable_.erase(b);
  collateral_ -= old.collateral.size();
  for (const vertex_index u : old.one_sided) {
    std::vector<vertex_index>& claimants = claimed_by_[u];
    claimants.erase(std::remove(claimants.begin(), claimants.end(), v), claimants.end());
    if (claimants.empty()) claimed_by_.erase(u);
  }
  records_.erase(at);
}

void bad_triangle_queue::remember(const refine_state& state, vertex_index v, record now) {
  if (now.empty()) return;
  for (const triangle& t : now.disagreeing) {
    const auto [entry, added] = disagreeing_.try_emplace(t, 0, 0.0);
    if (added) {
      entry->second.second = smallest_angle(sites_of(state, t));
      bad_.insert({badness::disagreeing, entry->second.second, t});
      ++counts_[0];
    }
    ++entry->second.first;
  }
  for (const bad_triangle& b : now.bad) {
    bad_.insert(b);
    ++counts_[static_cast<std::size_t>(b.why)];
  }
  for (const bad_triangle& b : now.improvable) improvable_.insert(b);
  collateral_ += now.collateral.size();
  for (const vertex_index u : now.one_sided) claimed_by_[u].push_back(v);
  records_.emplace(v, std::move(now));
}

// Returns the stars to be examined: the changed ones and those that have a changed one as a
// neighbour, or all stars in the first call. Findings of a star depend on itself and on the stars
// of its neighbours. A star that has the centre of a changed star as a neighbour is among the
// changed star's neighbours, now or before the change, or else is listed in claimed_by_.
std::vector<vertex_index> bad_triangle_queue::dependents(refine_state& state) {
  auto [changed, all] = state.stars().take_touched();
  if (std::exchange(first_, false)) {
    all.resize(state.stars().size());
    std::iota(all.begin(), all.end(), vertex_index{0});
    return all;
  }
  sort_unique(changed);
  all.insert(all.end(), changed.begin(), changed.end());
  for (const vertex_index v : changed) {
    for (const sector& s : state.stars()[v].sectors)
      all.insert(all.end(), s.neighbours.begin(), s.neighbours.end());
    const auto claimants = claimed_by_.find(v);
    if (claimants != claimed_by_.end())
      all.insert(all.end(), claimants->second.begin(), claimants->second.end());
  }
  sort_unique(all);
  return all;
}

void bad_triangle_queue::update(refine_state& state) {
  const std::vector<vertex_index> which = dependents(state);
  constexpr std::size_t chunk = 256;
  struct spoken {
    vertex_index who;
    record what;
  };
  std::vector<tier_counters> counts(chunk_count(which.size(), chunk));
  std::vector<std::size_t> looks(counts.size(), 0);
  std::vector<spoken> all = collect_chunks<spoken>(
      which.size(), chunk, [&](std::size_t begin, std::size_t end, std::vector<spoken>& out) {
        const auto kernel = state.kernel().fork(counts[begin / chunk]);
        for (std::size_t i = begin; i < end; ++i) {
          record found = examine(state, *kernel, which[i]);
          looks[begin / chunk] += neighbours_of_neighbours(state.stars(), which[i]);
          if (!found.empty()) out.push_back({which[i], std::move(found)});
        }
      });
  for (const tier_counters& c : counts) state.kernel().counters() += c;
  state.count_neighbours_looked_at(std::accumulate(looks.begin(), looks.end(), std::size_t{0}));
  for (const vertex_index v : which) forget(v);
  for (spoken& s : all) remember(state, s.who, std::move(s.what));
}

}  // namespace asterism::internal
