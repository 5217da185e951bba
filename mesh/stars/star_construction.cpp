// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/star_construction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/mesh/numerics/approximate_star.hpp"
#include "asterism/mesh/numerics/metric_box.hpp"
#include "asterism/mesh/stars/star_finality.hpp"
#include "asterism/mesh/stars/star_insertion.hpp"
#include "asterism/mesh/support/sort_unique.hpp"

namespace asterism::internal {
namespace {

// Largest number of rounds over all sites. A star that does not settle in a few rounds replaces
// neighbours in a cycle, which more rounds do not end.
constexpr std::size_t most_rounds = 8;

struct candidate {
  double distance;  // squared, as the centre measures
  vertex_index who;
};

std::vector<vertex_index> from_near_to_far(const site_oracle& oracle, std::vector<candidate> all) {
  std::sort(all.begin(), all.end(), [&](const candidate& a, const candidate& b) {
    return a.distance != b.distance ? a.distance < b.distance : oracle.precedes(a.who, b.who);
  });
  std::vector<vertex_index> order;
  order.reserve(all.size());
  for (const candidate& c : all) order.push_back(c.who);
  return order;
}

std::vector<vertex_index> all_sites(const site_oracle& oracle, vertex_index v) {
  std::vector<candidate> all;
  all.reserve(oracle.size());
  for (vertex_index w = 0; w < oracle.size(); ++w)
    if (w != v) all.push_back({oracle.squared_distance(v, w), w});
  return from_near_to_far(oracle, std::move(all));
}

constructed_star settle(const site_oracle& oracle, vertex_index v, star begun,
                        const std::vector<vertex_index>& order) {
  constructed_star built{std::move(begun), false, false, {}};
  star& s = built.content;
  const std::size_t most_offers = most_rounds * order.size();
  std::size_t refused_in_a_row = 0;  // by the star as it is now
  for (std::size_t i = 0; i < most_offers && refused_in_a_row < order.size(); ++i) {
    const vertex_index w = order[i % order.size()];
    if (oracle.is_over()) return built;
    ++refused_in_a_row;
    if (s.contains(w)) continue;
    if (offer(oracle, v, s, w)) {
      prune(oracle, v, s);
      refused_in_a_row = 0;
    }
  }
  built.settled = refused_in_a_row == order.size();
  return built;
}

// --- The star made from the sites near v.

// Returns the part of the ring, which is counter-clockwise, from one end of a corner to the other;
// none where one of them is missing.
std::optional<std::vector<vertex_index>> between_ends(std::span<const vertex_index> ring,
                                                      const boundary_corner& corner) {
  const auto first = std::find(ring.begin(), ring.end(), corner.first);
  if (first == ring.end() || corner.first == corner.last) return std::nullopt;
  std::vector<vertex_index> part(first, ring.end());
  part.insert(part.end(), ring.begin(), first);
  const auto last = std::find(part.begin(), part.end(), corner.last);
  if (last == part.end()) return std::nullopt;
  part.erase(last + 1, part.end());
  return part;
}

// Returns the star of v with these neighbours, counter-clockwise, those outside the domain left
// out; none if a gap is half a turn or more, or an end of a subsegment at v is missing.
//
// Checks for half turns only: doubles order directions well enough for the ring to go around once,
// and no other fault is possible.
std::optional<star> ring_star(const site_oracle& oracle, vertex_index v,
                              std::span<const vertex_index> ring) {
  star s;
  for (const boundary_corner& corner : oracle.edges().corners(v)) {
    auto part = between_ends(ring, corner);
    if (!part) return std::nullopt;
    s.sectors.push_back({*std::move(part), false});
  }
  if (s.sectors.empty()) {
    if (ring.size() < 3) return std::nullopt;
    s.sectors.push_back({{ring.begin(), ring.end()}, true});
  }
  for (const sector& part : s.sectors)
    for (std::size_t i = 0; i < part.gaps(); ++i)
      if (!holds_triangle(oracle, v, part, i)) return std::nullopt;
  return s;
}

// True if no subsegment comes near the box around the star.
bool is_clear_of_subsegments(const site_oracle& oracle, vertex_index v, const star& s) {
  bounding_box around{oracle.sites()[v].position, oracle.sites()[v].position};
  for (const sector& part : s.sectors)
    for (const vertex_index u : part.neighbours) around.include(oracle.sites()[u].position);
  return oracle.near()->subsegments().visit(around, [](std::uint32_t) { return false; });
}

// True if the work limit is reached. Polled for every sixteenth neighbour of a star: there may be
// tens of thousands, and as many subsegments that hide each.
bool is_over_at(const site_oracle& oracle, std::size_t neighbour) {
  constexpr std::size_t at_a_time = 16;
  return neighbour % at_a_time == at_a_time - 1 && oracle.is_over();
}

bool sees_neighbours(const site_oracle& oracle, vertex_index v, const star& s) {
  if (is_clear_of_subsegments(oracle, v, s)) return true;
  for (const sector& part : s.sectors)
    for (std::size_t i = 0; i < part.size(); ++i)
      if (is_over_at(oracle, i) || (!part.is_forced(i) && !oracle.visible(v, part.neighbours[i])))
        return false;
  return true;
}

// Returns the star with these neighbours if v sees each of them.
std::optional<star> seen_star(const site_oracle& oracle, vertex_index v,
                              std::span<const vertex_index> ring) {
  auto s = ring_star(oracle, v, ring);
  if (!s || !sees_neighbours(oracle, v, *s)) return std::nullopt;
  return s;
}

// Returns the star with these neighbours if exact tests confirm it: v sees each of them, and each
// is accepted.
std::optional<star> accepted_star(const site_oracle& oracle, vertex_index v,
                                  std::span<const vertex_index> ring) {
  auto s = seen_star(oracle, v, ring);
  if (!s || prune(oracle, v, *s)) return std::nullopt;
  return s;
}

// True if v and each neighbour measure the edge between them about alike: squares of lengths differ
// by less than a half. Of 36 meshes of 1,000 to 10,000 random sites in steep metrics the audit
// refused 7 because a star missed a site, and 15 without this limit. The limit costs other meshes 2
// percent of their instructions. A limit of 1.25 avoided one more refusal, limits from 3 on avoided
// few.
bool lengths_agree(const site_oracle& oracle, vertex_index v, const star& s) {
  constexpr double most = 1.5;
  for (const sector& part : s.sectors)
    for (const vertex_index w : part.neighbours) {
      const double by_v = oracle.squared_distance(v, w), by_w = oracle.squared_distance(w, v);
      if (!(by_v <= most * by_w && by_w <= most * by_v)) return false;
    }
  return true;
}

// Returns the star with the proposed neighbours if each is accepted and, unless the auditor
// confirms stars, exact tests confirm it at once against all sites. If the auditor confirms it,
// only neighbours whose acceptance is in doubt are tested here: the auditor tests all edges.
std::optional<constructed_star> guessed_star(const site_oracle& oracle, vertex_index v,
                                             const star_proposal& proposed) {
  if (proposed.guess.empty()) return std::nullopt;
  auto s = seen_star(oracle, v, proposed.guess);
  if (!s) return std::nullopt;
  const bool is_audited = proposed.confirmed == star_confirmation::by_auditor ||
                          (proposed.confirmed == star_confirmation::by_auditor_if_lengths_agree &&
                           lengths_agree(oracle, v, *s));
  if (!(is_audited && proposed.is_plain) && prune(oracle, v, *s)) return std::nullopt;
  if (is_audited) return constructed_star{*std::move(s), true, false, {}};
  const auto reach = final_reach(oracle, v, *s);
  if (!reach) return std::nullopt;
  return constructed_star{*std::move(s), true, false, reach};
}

std::vector<vertex_index> ring_of(const approximate_star& guess) {
  std::vector<vertex_index> ring;
  ring.reserve(guess.size());
  for (const approximate_gap& gap : guess) ring.push_back(gap.neighbour);
  return ring;
}

// Returns the star to begin with: the guessed neighbours that v sees and that pass their tests,
// which are most. A star begun without neighbours first accepts many sites in far directions, which
// only exact numbers remove.
star begun_star(const site_oracle& oracle, vertex_index v, const approximate_star& guess) {
  auto s = ring_star(oracle, v, ring_of(guess));
  if (!s) return empty_star(oracle.edges(), v);
  for (sector& part : s->sectors)
    for (std::size_t i = part.size(); i-- > 0 && !is_over_at(oracle, i);)
      if (!part.is_forced(i) && !oracle.visible(v, part.neighbours[i]))
        part.neighbours.erase(part.neighbours.begin() + static_cast<std::ptrdiff_t>(i));
  prune(oracle, v, *s);
  return *std::move(s);
}

// Returns the star guessed in plain doubles if exact tests confirm it: at once against all sites,
// or else against the sites in `order`. With the near search, gaps without a bound on their reach
// are left to a thorough search, since most such stars are soon changed.
std::optional<constructed_star> confirmed_guess(const site_oracle& oracle, vertex_index v,
                                                star_search search, const approximate_star& guess,
                                                const std::vector<vertex_index>& order) {
  auto s = accepted_star(oracle, v, ring_of(guess));
  if (!s) return std::nullopt;
  const auto unbounded =
      search == star_search::near ? unbounded_gaps::give_up : unbounded_gaps::ask_all;
  if (const auto reach = final_reach(oracle, v, *s, unbounded))
    return constructed_star{*std::move(s), true, false, reach};
  for (const vertex_index w : order)
    if (oracle.is_over() || (!s->contains(w) && would_accept(oracle, v, *s, w)))
      return std::nullopt;
  return constructed_star{*std::move(s), true, false, {}};
}

// Extent of a star for site_index::visit_reach, in doubles. A gap whose vertex is not found has
// an infinite radius. A gap closed by a subsegment of the boundary has none, as it accepts
// nothing.
struct star_extent {
  double radius = 0, longest = 0;
  bool lacks_vertex = false;  // of a gap of less than half a turn
  double finite = 0;          // the greatest radius that is
  // A gap of infinite radius and less than half a turn, from y counter-clockwise to x. Wider gaps
  // are not listed: any site may close them.
  struct open_gap {
    vertex_index y, x;
  };
  std::vector<open_gap> open;
  bool is_wide = false;

