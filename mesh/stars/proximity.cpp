// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/proximity.hpp"

#include <cmath>
#include <limits>

#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/ill_conditioned_metric.hpp"
#include "asterism/mesh/numerics/metric_box.hpp"
#include "asterism/mesh/search/hilbert_order.hpp"
#include "asterism/mesh/support/prefetch.hpp"

namespace asterism::internal {
namespace {

bounding_box subsegment_box(const std::vector<site>& sites, const boundary_edge& subsegment) {
  return box_of(sites[subsegment.a].position, sites[subsegment.b].position);
}

}  // namespace

proximity::proximity(const std::vector<site>& sites, const boundary& edges)
    : box_(box_of_sites(sites)),
      order_(order_along_curve(sites, box_)),
      along_curve_(order_.size()),
      sites_(box_),
      subsegments_(box_),
      influences_(box_) {
  // Inserts along a curve: nodes near each other in the plane are then near each other in memory.
  for (std::size_t i = 0; i < order_.size(); ++i) {
    if (i + triangles_ahead < order_.size()) prefetch(&sites[order_[i + triangles_ahead]]);
    sites_.insert(sites, order_[i]);
  }
  for (std::size_t subsegment = 0; subsegment < edges.subsegments().size(); ++subsegment)
    insert_subsegment(sites, edges, subsegment);
}

std::vector<vertex_index> proximity::order_anew(const std::vector<site>& sites) const {
  constexpr std::size_t one_in = 16;
  std::vector<vertex_index> order = order_;
  if (one_in * (order.size() - along_curve_) > order.size()) sort_along_curve(order, sites, box_);
  return order;
}

void proximity::insert_subsegment(const std::vector<site>& sites, const boundary& edges,
                                  std::size_t subsegment) {
  const boundary_edge& e = edges.subsegments()[subsegment];
  subsegments_.insert(static_cast<std::uint32_t>(subsegment), subsegment_box(sites, e));
  influences_.insert(static_cast<std::uint32_t>(subsegment), influence_box(sites[e.a], sites[e.b]));
}

void proximity::remove_subsegment(const std::vector<site>& sites, const boundary& edges,
                                  std::size_t subsegment) {
  const boundary_edge& e = edges.subsegments()[subsegment];
  subsegments_.remove(static_cast<std::uint32_t>(subsegment), subsegment_box(sites, e));
  influences_.remove(static_cast<std::uint32_t>(subsegment), influence_box(sites[e.a], sites[e.b]));
}

void proximity::before_split(const std::vector<site>& sites, const boundary& edges,
                             std::size_t subsegment) {
  remove_subsegment(sites, edges, subsegment);
  if (const auto twin = edges.twin(subsegment)) remove_subsegment(sites, edges, *twin);
}

void proximity::after_split(const std::vector<site>& sites, const boundary& edges,
                            std::size_t subsegment, std::optional<std::size_t> twin,
                            std::size_t first_new) {
  insert_subsegment(sites, edges, subsegment);
  if (twin) insert_subsegment(sites, edges, *twin);
  for (; first_new < edges.subsegments().size(); ++first_new)
    insert_subsegment(sites, edges, first_new);
}

}  // namespace asterism::internal
