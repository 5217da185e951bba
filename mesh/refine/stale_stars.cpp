// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/stale_stars.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace asterism::internal {

bool stale_stars::rebuild_disagreeing(const bad_triangle_queue& queue) {
  const star_set& stars = state_.stars();
  std::vector<vertex_index> stale, unconfirmed;
  // So many looks at a neighbour take as long as one look at a triangle, a third of a microsecond
  // each where metrics are the same, else one.
  constexpr std::size_t as_neighbours = 110;
  for (const bad_triangle& b : queue.bad()) {
    if (b.why != badness::disagreeing) break;
    state_.count_neighbours_looked_at(as_neighbours);
    // At a jump of the metric most sites are in reach of most others.
    if (steep_.is_given_up(b.where) || steep_.gives_up(b)) continue;
    for (const vertex_index v : b.where) {
      if (stars.is_stale(v)) stale.push_back(v);
      if (!stars.is_confirmed(v) && !stars.is_unsettled(v)) unconfirmed.push_back(v);
    }
  }
  if (steep_.awaits_other_metric()) return false;
  if (rebuild(std::move(stale), star_search::near)) return true;
  // All sites are in reach where metrics vary much, so this waits until there are a tenth more.
  if (10 * state_.sites().size() < 11 * confirmed_at_) return false;
  confirmed_at_ = state_.sites().size();
  return rebuild(std::move(unconfirmed), star_search::thorough);
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