  // Calls visit(w) for each site not certainly out of reach of all gaps: those of finite radius,
  // and those in the list of open gaps. May call it more than once for a site.
  template <class Visit>
  bool visit(const site_oracle& oracle, vertex_index v, const Visit& visit) const {
    const site_index& near = oracle.near()->sites();
    const std::vector<site>& sites = oracle.sites();
    const double reach = is_wide ? radius : std::max(finite, longest);
    if (!near.visit_reach(sites, sites[v], reach, visit)) return false;
    return is_wide || std::all_of(open.begin(), open.end(), [&](const open_gap& gap) {
             return near.visit_cone(sites, sites[v], std::numeric_limits<double>::infinity(),
                                    sites[gap.y].position, sites[gap.x].position, visit);
           });
  }
};

star_extent extent_of(const site_oracle& oracle, vertex_index v, const star& s) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  star_extent extent;
  for (const sector& part : s.sectors)
    for (std::size_t i = 0; i < part.gaps() || part.neighbours.empty(); ++i) {
      if (part.neighbours.empty()) {
        extent.radius = extent.longest = infinity;
        extent.is_wide = true;
        return extent;
      }
      approximate_gap gap{part.neighbours[i], {}, 0};
      const vertex_index next = part.neighbours[part.after(i)];
      if (oracle.edges().is_subsegment(gap.neighbour, next)) continue;
      close_gap(oracle.sites(), v, gap, next);
      const double radius = std::sqrt(gap.squared_radius);
      extent.radius = std::max(extent.radius, radius);
      extent.lacks_vertex = extent.lacks_vertex || lacks_vertex(oracle.sites(), v, gap, next);
      for (const vertex_index w : {gap.neighbour, next})
        extent.longest = std::max(extent.longest, std::sqrt(oracle.squared_distance(v, w)));
      if (radius < infinity)
        extent.finite = std::max(extent.finite, radius);
      else if (holds_triangle(oracle, v, part, i))
        extent.open.push_back({gap.neighbour, next});
      else
        extent.is_wide = true;
    }
  return extent;
}

struct gathered {
  std::vector<vertex_index> order;
  bool everything = false;
};

gathered gather(const site_oracle& oracle, vertex_index v, double reach) {
  const proximity& near = *oracle.near();
  const bounding_box box = box_around(oracle.sites()[v], reach);
  const bool covers = box.low.x <= near.box().low.x && box.low.y <= near.box().low.y &&
                      box.high.x >= near.box().high.x && box.high.y >= near.box().high.y;
  if (covers) return {all_sites(oracle, v), true};
  std::vector<candidate> found;
  near.sites().visit_box(oracle.sites(), box.low, box.high, [&](vertex_index w) {
    const double distance = oracle.squared_distance(v, w);
    if (w != v && distance <= reach * reach) found.push_back({distance, w});
    return true;
  });
  return {from_near_to_far(oracle, std::move(found)), false};
}

// Constructs the star of v from these sites. `guess` is their star in plain doubles.
constructed_star construct_from(const site_oracle& oracle, vertex_index v, star_search search,
                                const approximate_star& guess,
                                const std::vector<vertex_index>& order) {
  if (auto confirmed = confirmed_guess(oracle, v, search, guess, order))
    return std::move(*confirmed);
  return settle(oracle, v, begun_star(oracle, v, guess), order);
}

// Multiple of the farthest vertex's distance within which sites are tested before the thorough
// search: two suffices where metrics are equal, and a margin is added.
constexpr double reach_of_vertices = 2.1;

struct local_star {
  constructed_star built;
  gathered among;
  star_extent extent;  // of a star that is not final
};

star_extent extent_of(const site_oracle& oracle, vertex_index v, const approximate_star& guess) {
  star_extent extent;
  for (std::size_t i = 0; i < guess.size(); ++i) {
    const vertex_index next = guess[following(guess, i)].neighbour;
    extent.radius = std::max(extent.radius, std::sqrt(guess[i].squared_radius));
    extent.lacks_vertex = extent.lacks_vertex || lacks_vertex(oracle.sites(), v, guess[i], next);
  }
  return extent;
}

// Constructs the star of v from the sites near it. Searches farther and farther, until the star's
// farthest vertex is well within the radius searched. The first radius is two spacings, times the
// margin of reach_of_vertices, which contains the star in an even lattice. The radius must contain
// six sites, the average number of neighbours. The star found in too small a radius gives the
// radius that it needs. The next search takes that with 2 % for its own rounding, but at least a
// quarter more than the last, so that the radius grows, and at most twice the last, as a star of
// too few sites may have a vertex anywhere.
//
// The number of searches is limited. Where metrics vary wildly some gaps of less than half a turn
// have no vertex at any distance, and far sites are refused there only after long exact tests; then
// the sites of the third search suffice until a thorough one. With five searches the square in
// swirl:24 with 1,000 triangles takes 3.5 times as long.
local_star construct_near(const site_oracle& oracle, vertex_index v, star_search search) {
  constexpr double spacings = 2.2, infinity = std::numeric_limits<double>::infinity();
  constexpr std::size_t fewest = 6;
  constexpr int enough_attempts = 3, most_attempts = 5;
  const bool interior = oracle.edges().corners(v).empty();
  double reach = spacings * oracle.near()->sites().spacing_near(oracle.sites()[v]);
  for (int attempt = 1;; ++attempt) {
    gathered among = gather(oracle, v, reach);
    const bool last = among.everything || (attempt >= most_attempts && !among.order.empty());
    const auto will_do = [&](const star_extent& extent) {
      return last || reach_of_vertices * extent.radius <= reach ||
             (attempt >= enough_attempts && extent.lacks_vertex);
    };
    star_extent found;
    found.radius = infinity;
    if (last || among.order.size() >= fewest) {
      const approximate_star guess = build_approximate_star(oracle.sites(), v, among.order);
      const star_extent guessed = extent_of(oracle, v, guess);
      if (interior) found = guessed;
      if (!interior || will_do(guessed)) {
        constructed_star built = construct_from(oracle, v, search, guess, among.order);
        if (!built.final_reach) found = extent_of(oracle, v, built.content);
        if (built.final_reach || will_do(found)) return {std::move(built), std::move(among), found};
      }
    }
    constexpr double margin = 1.02, least_growth = 1.25, most_growth = 2, growth_in_vain = 1.5;
    const double more = std::clamp(margin * reach_of_vertices * found.radius, least_growth * reach,
                                   (found.lacks_vertex ? growth_in_vain : most_growth) * reach);
    reach = reach > 0 ? more : infinity;
  }
}

// Returns the sites not certainly out of the star's reach that are not among the given ones.
std::vector<vertex_index> others_in_reach(const site_oracle& oracle, vertex_index v,
                                          const local_star& from) {
  std::vector<vertex_index> known = from.among.order, others;
  std::sort(known.begin(), known.end());
  from.extent.visit(oracle, v, [&](vertex_index w) {
    if (w != v && !std::binary_search(known.begin(), known.end(), w)) others.push_back(w);
    return true;
  });
  sort_unique(others);
  return others;
}

// Makes the star anew with the other sites that it would accept; returns false if there are none,
// or at the work limit.
bool take_missed(const site_oracle& oracle, vertex_index v, star_search search,
                 std::span<const vertex_index> others, local_star& from) {
  std::vector<vertex_index> missed;
  for (const vertex_index w : others) {
    if (oracle.is_over()) {
      from.built.settled = false;
      return false;
    }
    if (w != v && !from.built.content.contains(w) && would_accept(oracle, v, from.built.content, w))
      missed.push_back(w);
  }
  if (missed.empty()) return false;
  std::vector<candidate> all;
  for (const auto* list : {&from.among.order, &missed})
    for (const vertex_index w : *list) all.push_back({oracle.squared_distance(v, w), w});
  from.among.order = from_near_to_far(oracle, std::move(all));
  from.built =
      construct_from(oracle, v, search, build_approximate_star(oracle.sites(), v, from.among.order),
                     from.among.order);
  from.built.repaired = true;
  from.extent = extent_of(oracle, v, from.built.content);
  return true;
}

constructed_star construct_thoroughly(const site_oracle& oracle, vertex_index v, local_star from) {
  if (from.built.final_reach) return from.built;
  for (std::size_t round = 0; round < most_rounds && !from.among.everything; ++round)
    if (!take_missed(oracle, v, star_search::thorough, others_in_reach(oracle, v, from), from))
      return from.built;
  if (!from.among.everything) from.built.settled = false;
  return from.built;
}

}  // namespace

double farthest_vertex(const site_oracle& oracle, vertex_index v, const star& s) {
  return extent_of(oracle, v, s).radius;
}

double farthest_known_vertex(const site_oracle& oracle, vertex_index v, const star& s) {
  const star_extent extent = extent_of(oracle, v, s);
  return extent.is_wide ? extent.radius : std::max(extent.finite, extent.longest);
}

constructed_star construct_star(const site_oracle& oracle, vertex_index v, star_search search,
                                const star_proposal& proposed) {
  if (oracle.near() == nullptr)
    return settle(oracle, v, empty_star(oracle.edges(), v), all_sites(oracle, v));
  if (auto known = guessed_star(oracle, v, proposed)) return std::move(*known);
  local_star made = construct_near(oracle, v, search);
  take_missed(oracle, v, search, proposed.others, made);
  if (search == star_search::near) return std::move(made.built);
  return construct_thoroughly(oracle, v, std::move(made));
}

}  // namespace asterism::internal
