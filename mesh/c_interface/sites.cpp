// SPDX-License-Identifier: MIT
#include "asterism/mesh/c_interface/sites.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <type_traits>

#include "asterism/kernels/c_question.hpp"
#include "asterism/mesh/c_interface/message_buffer.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/stars/split_place.hpp"
#include "asterism/mesh/stars/strictly_inside.hpp"

using namespace asterism;
using namespace asterism::internal;

static_assert(std::is_same_v<vertex_index, unsigned>);

namespace {

constexpr std::size_t most_sites = std::numeric_limits<vertex_index>::max();

asterism_status check_site(const double* numbers) {
  batch_record record{predicate::is_positive_definite, {}};
  std::copy(numbers + 2, numbers + 5, record.numbers.begin());
  if (!is_finite(numbers[0]) || !is_finite(numbers[1])) return ASTERISM_NOT_FINITE;
  const filtered_kernel kernel;
  if (const asterism_status bad = check_record(kernel, record); bad != ASTERISM_OK) return bad;
  return kernel.is_positive_definite(metric_at(record, 0)) ? ASTERISM_OK
                                                           : ASTERISM_NOT_POSITIVE_DEFINITE;
}

// Finds every fault of a new site, except for its place in the domain.
asterism_status check_new_site(const asterism_sites& sites, const double* numbers) {
  if (const asterism_status bad = check_site(numbers); bad != ASTERISM_OK) return bad;
  return sites.is_place_taken({numbers[0], numbers[1]}) ? ASTERISM_EQUAL_SITES : ASTERISM_OK;
}

void append(asterism_sites& sites, const double* n) {
  sites.all.reserve(sites.all.size() < sites.all.capacity() ? 0 : 2 * sites.all.size() + 1);
  sites.places.emplace(n[0], n[1]);
  sites.all.push_back({{n[0], n[1]}, {n[2], n[3], n[4]}});  // has room
}

asterism_status append_all(asterism_sites& sites, size_t count, const asterism_rows& rows) {
  sites.all.reserve(count);
  for (size_t k = 0; k < count; ++k) {
    const double* const numbers = rows.first + k * rows.stride;
    if (const asterism_status bad = check_new_site(sites, numbers); bad != ASTERISM_OK) return bad;
    append(sites, numbers);
  }
  return ASTERISM_OK;
}

bool is_in(const bounding_box& box, const point& p) {
  return box.low.x <= p.x && p.x <= box.high.x && box.low.y <= p.y && p.y <= box.high.y;
}

// Adds the last site to the index. If there is no memory for it, the index is dropped for good.
void index_last(asterism_sites& sites) {
  try {
    if (sites.near && is_in(sites.near->box(), sites.all.back().position))
      sites.near->add_site(sites.all, static_cast<vertex_index>(sites.all.size() - 1));
    else
      sites.near.emplace(sites.all, sites.edges);
  } catch (const std::bad_alloc&) {
    sites.near.reset();
  }
}

domain domain_around(const std::vector<site>& sites, const asterism_boundary& arrays) {
  domain d;
  d.origin.first_number = 0;
  for (const site& s : sites) d.vertices.push_back(s.position);
  for (size_t k = 0; k < arrays.segment_count; ++k)
    d.segments.push_back({arrays.segments[2 * k], arrays.segments[2 * k + 1]});
  for (size_t k = 0; k < arrays.hole_count; ++k)
    d.holes.push_back({arrays.holes[2 * k], arrays.holes[2 * k + 1]});
  return d;
}

// Makes the boundary; fails where check_domain does, and where a site is not inside the boundary.
result<boundary> boundary_of(const std::vector<site>& sites, const asterism_boundary& arrays) {
  if ((arrays.segments == nullptr && arrays.segment_count > 0) ||
      (arrays.holes == nullptr && arrays.hole_count > 0))
    return error{"an array of the boundary is null although its count is not 0"};
  const auto checked = check_domain(domain_around(sites, arrays));
  if (!checked) return checked.failure();
  const std::vector<point>& kept = checked.value().vertices;
  for (std::size_t k = 0; k < sites.size(); ++k)
    if (k >= kept.size() || !(kept[k] == sites[k].position))
      return error{"site " + std::to_string(k) + " is not inside the boundary"};
  tier_counters uncounted;
  return boundary::build(checked.value(), star_predicates_on<filtered_kernel>(uncounted));
}

// Returns the number of the subsegment between a and b in either direction; none if there is none.
std::optional<std::size_t> find_subsegment(const asterism_sites& sites, std::size_t a,
                                           std::size_t b) {
  if (a >= sites.all.size() || b >= sites.all.size()) return std::nullopt;
  std::optional<std::size_t> found;
  sites.near->subsegments().visit(box_of(sites.all[a].position, sites.all[b].position),
                                  [&](std::uint32_t i) {
                                    const boundary_edge& e = sites.edges.subsegments()[i];
                                    if ((e.a == a && e.b == b) || (e.a == b && e.b == a)) found = i;
                                    return !found;
                                  });
  return found;
}

// Splits a subsegment at a new site. The index is notified before the split and after it.
void split(asterism_sites& sites, std::size_t subsegment, const double* at) {
  const auto twin = sites.edges.twin(subsegment);
  const std::size_t first_new = sites.edges.subsegments().size();
  sites.broken = true;  // unless all of this succeeds
  sites.near->before_split(sites.all, sites.edges, subsegment);
  append(sites, at);
  const auto added = static_cast<vertex_index>(sites.all.size() - 1);
  sites.near->add_site(sites.all, added);
  sites.edges.split(subsegment, added);
  sites.near->after_split(sites.all, sites.edges, subsegment, twin, first_new);
  ++sites.splits;
  sites.broken = false;
}

}  // namespace

