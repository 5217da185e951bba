// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/stale_stars.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "asterism/mesh/support/sort_unique.hpp"

namespace asterism::internal {

bool stale_stars::rebuild_disagreeing(const bad_triangle_queue& queue) {
  const star_set& stars = state_.stars();
  std::vector<vertex_index> stale, unconfirmed;
  std::vector<triangle> disagreeing;
  // Work for visiting one triangle, in neighbours visited: a third of a microsecond where metrics
  // are the same, else a microsecond.
  constexpr std::size_t as_neighbours = 110;
  for (const bad_triangle& b : queue.bad()) {
    if (b.why != badness::disagreeing) break;
    state_.count_neighbours_looked_at(as_neighbours);
    // Skips triangles that are given up: at a jump of the metric most sites are in reach of most
    // others, and making stars anew there changes nothing.
    if (steep_.is_given_up(b.where) || steep_.gives_up(b)) continue;
    if (exchanged_.count(b.where) == 0) disagreeing.push_back(b.where);
    for (const vertex_index v : b.where) {
      if (stars.is_stale(v)) stale.push_back(v);
      if (!stars.is_confirmed(v) && !stars.is_unsettled(v)) unconfirmed.push_back(v);
    }
  }
  if (steep_.awaits_other_metric()) return false;
  if (rebuild(std::move(stale), star_search::near)) return true;
  if (exchange(disagreeing)) return true;
  // Tests stars against all sites again only when the number of sites has grown by a tenth: where
  // metrics vary much, each test finds all sites in reach.
  if (10 * state_.sites().size() < 11 * confirmed_at_) return false;
  confirmed_at_ = state_.sites().size();
  return rebuild(std::move(unconfirmed), star_search::thorough);
}

// Offers each corner of a disagreeing triangle the other two corners and their neighbours, once for
// each triangle: a site missed by a local search is usually in the star of another corner.
bool stale_stars::exchange(const std::vector<triangle>& disagreeing) {
  const star_set& stars = state_.stars();
  std::vector<std::pair<vertex_index, vertex_index>> offers;  // to whom, and what
  for (const triangle& t : disagreeing) {
    exchanged_.insert(t);
    for (const vertex_index v : t) {
      if (stars.is_confirmed(v) || stars.is_unsettled(v)) continue;
      for (const vertex_index u : t) {
        if (u == v) continue;
        offers.emplace_back(v, u);
        for (const sector& s : stars[u].sectors)
          for (const vertex_index w : s.neighbours) offers.emplace_back(v, w);
      }
    }
  }
  sort_unique(offers);
  std::vector<vertex_index> which;
  neighbour_lists others;
  for (std::size_t i = 0; i < offers.size(); ++i) {
    if (which.empty() || which.back() != offers[i].first) which.push_back(offers[i].first);
    others.add(offers[i].second);
    if (i + 1 == offers.size() || offers[i + 1].first != which.back()) others.end_list();
  }
  return !state_.stars().exchange(state_.oracle(), which, others).empty();
}

bool stale_stars::rebuild_all() {
  std::vector<vertex_index> stale;
  for (vertex_index v = 0; v < state_.stars().size(); ++v)
    if (state_.stars().is_stale(v)) stale.push_back(v);
  return rebuild(std::move(stale), star_search::near);
}

bool stale_stars::repair() {
  if (repaired_at_ == state_.sites().size()) return false;
  repaired_at_ = state_.sites().size();
  std::vector<vertex_index> all(state_.sites().size());
  std::iota(all.begin(), all.end(), vertex_index{0});
  const std::size_t repaired =
      state_.stars().construct(state_.oracle(), all, star_search::thorough).size();
  repairs_ += repaired;
  return repaired > 0;
}

bool stale_stars::confirm_again() {
  if (confirmed_at_ == state_.sites().size()) return false;
  confirmed_at_ = 0;
  return true;
}

bool stale_stars::rebuild(std::vector<vertex_index> stale, star_search search) {
  std::sort(stale.begin(), stale.end());
  stale.erase(std::unique(stale.begin(), stale.end()), stale.end());
  return !state_.stars().construct(state_.oracle(), stale, search).empty();
}

}  // namespace asterism::internal
