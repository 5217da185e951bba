// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/unit_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "asterism/core/elementary.hpp"

namespace asterism::internal::adapting {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double root3 = std::numbers::sqrt3;
constexpr double weight_of_size = 0.3, weight_of_low = 0.5;
// Energy of shape from which a triangle is poor: one with an angle of 25 degrees has this or more.
constexpr double poor = 1.5;

struct long_edge {
  double length;
  vertex_index a, b;
};

bool longer(const long_edge& p, const long_edge& q) {
  return p.length != q.length ? p.length > q.length : p.a != q.a ? p.a < q.a : p.b < q.b;
}

// Returns the edges for which `wanted(length)`, longest first.
template <class Wanted>
std::vector<long_edge> edges_where(const working_mesh& m, Wanted&& wanted) {
  std::vector<long_edge> found;
  for (const face& f : m.faces()) {
    if (!f.exists()) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const vertex_index a = f.v[after(i)], b = f.v[before(i)];
      if (f.next[i] != none && a > b) continue;
      const double length = m.length(a, b);
      if (wanted(length)) found.push_back({length, std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(found.begin(), found.end(), longer);
  return found;
}

// Returns the face with the edge from a to b on its border, and which of its edges that is.
std::pair<vertex_index, std::size_t> find_edge(const working_mesh& m, vertex_index a,
                                               vertex_index b) {
  face_list at;
  m.around(a, at);
  for (const vertex_index t : at) {
    const face& f = m.faces()[t];
    const std::size_t i = f.corner_of(a);
    if (f.v[after(i)] == b) return {t, before(i)};
    if (f.v[before(i)] == b) return {t, after(i)};
  }
  return {none, 0};
}

// Returns the place half way from a to b in a metric that changes geometrically between them.
point middle(const node& a, const node& b) {
  const double x = b.position.x - a.position.x, y = b.position.y - a.position.y;
  const double ratio = std::sqrt(squared(b.metric, x, y) / squared(a.metric, x, y));
  double t = 0.5;
  if (std::isfinite(ratio) && ratio > 0 && std::abs(ratio - 1) > 1e-3)
    t = std::clamp(elementary::log((1 + ratio) / 2) / elementary::log(ratio), 0.25, 0.75);
  return {a.position.x + t * x, a.position.y + t * y};
}

}  // namespace

double shape_energy(const node& a, const node& b, const node& c, double unit) {
  if (!turns_left(a.position, b.position, c.position)) return infinity;
  const double ux = b.position.x - a.position.x, uy = b.position.y - a.position.y;
  const double wx = c.position.x - a.position.x, wy = c.position.y - a.position.y;
  const double vx = wx - ux, vy = wy - uy;
  const double twice = ux * wy - uy * wx;
  // The squares of the sides, summed over the three.
  const double xx = ux * ux + wx * wx + vx * vx, xy = ux * uy + wx * wy + vx * vy,
               yy = uy * uy + wy * wy + vy * vy;
  double shape = 0;
  for (const node* n : {&a, &b, &c}) {
    const metric_tensor& m = n->metric;
    const double q = (m.m11 * xx + 2 * m.m12 * xy + m.m22 * yy) / (2 * root3 * twice * n->root);
    const double beyond = std::max(0.0, q - poor);
    shape += q + weight_of_low * beyond * beyond;
  }
  if (unit <= 0) return shape / 3;
  const double size = twice * (a.root + b.root + c.root) / (3 * root3 / 2 * unit * unit);
  return shape / 3 + weight_of_size * (size + 1 / size - 2);
}

double unit_mesher::energy(vertex_index t) const {
  const face& f = m_.faces()[t];
  return shape_energy(m_.at(f.v[0]), m_.at(f.v[1]), m_.at(f.v[2]), unit_);
}

double unit_mesher::energy_around(const face_list& at) const {
  double sum = 0;
  for (const vertex_index t : at) sum += energy(t);
  return sum;
}

bool unit_mesher::flip_if_better(vertex_index t, std::size_t edge) {
  if (!m_.can_flip(t, edge)) return false;
  const face& f = m_.faces()[t];
  const face& g = m_.faces()[f.next[edge]];
  const node &c = m_.at(f.v[edge]), &a = m_.at(f.v[after(edge)]), &b = m_.at(f.v[before(edge)]);
  const node& d = m_.at(g.v[after(g.corner_of(f.v[after(edge)]))]);
  const double now = shape_energy(c, a, b, 0) + shape_energy(d, b, a, 0);
  const double then = shape_energy(c, a, d, 0) + shape_energy(d, b, c, 0);
  constexpr double margin = 1e-6;
  if (!(then < now * (1 - margin))) return false;
  m_.flip(t, edge);
  return true;
}

// Flips from v outwards until nothing gets better.
void unit_mesher::settle_around(vertex_index v) {
  face_list at;
  constexpr int most = 8;
  for (int round = 0; round < most; ++round) {
    bool any = false;
    m_.around(v, at);
    for (const vertex_index t : at) {
      const face& f = m_.faces()[t];
      if (f.v[0] != v && f.v[1] != v && f.v[2] != v) continue;
      any = flip_if_better(t, f.corner_of(v)) || any;
    }
    if (!any) return;
  }
}

vertex_index unit_mesher::locate(const point& q, vertex_index from) const {
  vertex_index t = from;
  const std::size_t most = 100 + m_.faces().size();
  for (std::size_t step = 0; step < most; ++step) {
    const face& f = m_.faces()[t];
    vertex_index next = t;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + step) % 3;
      const point &a = m_.at(f.v[after(i)]).position, &b = m_.at(f.v[before(i)]).position;
      if ((b.x - a.x) * (q.y - a.y) - (b.y - a.y) * (q.x - a.x) >= 0) continue;
      if (f.next[i] == none) return none;
      next = f.next[i];
      break;
    }
    if (next == t) return t;
    t = next;
  }
  return none;
}

void unit_mesher::seed(const std::vector<point>& seeds) {
  constexpr double room = 0.8;
  vertex_index from = 0, hint = 0;
  for (const point& q : seeds) {
    if (m_.nodes().size() >= options_.most_nodes) return;
    const vertex_index t = locate(q, from);
    if (t == none) continue;
    from = t;
    node there;
    there.position = q;
    there.metric = field_(q, hint);
    const face& f = m_.faces()[t];
    bool crowded = false;
    for (const vertex_index v : f.v) {
      const node& n = m_.at(v);
      const double x = n.position.x - q.x, y = n.position.y - q.y;
      const double least = room * room * unit_ * unit_;
      crowded = crowded || squared(there.metric, x, y) < least || squared(n.metric, x, y) < least;
    }
    if (crowded) continue;
    const auto made = m_.insert(t, q);
    if (!made) continue;
    m_.at(*made).hint = hint;
    m_.set_metric(*made, there.metric);
    settle_around(*made);
    from = m_.at(*made).face;
  }
}

std::size_t unit_mesher::split_long(double longest) {
  std::size_t done = 0;
  const double shortest = 0.55 * unit_;
  for (const long_edge& e : edges_where(m_, [&](double l) { return l > longest; })) {
    if (m_.nodes().size() >= options_.most_nodes) return done;
    const auto [t, edge] = find_edge(m_, e.a, e.b);
    if (t == none || !(m_.length(e.a, e.b) > longest)) continue;
    const face& f = m_.faces()[t];
    point q = middle(m_.at(e.a), m_.at(e.b));
    node there;
    there.position = q;
    there.hint = m_.at(e.a).hint;
    there.metric = field_(q, there.hint);
    // Not so near to the nodes across that it would have to go again.
    bool crowded = false;
    for (const vertex_index s : {t, f.next[edge]}) {
      if (s == none) continue;
      const face& g = m_.faces()[s];
      const std::size_t across = g.v[0] != e.a && g.v[0] != e.b   ? 0
                                 : g.v[1] != e.a && g.v[1] != e.b ? 1
                                                                  : 2;
      const node& n = m_.at(g.v[across]);
      const double x = n.position.x - q.x, y = n.position.y - q.y;
      crowded = crowded || (squared(there.metric, x, y) < shortest * shortest &&
                            e.length < 2 * longest && f.segment[edge] == none);
    }
    if (crowded) continue;
    const auto made = m_.split(t, edge, q);
    if (!made) continue;
    m_.at(*made).hint = there.hint;
    m_.set_metric(*made, there.metric);
    settle_around(*made);
    ++done;
  }
  return done;
}

bool unit_mesher::merge_if_good(vertex_index v, vertex_index w, double longest) {
  if (!m_.can_merge(v, w)) return false;
  face_list at;
  m_.neighbours(v, at);
  for (const vertex_index u : at)
    if (u != w && m_.length(w, u) > longest) return false;
  m_.around(v, at);
  double worst_before = 0, worst = 0;
  for (const vertex_index t : at) {
    const face& f = m_.faces()[t];
    worst_before = std::max(worst_before, energy(t));
    const std::size_t i = f.corner_of(v);
    const vertex_index a = f.v[after(i)], b = f.v[before(i)];
    if (a != w && b != w)
      worst = std::max(worst, shape_energy(m_.at(w), m_.at(a), m_.at(b), unit_));
  }
  constexpr double acceptable = 2.5;
  if (worst > std::max(acceptable, worst_before)) return false;
  face_list ring;
  m_.neighbours(v, ring);
  m_.merge(v, w);
  settle_around(w);
  return true;
}

std::size_t unit_mesher::merge_short(double shortest) {
  std::size_t done = 0;
  std::vector<long_edge> found = edges_where(m_, [&](double l) { return l < shortest; });
  std::reverse(found.begin(), found.end());
  for (const long_edge& e : found) {
    if (m_.at(e.a).kind == node_kind::gone || m_.at(e.b).kind == node_kind::gone) continue;
    if (find_edge(m_, e.a, e.b).first == none || !(m_.length(e.a, e.b) < shortest)) continue;
    const double longest = std::numbers::sqrt2 * unit_;
    if (merge_if_good(e.b, e.a, longest) || merge_if_good(e.a, e.b, longest)) ++done;
  }
  return done;
}

std::size_t unit_mesher::flip_all() {
  std::size_t done = 0;
  constexpr int most = 20;
  for (int round = 0; round < most; ++round) {
    std::size_t now = 0;
    for (vertex_index t = 0; t < m_.faces().size(); ++t)
      for (std::size_t i = 0; i < 3 && m_.faces()[t].exists(); ++i)
        if (m_.faces()[t].next[i] > t && flip_if_better(t, i)) ++now;
    done += now;
    if (now == 0) break;
  }
  return done;
}

// Returns the place the triangles around v would have it at: above the edge across from it, as high
// as an equilateral one is, poor triangles counting more.
point unit_mesher::pulled(vertex_index v, const face_list& at) const {
  double x = 0, y = 0, weights = 0;
  for (const vertex_index t : at) {
    const face& f = m_.faces()[t];
    const std::size_t i = f.corner_of(v);
    const node &a = m_.at(f.v[after(i)]), &b = m_.at(f.v[before(i)]);
    const metric_tensor m{a.metric.m11 + b.metric.m11, a.metric.m12 + b.metric.m12,
                          a.metric.m22 + b.metric.m22};
    const double root = root_of_determinant(m);
    const double ex = b.position.x - a.position.x, ey = b.position.y - a.position.y;
    const double length = std::sqrt(squared(m, ex, ey) / 2);
    if (!(root > 0 && length > 0)) continue;
    // The quarter turn as m sees it, sqrt(det m) m^-1 J, to the height of a unit triangle's and of
    // one that stands on this edge, half each.
    const double height = root3 / 4 * (1 + unit_ / length);
    const double tx = (-m.m22 * ey - m.m12 * ex) / root, ty = (m.m12 * ey + m.m11 * ex) / root;
    const double w = energy(t);
    x += w * (a.position.x + ex / 2 + height * tx);
    y += w * (a.position.y + ey / 2 + height * ty);
    weights += w;
  }
  return {x / weights, y / weights};
}

bool unit_mesher::try_move(vertex_index v, const point& to, const face_list& at, double before) {
  if (!m_.can_move(v, to)) return false;
  const node old = m_.at(v);
  m_.move(v, to);
  measure(v);
  if (energy_around(at) < before) return true;
  m_.at(v) = old;
  return false;
}

std::size_t unit_mesher::smooth() {
  std::size_t done = 0;
  face_list at;
  for (vertex_index v = 0; v < m_.nodes().size(); ++v) {
    const node_kind kind = m_.at(v).kind;
    if (kind == node_kind::given || kind == node_kind::gone) continue;
    m_.around(v, at);
    const double before = energy_around(at);
    const point goal = pulled(v, at), here = m_.at(v).position;
    if (!std::isfinite(goal.x) || !std::isfinite(goal.y)) continue;
    for (const double part : {0.8, 0.3}) {
      point to{here.x + part * (goal.x - here.x), here.y + part * (goal.y - here.y)};
      if (kind == node_kind::sliding) to = m_.on_segment(v, to);
      if (!try_move(v, to, at, before)) continue;
      ++done;
      break;
    }
  }
  return done;
}

// Splits the longest edges, or merges the shortest, until the count is met or nothing more will do.
void unit_mesher::meet_count() {
  const auto wanted = static_cast<double>(options_.count);
  constexpr double slack = 0.01;
  constexpr int most = 12;
  for (int round = 0; round < most && !is_stopped(); ++round) {
    const double ratio = static_cast<double>(m_.count()) / wanted;
    if (std::abs(ratio - 1) <= slack) return;
    unit_ *= std::sqrt(ratio);
    if (ratio > 1)
      merge_short(0.75 * unit_);
    else
      split_long(1.35 * unit_);
    flip_all();
    for (int i = 0; i < 2; ++i) smooth();
    flip_all();
  }
}

void unit_mesher::run(const std::vector<point>& seeds) {
  for (vertex_index v = 0; v < m_.nodes().size(); ++v) measure(v);
  seed(seeds);
  constexpr int most_splits = 40, rounds = 4, sweeps = 3;
  for (int i = 0; i < most_splits && !is_stopped(); ++i)
    if (split_long(std::numbers::sqrt2 * unit_) == 0) break;
  for (int round = 0; round < rounds && !is_stopped(); ++round) {
    merge_short(unit_ / std::numbers::sqrt2);
    flip_all();
    for (int i = 0; i < sweeps; ++i) {
      smooth();
      flip_all();
    }
    split_long(std::numbers::sqrt2 * unit_);
  }
  if (options_.count > 0) meet_count();
  for (int i = 0; i < sweeps && !is_stopped(); ++i) {
    smooth();
    flip_all();
  }
}

}  // namespace asterism::internal::adapting
