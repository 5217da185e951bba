// SPDX-License-Identifier: MIT
#include "asterism/mesh/c_interface/stars.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

#include "asterism/kernels/c_question.hpp"
#include "asterism/mesh/stars/boundary.hpp"
#include "asterism/mesh/stars/proximity.hpp"
#include "asterism/mesh/stars/star_construction.hpp"
#include "asterism/mesh/stars/star_insertion.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"

using namespace asterism;
using namespace asterism::internal;

static_assert(std::is_same_v<vertex_index, unsigned>);

struct asterism_sites {
  std::vector<site> all;
  std::set<std::pair<double, double>> places;  // of all of them
  boundary none;
  std::optional<neighbourhood> near;  // of all of them; without it answers are the same, slower

  bool is_place_taken(const point& p) const { return places.count({p.x, p.y}) != 0; }
};

struct asterism_star {
  vertex_index center = 0;
  star content;
  bool settled = false;
};

namespace {

asterism_status check_site(const double* numbers) {
  batch_record record{predicate::is_positive_definite, {}};
  std::copy(numbers + 2, numbers + 5, record.numbers.begin());
  if (!is_finite(numbers[0]) || !is_finite(numbers[1])) return ASTERISM_NOT_FINITE;
  const filtered_kernel kernel;
  if (const asterism_status bad = check_record(kernel, record); bad != ASTERISM_OK) return bad;
  return kernel.is_positive_definite(metric_at(record, 0)) ? ASTERISM_OK
                                                           : ASTERISM_NOT_POSITIVE_DEFINITE;
}

site site_of(const double* n) { return {{n[0], n[1]}, {n[2], n[3], n[4]}}; }

asterism_status append(asterism_sites& sites, const double* numbers) {
  if (const asterism_status bad = check_site(numbers); bad != ASTERISM_OK) return bad;
  const site s = site_of(numbers);
  if (sites.is_place_taken(s.position)) return ASTERISM_EQUAL_SITES;
  sites.all.reserve(sites.all.size() < sites.all.capacity() ? 0 : 2 * sites.all.size() + 1);
  sites.places.emplace(s.position.x, s.position.y);
  sites.all.push_back(s);  // has room
  return ASTERISM_OK;
}

bool is_in(const bounding_box& box, const point& p) {
  return box.low.x <= p.x && p.x <= box.high.x && box.low.y <= p.y && p.y <= box.high.y;
}

// Indexes the last site. If there is no memory for the index, there is none from then on.
void index_last(asterism_sites& sites) {
  try {
    if (sites.near && is_in(sites.near->box(), sites.all.back().position))
      sites.near->add_site(sites.all, static_cast<vertex_index>(sites.all.size() - 1));
    else
      sites.near.emplace(sites.all, sites.none);
  } catch (const std::bad_alloc&) {
    sites.near.reset();
  }
}

// Answers a question about these sites.
class questioner {
 public:
  explicit questioner(const asterism_sites& sites)
      : oracle_(sites.all, sites.none, kernel_, nullptr, sites.near ? &*sites.near : nullptr) {}
  const site_oracle& oracle() const { return oracle_; }

 private:
  tier_counters decided_;
  star_predicates_on<filtered_kernel> kernel_{decided_};
  site_oracle oracle_;
};

}  // namespace

asterism_status asterism_sites_create(size_t count, asterism_rows sites, asterism_sites** out) {
  if (out == nullptr || (sites.first == nullptr && count > 0)) return ASTERISM_NULL_POINTER;
  if (count > std::numeric_limits<vertex_index>::max()) return ASTERISM_OUT_OF_RANGE;
  return without_exceptions([&] {
    auto made = std::make_unique<asterism_sites>();
    made->all.reserve(count);
    for (size_t k = 0; k < count; ++k)
      if (const asterism_status bad = append(*made, sites.first + k * sites.stride);
          bad != ASTERISM_OK)
        return bad;
    made->near.emplace(made->all, made->none);
    *out = made.release();
    return ASTERISM_OK;
  });
}

void asterism_sites_free(asterism_sites* sites) { delete sites; }

size_t asterism_sites_count(const asterism_sites* sites) {
  return sites == nullptr ? 0 : sites->all.size();
}

asterism_status asterism_sites_add(asterism_sites* sites, const double site[5]) {
  if (sites == nullptr || site == nullptr) return ASTERISM_NULL_POINTER;
  if (sites->all.size() == std::numeric_limits<vertex_index>::max()) return ASTERISM_OUT_OF_RANGE;
  return without_exceptions([&] {
    if (const asterism_status bad = append(*sites, site); bad != ASTERISM_OK) return bad;
    index_last(*sites);
    return ASTERISM_OK;
  });
}

asterism_status asterism_star_build(const asterism_sites* sites, size_t v, asterism_star** out) {
  if (sites == nullptr || out == nullptr) return ASTERISM_NULL_POINTER;
  if (v >= sites->all.size()) return ASTERISM_OUT_OF_RANGE;
  return without_exceptions([&] {
    const questioner of_sites(*sites);
    auto made = std::make_unique<asterism_star>();
    made->center = static_cast<vertex_index>(v);
    auto built = construct_star(of_sites.oracle(), made->center);
    made->content = std::move(built.content);
    made->settled = built.settled;
    *out = made.release();
    return ASTERISM_OK;
  });
}

void asterism_star_free(asterism_star* star) { delete star; }

asterism_status asterism_star_insert(const asterism_sites* sites, asterism_star* star, size_t w,
                                     int* changed) {
  if (sites == nullptr || star == nullptr || changed == nullptr) return ASTERISM_NULL_POINTER;
  const vertex_index v = star->center;
  if (w >= sites->all.size() || v >= sites->all.size()) return ASTERISM_OUT_OF_RANGE;
  return without_exceptions([&] {
    const auto site = static_cast<vertex_index>(w);
    bool is_new = false;
    if (site != v && !star->content.contains(site)) {
      const questioner of_sites(*sites);
      auto with = star->content;
      is_new = offer(of_sites.oracle(), v, with, site);
      std::swap(star->content, with);
    }
    *changed = is_new ? 1 : 0;
    return ASTERISM_OK;
  });
}

size_t asterism_star_center(const asterism_star* star) {
  return star == nullptr ? 0 : star->center;
}

const unsigned* asterism_star_neighbours(const asterism_star* star, size_t* count) {
  const bool has_any = star != nullptr && !star->content.sectors.empty();
  if (count != nullptr) *count = has_any ? star->content.sectors.front().size() : 0;
  return has_any ? star->content.sectors.front().neighbours.data() : nullptr;
}

int asterism_star_is_settled(const asterism_star* star) {
  return star != nullptr && star->settled ? 1 : 0;
}
