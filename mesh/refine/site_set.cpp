// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/site_set.hpp"

#include <numeric>

#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/metric_box.hpp"
#include "asterism/mesh/search/hilbert_order.hpp"

namespace asterism::internal {

result<site_set> site_set::start(const domain& d, const metric_field& field,
                                 std::size_t most_sites) {
  site_set set(field, most_sites);
  set.reserve(d.vertices.size());
  for (const point& q : d.vertices) {
    const auto metric = field.at(q);
    if (!metric) return metric.failure();
    set.push({q, metric.value()});
  }
  return set;
}

std::optional<site> site_set::site_at(const point& q) {
  const auto metric = field_->at(q);
  if (metric) return site{q, metric.value()};
  if (!field_failure_) field_failure_ = metric.failure();
  return std::nullopt;
}

bool site_set::is_farther(const site& s, double distance) const {
  const double squared = distance * distance;
  const auto far_as_seen = [&](vertex_index w) {
    return squared_distance(sites_[w], s.position) > squared;
  };
  const auto far_as_it_sees = [&](vertex_index w) {
    return squared_distance(s, sites_[w].position) > squared;
  };
  constexpr double margin = 1 + 0x1p-20;  // the box is not rigorous
  const bounding_box box = box_around(s, margin * distance);
  return near_.sites().visit_box(sites_, box.low, box.high, far_as_it_sees) &&
         near_.sites().visit_seeing(s.position, distance, far_as_seen);
}

vertex_index site_set::add(const site& s) {
  push(s);
  const auto added = static_cast<vertex_index>(sites_.size() - 1);
  near_.add_site(sites_, added);
  return added;
}

std::vector<vertex_index> site_set::number_along_curve(const std::vector<vertex_index>& which) {
  std::vector<vertex_index> sorted = which, to(sites_.size());
  sort_along_curve(sorted, sites_, near_.box());
  std::vector<site> moved;
  moved.reserve(sorted.size());
  for (const vertex_index v : sorted) moved.push_back(sites_[v]);
  std::iota(to.begin(), to.end(), vertex_index{0});
  for (std::size_t i = 0; i < which.size(); ++i) {
    sites_[which[i]] = moved[i];
    to[sorted[i]] = which[i];
  }
  near_.renumber(to);
  return to;
}

}  // namespace asterism::internal
