// SPDX-License-Identifier: MIT
#include "asterism/mesh/local/neighbourhood.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "asterism/mesh/constructions.hpp"
#include "asterism/mesh/thin_metric.hpp"

namespace asterism {
namespace {

bounding_box box_of_sites(const std::vector<site>& sites) {
  if (sites.empty()) return {};
  bounding_box box{sites[0].position, sites[0].position};
  for (const site& s : sites) {
    const point& q = s.position;
    box.low = {std::min(box.low.x, q.x), std::min(box.low.y, q.y)};
    box.high = {std::max(box.high.x, q.x), std::max(box.high.y, q.y)};
  }
  return box;
}

bounding_box piece_box(const std::vector<site>& sites, const boundary_edge& piece) {
  return box_of(sites[piece.a].position, sites[piece.b].position);
}

}  // namespace

neighbourhood::neighbourhood(const std::vector<site>& sites, const boundary& edges)
    : box_(box_of_sites(sites)), sites_(box_), pieces_(box_), influences_(box_) {
  for (index w = 0; w < sites.size(); ++w) sites_.insert(sites, w);
  for (std::size_t piece = 0; piece < edges.pieces().size(); ++piece)
    insert_piece(sites, edges, piece);
}

void neighbourhood::insert_piece(const std::vector<site>& sites, const boundary& edges,
                                 std::size_t piece) {
  const boundary_edge& e = edges.pieces()[piece];
  pieces_.insert(static_cast<std::uint32_t>(piece), piece_box(sites, e));
  influences_.insert(static_cast<std::uint32_t>(piece), influence_box(sites[e.a], sites[e.b]));
}

void neighbourhood::remove_piece(const std::vector<site>& sites, const boundary& edges,
                                 std::size_t piece) {
  const boundary_edge& e = edges.pieces()[piece];
  pieces_.remove(static_cast<std::uint32_t>(piece), piece_box(sites, e));
  influences_.remove(static_cast<std::uint32_t>(piece), influence_box(sites[e.a], sites[e.b]));
}

void neighbourhood::before_split(const std::vector<site>& sites, const boundary& edges,
                                 std::size_t piece) {
  remove_piece(sites, edges, piece);
  if (const auto twin = edges.twin(piece)) remove_piece(sites, edges, *twin);
}

void neighbourhood::after_split(const std::vector<site>& sites, const boundary& edges,
                                std::size_t piece, std::optional<std::size_t> twin,
                                std::size_t first_new) {
  insert_piece(sites, edges, piece);
  if (twin) insert_piece(sites, edges, *twin);
  for (; first_new < edges.pieces().size(); ++first_new) insert_piece(sites, edges, first_new);
}

bounding_box influence_box(const site& a, const site& b) {
  constexpr double lengths = 1.5;
  bounding_box box = box_of(a.position, b.position);
  for (const site* s : {&a, &b}) {
    const point& other = s == &a ? b.position : a.position;
    const bounding_box around = box_around(*s, lengths * std::sqrt(squared_distance(*s, other)));
    box.low = {std::min(box.low.x, around.low.x), std::min(box.low.y, around.low.y)};
    box.high = {std::max(box.high.x, around.high.x), std::max(box.high.y, around.high.y)};
  }
  return box;
}

// With f the metric's quadratic form, the least of f over all displacements with the same dx is
// (m11 - m12^2 / m22) dx^2.
bounding_box box_around(const site& s, double distance) {
  const metric_tensor& m = s.metric;
  const bool thin = is_thin(m);
  const auto half_width = [distance, thin](double own, double mixed, double other) {
    const double least = thin ? least_across(own, mixed, other) : own - mixed * (mixed / other);
    const double width = distance / std::sqrt(least);
    return width >= 0 ? width : std::numeric_limits<double>::infinity();
  };
  const double x = half_width(m.m11, m.m12, m.m22), y = half_width(m.m22, m.m12, m.m11);
  const point& q = s.position;
  return {{q.x - x, q.y - y}, {q.x + x, q.y + y}};
}

}  // namespace asterism
