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

namespace asterism::internal {
namespace {

// Most rounds over all sites. A star that does not settle in a few is replacing neighbours in a
// circle, which more rounds do not cure.
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

// --- The star from what is near.

// Returns the star of an interior site with these neighbours, counter-clockwise, if exact tests
// find nothing wrong with it: it goes round, and each neighbour is seen and stands.
std::optional<star> standing_star(const site_oracle& oracle, vertex_index v,
                                  std::vector<vertex_index> ring) {
  if (ring.size() < 3) return std::nullopt;
  star s;
  s.sectors.push_back({std::move(ring), true});
  const sector& part = s.sectors[0];
  // Checks for half turns alone: doubles tell directions apart well enough for the ring to go round
  // once, and nothing else could be wrong with it.
  for (std::size_t i = 0; i < part.size(); ++i)
    if (!holds_triangle(oracle, v, part, i)) return std::nullopt;
  for (const vertex_index w : part.neighbours)
    if (!oracle.visible(v, w)) return std::nullopt;
  if (prune(oracle, v, s)) return std::nullopt;
  return s;
}

// Returns the star with these neighbours if exact tests confirm it at once against all sites.
std::optional<constructed_star> final_star(const site_oracle& oracle, vertex_index v,
                                           std::span<const vertex_index> ring) {
  if (!oracle.edges().corners(v).empty()) return std::nullopt;
  auto s = standing_star(oracle, v, {ring.begin(), ring.end()});
  const auto reach = s ? final_reach(oracle, v, *s) : std::nullopt;
  if (!reach) return std::nullopt;
  return constructed_star{*std::move(s), true, false, reach};
}

// Returns the star guessed in plain doubles if exact tests confirm it: at once against all sites
// there are, or else against the given ones.
std::optional<constructed_star> confirmed_guess(const site_oracle& oracle, vertex_index v,
                                                const plain_star& guess,
                                                const std::vector<vertex_index>& order) {
  std::vector<vertex_index> ring;
  for (const plain_gap& gap : guess) ring.push_back(gap.neighbour);
  auto s = standing_star(oracle, v, std::move(ring));
  if (!s) return std::nullopt;
  if (const auto reach = final_reach(oracle, v, *s))
    return constructed_star{*std::move(s), true, false, reach};
  for (const vertex_index w : order)
    if (oracle.is_over() || (!s->contains(w) && would_accept(oracle, v, *s, w)))
      return std::nullopt;
  return constructed_star{*std::move(s), true, false, {}};
}

// Extent of a star as site_index::visit_reach wants it, but in doubles. A gap whose vertex is not
// found has an infinite radius. A gap closed by a subsegment of the boundary has none, as it
// accepts nothing.
struct star_extent {
  double radius = 0, longest = 0;
  double reach() const { return std::max(radius, longest); }
};
star_extent extent_of(const site_oracle& oracle, vertex_index v, const star& s) {
  star_extent extent;
  for (const sector& part : s.sectors)
    for (std::size_t i = 0; i < part.gaps() || part.neighbours.empty(); ++i) {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      if (part.neighbours.empty()) return {infinity, infinity};
      plain_gap gap{part.neighbours[i], {}, 0};
      const vertex_index next = part.neighbours[part.after(i)];
      if (oracle.edges().is_subsegment(gap.neighbour, next)) continue;
      close_gap(oracle.sites(), v, gap, next);
      extent.radius = std::max(extent.radius, std::sqrt(gap.squared_radius));
      for (const vertex_index w : {gap.neighbour, next})
        extent.longest = std::max(extent.longest, std::sqrt(oracle.squared_distance(v, w)));
    }
  return extent;
}

struct gathered {
  std::vector<vertex_index> order;
  bool everything = false;
};

gathered gather(const site_oracle& oracle, vertex_index v, double reach) {
  const neighbourhood& near = *oracle.near();
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

// Constructs the star of v from these sites. `guess` is their star in plain doubles; empty on the
// boundary.
constructed_star construct_from(const site_oracle& oracle, vertex_index v, const plain_star& guess,
                                const std::vector<vertex_index>& order) {
  if (auto confirmed = confirmed_guess(oracle, v, guess, order)) return std::move(*confirmed);
  return settle(oracle, v, empty_star(oracle.edges(), v), order);
}

// Multiple of the farthest vertex's distance beyond which sites are left to the thorough search:
// two, which is enough where metrics are equal, and a margin.
constexpr double reach_of_vertices = 2.1;

struct local_star {
  constructed_star built;
  gathered among;
  star_extent extent;
};

plain_star guess_star(const site_oracle& oracle, vertex_index v,
                      const std::vector<vertex_index>& order) {
  if (!oracle.edges().corners(v).empty()) return {};
  return build_plain_star(oracle.sites(), v, order);
}

double farthest_vertex(const plain_star& guess) {
  double squared = 0;
  for (const plain_gap& gap : guess) squared = std::max(squared, gap.squared_radius);
  return std::sqrt(squared);
}

// Constructs the star of v from the sites near it. Looks farther and farther, until the star's
// farthest vertex is well within what was looked at. The first look takes two spacings, and the
// margin of reach_of_vertices: they hold the star in an even lattice. Six sites are what a site has
// as neighbours on average. A look that was too short names the reach it wants. The next one takes
// that with 2 % for its own rounding, but at least a quarter more than the last, so that looks get
// somewhere, and at most twice as much, as a guess from too few sites may have a vertex anywhere.
//
// Ends because attempts are counted. Where metrics vary wildly some gaps have no vertex however far
// one looks; then the near sites have to do, until a thorough search.
local_star construct_near(const site_oracle& oracle, vertex_index v) {
  constexpr double spacings = 2.2, infinity = std::numeric_limits<double>::infinity();
  constexpr std::size_t fewest = 6;
  constexpr int most_attempts = 5;
  const bool interior = oracle.edges().corners(v).empty();
  double reach = spacings * oracle.near()->sites().spacing_near(oracle.sites()[v]);
  for (int attempt = 1;; ++attempt) {
    gathered among = gather(oracle, v, reach);
    const bool last = among.everything || (attempt >= most_attempts && !among.order.empty());
    double wanted = infinity;
    const bool enough = last || among.order.size() >= fewest;
    plain_star guess;
    if (enough && interior) {
      guess = guess_star(oracle, v, among.order);
      wanted = reach_of_vertices * farthest_vertex(guess);
    }
    if (last || (enough && (!interior || wanted <= reach))) {
      constructed_star built = construct_from(oracle, v, guess, among.order);
      const star_extent extent = extent_of(oracle, v, built.content);
      wanted = reach_of_vertices * extent.radius;
      if (last || wanted <= reach) return {std::move(built), std::move(among), extent};
    }
    constexpr double margin = 1.02, least_growth = 1.25, most_growth = 2;
    const double more = std::clamp(margin * wanted, least_growth * reach, most_growth * reach);
    reach = reach > 0 ? more : infinity;
  }
}

// Returns the sites not certainly out of reach that are not among the given ones.
std::vector<vertex_index> others_in_reach(const site_oracle& oracle, vertex_index v,
                                          const local_star& from) {
  std::vector<vertex_index> known = from.among.order, others;
  std::sort(known.begin(), known.end());
  oracle.near()->sites().visit_reach(
      oracle.sites(), oracle.sites()[v], from.extent.reach(), [&](vertex_index w) {
        if (w != v && !std::binary_search(known.begin(), known.end(), w)) others.push_back(w);
        return true;
      });
  return others;
}

constructed_star construct_thoroughly(const site_oracle& oracle, vertex_index v, local_star from) {
  if (from.built.final_reach) return from.built;
  for (std::size_t round = 0; round < most_rounds && !from.among.everything; ++round) {
    std::vector<vertex_index> missed;
    for (const vertex_index w : others_in_reach(oracle, v, from)) {
      if (oracle.is_over()) {
        from.built.settled = false;
        return from.built;
      }
      if (would_accept(oracle, v, from.built.content, w)) missed.push_back(w);
    }
    if (missed.empty()) return from.built;
    std::vector<candidate> all;
    for (const auto* list : {&from.among.order, &missed})
      for (const vertex_index w : *list) all.push_back({oracle.squared_distance(v, w), w});
    from.among.order = from_near_to_far(oracle, std::move(all));
    from.built =
        construct_from(oracle, v, guess_star(oracle, v, from.among.order), from.among.order);
    from.built.repaired = true;
    from.extent = extent_of(oracle, v, from.built.content);
  }
  if (!from.among.everything) from.built.settled = false;
  return from.built;
}

}  // namespace

double farthest_vertex(const site_oracle& oracle, vertex_index v, const star& s) {
  return extent_of(oracle, v, s).radius;
}

constructed_star construct_star(const site_oracle& oracle, vertex_index v, star_search search,
                                std::span<const vertex_index> guess) {
  if (oracle.near() == nullptr)
    return settle(oracle, v, empty_star(oracle.edges(), v), all_sites(oracle, v));
  if (auto known = final_star(oracle, v, guess)) return std::move(*known);
  local_star made = construct_near(oracle, v);
  if (search == star_search::near) return std::move(made.built);
  return construct_thoroughly(oracle, v, std::move(made));
}

}  // namespace asterism::internal
