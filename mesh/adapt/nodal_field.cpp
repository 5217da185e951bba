// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/nodal_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "asterism/mesh/adapt/working_mesh.hpp"

namespace asterism::internal::adapting {
namespace {

bounding_box box_around(const std::vector<site>& sites) {
  bounding_box box{sites[0].position, sites[0].position};
  for (const site& s : sites) {
    box.low = {std::min(box.low.x, s.position.x), std::min(box.low.y, s.position.y)};
    box.high = {std::max(box.high.x, s.position.x), std::max(box.high.y, s.position.y)};
  }
  return box;
}

double doubled_area(const point& a, const point& b, const point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

nodal_field::nodal_field(const mesh& background)
    : boxes_(box_around(background.sites)), box_(box_around(background.sites)) {
  std::vector<metric_tensor> tensors;
  for (const site& s : background.sites) {
    places_.push_back(s.position);
    tensors.push_back(s.metric);
  }
  set_tensors(std::move(tensors));
  for (const triangle& t : background.triangles) {
    const point &a = places_[t[0]], &b = places_[t[1]], &c = places_[t[2]];
    if (!(doubled_area(a, b, c) > 0)) continue;
    bounding_box around = box_of(a, b);
    around.low = {std::min(around.low.x, c.x), std::min(around.low.y, c.y)};
    around.high = {std::max(around.high.x, c.x), std::max(around.high.y, c.y)};
    boxes_.insert(static_cast<std::uint32_t>(cells_.size()), around);
    cells_.push_back({t, {}});
  }
  link();
}

void nodal_field::set_tensors(std::vector<metric_tensor> tensors) {
  tensors_ = std::move(tensors);
  logarithms_.clear();
  for (const metric_tensor& m : tensors_) logarithms_.push_back(logarithm(m));
}

void nodal_field::link() {
  std::vector<std::tuple<vertex_index, vertex_index, vertex_index, vertex_index>>
      sides;  // low, high, cell, edge
  for (vertex_index t = 0; t < cells_.size(); ++t)
    for (vertex_index i = 0; i < 3; ++i) {
      const vertex_index a = cells_[t].v[after(i)], b = cells_[t].v[before(i)];
      sides.emplace_back(std::min(a, b), std::max(a, b), t, i);
      cells_[t].next[i] = t;
    }
  std::sort(sides.begin(), sides.end());
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
    const auto& [a, b, t, i] = sides[k];
    const auto& [c, d, s, j] = sides[k + 1];
    if (a != c || b != d) continue;
    cells_[t].next[i] = s;
    cells_[s].next[j] = t;
  }
}

double nodal_field::least_weight(const point& q, vertex_index t, double (&w)[3]) const {
  const triangle& v = cells_[t].v;
  const point &a = places_[v[0]], &b = places_[v[1]], &c = places_[v[2]];
  const double whole = doubled_area(a, b, c);
  w[0] = doubled_area(q, b, c) / whole;
  w[1] = doubled_area(a, q, c) / whole;
  w[2] = 1 - w[0] - w[1];
  return std::min({w[0], w[1], w[2]});
}

// Walks to the point; true if it ended in a triangle that has the point.
bool nodal_field::walk(const point& q, vertex_index& t, double (&w)[3]) const {
  // Roundings of a weight are a few 1e-16 in a triangle that is not thin. Only the choice between
  // neighbours depends on it, which agree at their common edge.
  constexpr double slack = 1e-12;
  const std::size_t most = 64 + 4 * static_cast<std::size_t>(std::sqrt(cells_.size()));
  for (std::size_t step = 0; step < most; ++step) {
    if (least_weight(q, t, w) >= -slack) return true;
    const std::size_t i = w[0] <= w[1] && w[0] <= w[2] ? 0 : w[1] <= w[2] ? 1 : 2;
    if (cells_[t].next[i] == t) return false;
    t = cells_[t].next[i];
  }
  return false;
}

// Searches around the point first, then farther and farther.
vertex_index nodal_field::search(const point& q, double (&w)[3]) const {
  double half = 0;
  const double extent = std::max(box_.high.x - box_.low.x, box_.high.y - box_.low.y);
  for (int i = 0; i < 64; ++i) {
    double deepest = -std::numeric_limits<double>::infinity();
    vertex_index found = none;
    boxes_.visit({{q.x - half, q.y - half}, {q.x + half, q.y + half}}, [&](std::uint32_t t) {
      ++looked_at_;
      const double depth = least_weight(q, t, w);
      if (depth > deepest || (depth == deepest && t < found)) {
        deepest = depth;
        found = t;
      }
      return true;
    });
    if (found != none) {
      least_weight(q, found, w);
      return found;
    }
    half = half == 0 ? std::ldexp(extent, -50) : 2 * half;
  }
  least_weight(q, 0, w);
  return 0;
}

vertex_index nodal_field::locate(const point& q, vertex_index hint, double (&w)[3]) const {
  vertex_index t = hint < cells_.size() ? hint : 0;
  if (!walk(q, t, w)) t = search(q, w);
  for (double& x : w) x = std::max(0.0, x);
  return t;
}

metric_tensor nodal_field::mean(vertex_index t, const double (&w)[3]) const {
  double sum = 0;
  for (const double x : w) sum += x;
  tensor_logarithm l;
  for (std::size_t i = 0; i < 3; ++i) {
    const tensor_logarithm& own = logarithms_[cells_[t].v[i]];
    l.l11 += w[i] / sum * own.l11;
    l.l12 += w[i] / sum * own.l12;
    l.l22 += w[i] / sum * own.l22;
  }
  return exponential(l);
}

metric_tensor nodal_field::at(const point& q, vertex_index& hint) const {
  double w[3];
  hint = locate(q, hint, w);
  return mean(hint, w);
}

std::optional<metric_tensor> nodal_field::where_other(const nodal_field& than, const point& q,
                                                      vertex_index hint) const {
  double w[3];
  const vertex_index t = locate(q, hint, w);
  const auto is_same = [&](vertex_index v) { return identical(tensors_[v], than.tensors_[v]); };
  if (std::all_of(cells_[t].v.begin(), cells_[t].v.end(), is_same)) return std::nullopt;
  const metric_tensor own = mean(t, w);
  return identical(own, than.mean(t, w)) ? std::nullopt : std::optional(own);
}

std::vector<graph_edge> nodal_field::edges() const {
  std::vector<graph_edge> found;
  for (vertex_index t = 0; t < cells_.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      if (cells_[t].next[i] >= t) found.push_back({cells_[t].v[after(i)], cells_[t].v[before(i)]});
  return found;
}

double nodal_field::complexity() const {
  double sum = 0;
  for (const cell& c : cells_) {
    const double area = doubled_area(places_[c.v[0]], places_[c.v[1]], places_[c.v[2]]) / 2;
    for (const vertex_index v : c.v) sum += area / 3 * root_of_determinant(tensors_[v]);
  }
  return sum;
}

}  // namespace asterism::internal::adapting
