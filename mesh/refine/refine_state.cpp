// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/refine_state.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/metric_box.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/stars/work_limit.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {

result<refine_state> refine_state::prepare(const domain& d, const metric_field& field,
                                           const star_predicates& kernel, std::size_t most_sites) {
  refine_state state(field, kernel, most_sites);
  for (const point& q : d.vertices) {
    const auto metric = field.at(q);
    if (!metric) return metric.failure();
    state.sites_.push_back({q, metric.value()});
  }
  auto edges = boundary::build(d, kernel);
  if (!edges) return edges.failure();
  state.edges_ = std::move(edges).value();
  state.near_ = neighbourhood(state.sites_, state.edges_);
  state.find_corners();
  state.find_wedges();
  state.given_ = d.vertices.size();
  return state;
}

void refine_state::construct_stars() {
  stars_.bound_work(given_);
  stars_.construct_all(oracle());
  for (std::size_t subsegment = 0; subsegment < edges_.subsegments().size(); ++subsegment)
    suspects_.push_back(subsegment);
}

result<refine_state> refine_state::start(const domain& d, const metric_field& field,
                                         const star_predicates& kernel, std::size_t most_sites) {
  auto state = prepare(d, field, kernel, most_sites);
  if (state) state.value().construct_stars();
  return state;
}

result<refine_state> refine_state::start_filled(const domain& d, const metric_field& field,
                                                const star_predicates& kernel,
                                                std::size_t most_sites,
                                                const filled_domain& filling,
                                                const cancellation& cancelled) {
  auto state = prepare(d, field, kernel, most_sites);
  if (!state) return state;
  state.value().stars_.cancel_by(cancelled);
  state.value().cancelled_ = cancelled;
  state.value().divide(d, filling);
  state.value().add_proposed(filling.interior);
  state.value().construct_stars();
  return state;
}

// A point that rounding puts on the wrong side of something is left out.
void refine_state::divide(const domain& d, const filled_domain& filling) {
  for (std::size_t s = 0; s < d.segments.size(); ++s) {
    std::size_t subsegment = find_subsegment(d.segments[s].a, d.segments[s].b);
    for (const site& m : filling.divisions[s]) {
      if (is_full()) return;
      const std::size_t first_new = edges_.subsegments().size();
      if (!can_split_at(edges_.subsegments()[subsegment], m, 0)) continue;
      put_on_subsegment(subsegment, m);
      subsegment = first_new;
    }
  }
}

void refine_state::add_proposed(const std::vector<site>& proposed) {
  constexpr std::size_t chunk = 256;
  const std::vector<char> fits = collect_chunks<char>(
      proposed.size(), chunk, [&](std::size_t begin, std::size_t end, std::vector<char>& out) {
        const auto kernel = kernel_->fork();
        for (std::size_t i = begin; i < end; ++i)
          out.push_back(strictly_inside_near(*kernel, proposed[i].position) &&
                        encroached_by(*kernel, proposed[i]).empty());
      });
  for (std::size_t i = 0; i < proposed.size() && !is_full(); ++i) {
    if (fits[i] == 0) continue;
    sites_.push_back(proposed[i]);
    near_.add_site(sites_, static_cast<vertex_index>(sites_.size() - 1));
  }
}

bool refine_state::is_overworked() const {
  return part_of_work_bound(kernel_->counters(), sites_.size(), given_) > 1;
}

void refine_state::find_corners() {
  for (vertex_index v = 0; v < sites_.size(); ++v) {
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
  return strictly_inside_near(*kernel_, q);
}

bool refine_state::strictly_inside_near(const star_predicates& kernel, const point& q) const {
  return asterism::internal::strictly_inside(edges_, sites_, kernel, q, &near_);
}

bool refine_state::is_farther(const site& s, double distance) const {
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

void refine_state::add_interior(const site& s) {
  sites_.push_back(s);
  const auto added = static_cast<vertex_index>(sites_.size() - 1);
  near_.add_site(sites_, added);
  stars_.add_last(oracle());
  note_encroached_by(added);
}

void refine_state::add_interior_later(const site& s) {
  sites_.push_back(s);
  near_.add_site(sites_, static_cast<vertex_index>(sites_.size() - 1));
}

void refine_state::add_stars() {
  const vertex_index first = stars_.size();
  stars_.add_many(oracle(), first);
  for (vertex_index w = first; w < sites_.size(); ++w) note_encroached_by(w);
}

std::span<const domain_corner> refine_state::corners_at(vertex_index v) const {
  const auto [first, last] = std::equal_range(
      corners_.begin(), corners_.end(), domain_corner{v, 0, 0},
      [](const domain_corner& a, const domain_corner& b) { return a.vertex < b.vertex; });
  return {first, last};
}

// Requires that there is such a subsegment.
std::size_t refine_state::find_subsegment(vertex_index a, vertex_index b) const {
  std::size_t found = edges_.subsegments().size();
  near_.subsegments().visit(box_of(sites_[a].position, sites_[b].position), [&](std::uint32_t i) {
    const boundary_edge& p = edges_.subsegments()[i];
    if (p.a == a && p.b == b) found = i;
    return found != i;
  });
  return found;
}

std::array<std::size_t, 2> refine_state::subsegments_at(const domain_corner& c) const {
  const boundary_corner ends = edges_.corners(c.vertex)[c.sector];
  return {find_subsegment(c.vertex, ends.first), find_subsegment(ends.last, c.vertex)};
}

double refine_state::subsegment_length(std::size_t subsegment, vertex_index from) const {
  const boundary_edge& p = edges_.subsegments()[subsegment];
  const point &a = sites_[p.a].position, &b = sites_[p.b].position;
  const point d{b.x - a.x, b.y - a.y};
  return std::sqrt(squared_length(sites_[from].metric, d));
}

}  // namespace asterism::internal
