// SPDX-License-Identifier: MIT
#include "asterism/mesh/c_interface/stars.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "asterism/kernels/c_question.hpp"
#include "asterism/mesh/c_interface/sites.hpp"
#include "asterism/mesh/stars/star_construction.hpp"
#include "asterism/mesh/stars/star_insertion.hpp"

using namespace asterism;
using namespace asterism::internal;

struct asterism_star {
  vertex_index center = 0;
  star content;
  bool settled = false;
  std::size_t splits = 0;  // those that it knows of
};

namespace {

asterism_star built_star(const asterism_sites& sites, vertex_index v) {
  const questioner of_sites(sites);
  auto built = construct_star(of_sites.oracle(), v);
  return {v, std::move(built.content), built.settled, sites.splits};
}

bool has_same_ends(const sector& s, const sector& empty) {
  return s.closed == empty.closed &&
         (s.closed || (s.neighbours.front() == empty.neighbours.front() &&
                       s.neighbours.back() == empty.neighbours.back()));
}

// True if splits of the boundary have left the star as it is: its own subsegments are whole, and
// none of its neighbours is hidden.
bool is_untouched(const site_oracle& oracle, const asterism_star& star) {
  const vertex_index v = star.center;
  const auto empty = empty_star(oracle.edges(), v).sectors;
  const auto& now = star.content.sectors;
  if (!std::equal(now.begin(), now.end(), empty.begin(), empty.end(), has_same_ends)) return false;
  return std::all_of(now.begin(), now.end(), [&](const sector& s) {
    for (std::size_t i = 0; i < s.size(); ++i)
      if (!s.is_forced(i) && !oracle.visible(v, s.neighbours[i])) return false;
    return true;
  });
}

const sector* sector_of(const asterism_star* star, size_t which) {
  return star != nullptr && which < star->content.sectors.size() ? &star->content.sectors[which]
                                                                 : nullptr;
}

}  // namespace

asterism_status asterism_star_build(const asterism_sites* sites, size_t v, asterism_star** out) {
  if (sites == nullptr || out == nullptr) return ASTERISM_NULL_POINTER;
  if (sites->broken) return ASTERISM_OUT_OF_MEMORY;
  if (v >= sites->all.size()) return ASTERISM_OUT_OF_RANGE;
  return without_exceptions([&] {
    *out =
        std::make_unique<asterism_star>(built_star(*sites, static_cast<vertex_index>(v))).release();
    return ASTERISM_OK;
  });
}

void asterism_star_free(asterism_star* star) { delete star; }

asterism_status asterism_star_insert(const asterism_sites* sites, asterism_star* star, size_t w,
                                     int* changed) {
  if (sites == nullptr || star == nullptr || changed == nullptr) return ASTERISM_NULL_POINTER;
  if (sites->broken) return ASTERISM_OUT_OF_MEMORY;
  const vertex_index v = star->center;
  if (w >= sites->all.size() || v >= sites->all.size()) return ASTERISM_OUT_OF_RANGE;
  return without_exceptions([&] {
    const auto site = static_cast<vertex_index>(w);
    const questioner of_sites(*sites);
    asterism_star with = *star;
    if (with.splits != sites->splits && !is_untouched(of_sites.oracle(), with))
      with = built_star(*sites, v);
    else if (site != v && !with.content.contains(site))
      offer(of_sites.oracle(), v, with.content, site);
    with.splits = sites->splits;
    *changed = with.content == star->content ? 0 : 1;
    std::swap(*star, with);
    return ASTERISM_OK;
  });
}

size_t asterism_star_center(const asterism_star* star) {
  return star == nullptr ? 0 : star->center;
}

size_t asterism_star_sector_count(const asterism_star* star) {
  return star == nullptr ? 0 : star->content.sectors.size();
}

const unsigned* asterism_star_sector(const asterism_star* star, size_t which, size_t* count,
                                     int* closed) {
  const sector* const s = sector_of(star, which);
  if (count != nullptr) *count = s != nullptr ? s->size() : 0;
  if (closed != nullptr) *closed = s != nullptr && s->closed ? 1 : 0;
  return s != nullptr ? s->neighbours.data() : nullptr;
}

const unsigned* asterism_star_neighbours(const asterism_star* star, size_t* count) {
  return asterism_star_sector(star, 0, count, nullptr);
}

int asterism_star_is_settled(const asterism_star* star) {
  return star != nullptr && star->settled ? 1 : 0;
}
