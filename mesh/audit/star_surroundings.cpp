// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/star_surroundings.hpp"

#include <algorithm>
#include <cmath>

namespace asterism::internal::audit_detail {
namespace {

site scaled(const site& s, int places, int metrics) {
  const auto& [q, m] = s;
  return {{std::scalbn(q.x, places), std::scalbn(q.y, places)},
          {std::scalbn(m.m11, metrics), std::scalbn(m.m12, metrics), std::scalbn(m.m22, metrics)}};
}

// Returns the sites in about unit size, where doubles can decide: scales very large and very small
// ones by powers of two, positions by one and metrics by another, which changes the answer to no
// question about stars. Empty if that is not needed, or not exact for every site. Sets `of_squares`
// to the exponent that squares of lengths are scaled by.
std::vector<site> in_unit_size(const std::vector<site>& sites, int& of_squares) {
  constexpr int ordinary = 64;
  double reach = 0, steepest = 0;
  for (const site& s : sites) {
    reach = std::max({reach, std::abs(s.position.x), std::abs(s.position.y)});
    steepest = std::max({steepest, s.metric.m11, s.metric.m22});
  }
  if (!(reach > 0 && steepest > 0)) return {};
  const int places = -std::ilogb(reach), metrics = -std::ilogb(steepest);
  if (std::abs(places) <= ordinary && std::abs(metrics) <= ordinary) return {};
  std::vector<site> unit;
  unit.reserve(sites.size());
  for (const site& s : sites) {
    unit.push_back(scaled(s, places, metrics));
    if (!(scaled(unit.back(), -places, -metrics) == s)) return {};
  }
  of_squares = 2 * places + metrics;
  return unit;
}

std::vector<site> sites_of(const std::vector<vertex_index>* vertices, const std::vector<site>& at) {
  std::vector<site> all;
  if (vertices != nullptr)
    for (const vertex_index v : *vertices) all.push_back(at[v]);
  return all;
}

}  // namespace

star_surroundings::star_surroundings(const audit_context& context)
    : unit(in_unit_size(context.subject.sites, power_of_squares)),
      at(unit.empty() ? context.subject.sites : unit),
      changed_list(sites_of(context.changed, at)),
      changed_sites(changed_list),
      subsegments(context) {
  if (context.changed == nullptr) return;
  is_changed.assign(at.size(), 0);
  is_near.assign(at.size(), 0);
  for (const vertex_index v : *context.changed) {
    is_changed[v] = is_near[v] = 1;
    for (std::size_t i = context.edge_start[v]; i < context.edge_start[v + 1]; ++i)
      is_near[context.edges[i].b] = is_near[context.edges[i].apex] = 1;
  }
}

}  // namespace asterism::internal::audit_detail