void asterism_boundary_init(asterism_boundary* boundary) {
  if (boundary != nullptr) *boundary = {0, nullptr, 0, nullptr};
}

asterism_status asterism_sites_create(size_t count, asterism_rows sites, asterism_sites** out) {
  if (out == nullptr || (sites.first == nullptr && count > 0)) return ASTERISM_NULL_POINTER;
  if (count > most_sites) return ASTERISM_OUT_OF_RANGE;
  return without_exceptions([&] {
    auto made = std::make_unique<asterism_sites>();
    if (const asterism_status bad = append_all(*made, count, sites); bad != ASTERISM_OK) return bad;
    made->near.emplace(made->all, made->edges);
    *out = made.release();
    return ASTERISM_OK;
  });
}

asterism_status asterism_sites_create_within(size_t count, asterism_rows sites,
                                             const asterism_boundary* boundary,
                                             asterism_sites** out, char* message, size_t capacity) {
  const message_buffer text(message, capacity);
  if (out == nullptr || boundary == nullptr || (sites.first == nullptr && count > 0))
    return ASTERISM_NULL_POINTER;
  if (count > most_sites) return ASTERISM_OUT_OF_RANGE;
  return without_exceptions([&] {
    auto made = std::make_unique<asterism_sites>();
    if (const asterism_status bad = append_all(*made, count, sites); bad != ASTERISM_OK) return bad;
    auto edges = boundary_of(made->all, *boundary);
    if (!edges) return text.refuse(edges.failure());
    made->edges = std::move(edges).value();
    made->near.emplace(made->all, made->edges);
    *out = made.release();
    return ASTERISM_OK;
  });
}

void asterism_sites_free(asterism_sites* sites) { delete sites; }

size_t asterism_sites_count(const asterism_sites* sites) {
  return sites == nullptr ? 0 : sites->all.size();
}

size_t asterism_sites_subsegment_count(const asterism_sites* sites) {
  return sites == nullptr ? 0 : sites->edges.subsegments().size();
}

asterism_status asterism_sites_subsegment(const asterism_sites* sites, size_t which,
                                          unsigned ends[2]) {
  if (sites == nullptr || ends == nullptr) return ASTERISM_NULL_POINTER;
  if (which >= sites->edges.subsegments().size()) return ASTERISM_OUT_OF_RANGE;
  const boundary_edge& e = sites->edges.subsegments()[which];
  ends[0] = e.a;
  ends[1] = e.b;
  return ASTERISM_OK;
}

asterism_status asterism_sites_add(asterism_sites* sites, const double site[5]) {
  if (sites == nullptr || site == nullptr) return ASTERISM_NULL_POINTER;
  if (sites->broken) return ASTERISM_OUT_OF_MEMORY;
  if (sites->all.size() == most_sites) return ASTERISM_OUT_OF_RANGE;
  return without_exceptions([&] {
    if (const asterism_status bad = check_new_site(*sites, site); bad != ASTERISM_OK) return bad;
    if (sites->is_bounded() &&
        !strictly_inside(sites->edges, sites->all, questioner(*sites).kernel(), {site[0], site[1]},
                         sites->near ? &*sites->near : nullptr))
      return ASTERISM_REFUSED;
    append(*sites, site);
    index_last(*sites);
    return ASTERISM_OK;
  });
}

asterism_status asterism_sites_split(asterism_sites* sites, size_t a, size_t b,
                                     const double site[5]) {
  if (sites == nullptr || site == nullptr) return ASTERISM_NULL_POINTER;
  if (sites->broken) return ASTERISM_OUT_OF_MEMORY;
  if (sites->all.size() == most_sites) return ASTERISM_OUT_OF_RANGE;
  return without_exceptions([&] {
    if (!sites->near) sites->near.emplace(sites->all, sites->edges);
    const auto subsegment = find_subsegment(*sites, a, b);
    if (!subsegment) return ASTERISM_OUT_OF_RANGE;
    if (const asterism_status bad = check_new_site(*sites, site); bad != ASTERISM_OK) return bad;
    if (!leaves_others_in_place(questioner(*sites).kernel(), sites->all, sites->edges, *sites->near,
                                sites->edges.subsegments()[*subsegment], {site[0], site[1]}))
      return ASTERISM_REFUSED;
    split(*sites, *subsegment, site);
    return ASTERISM_OK;
  });
}
