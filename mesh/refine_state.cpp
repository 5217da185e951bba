// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "asterism/mesh/constructions.hpp"
#include "asterism/mesh/refine_quality.hpp"

namespace asterism {

result<refine_state> refine_state::start(const domain& d, const metric_field& field,
                                         const star_kernel& kernel, std::size_t most_sites) {
  refine_state state(field, kernel, most_sites);
  for (const point& q : d.vertices) {
    const auto metric = field.at(q);
    if (!metric) return metric.failure();
    state.sites_.push_back({q, metric.value()});
  }
  auto edges = boundary::build(d, kernel);
  if (!edges) return edges.failure();
  state.edges_ = std::move(edges).value();
  state.find_corners();
  state.stars_.construct_all(state.oracle());
  for (std::size_t piece = 0; piece < state.edges_.pieces().size(); ++piece)
    state.suspects_.push_back(piece);
  return state;
}

void refine_state::find_corners() {
  for (index v = 0; v < sites_.size(); ++v) {
    const auto& at_v = edges_.corners(v);
    for (std::size_t i = 0; i < at_v.size(); ++i) {
      const point &first = sites_[at_v[i].first].position, &last = sites_[at_v[i].last].position;
      if (kernel_->orientation(sites_[v].position, first, last) == sign::positive)
        corners_.push_back({v, i, corner_angle(sites_[v], first, last)});
    }
  }
}

std::optional<site> refine_state::site_at(const point& q) {
  const auto metric = field_->at(q);
  if (metric) return site{q, metric.value()};
  if (!field_failure_) field_failure_ = metric.failure();
  return std::nullopt;
}

bool refine_state::strictly_inside(const point& q) const {
  return asterism::strictly_inside(edges_, sites_, *kernel_, q);
}

double refine_state::distance_to_sites(const site& s) const {
  double least = std::numeric_limits<double>::infinity();
  for (const site& other : sites_)
    least =
        std::min({least, squared_distance(other, s.position), squared_distance(s, other.position)});
  return std::sqrt(least);
}

void refine_state::add_interior(const site& s) {
  sites_.push_back(s);
  stars_.add_last(oracle());
  note_encroached_by(static_cast<index>(sites_.size() - 1));
}

std::array<std::size_t, 2> refine_state::pieces_at(const domain_corner& c) const {
  const boundary_corner ends = edges_.corners(c.vertex)[c.sector];
  const auto& pieces = edges_.pieces();
  const auto place = [&](index a, index b) {
    const auto at = std::find_if(pieces.begin(), pieces.end(),
                                 [&](const boundary_edge& p) { return p.a == a && p.b == b; });
    return static_cast<std::size_t>(at - pieces.begin());
  };
  return {place(c.vertex, ends.first), place(ends.last, c.vertex)};
}

double refine_state::piece_length(std::size_t piece, index from) const {
  const boundary_edge& p = edges_.pieces()[piece];
  const point &a = sites_[p.a].position, &b = sites_[p.b].position;
  const point d{b.x - a.x, b.y - a.y};
  return std::sqrt(inner_product(sites_[from].metric, d, d));
}

}  // namespace asterism
