// SPDX-License-Identifier: MIT
#include "asterism/mesh/search/site_index.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "asterism/kernels/semi_static_filter.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal {
namespace {

// Bounds of errors: one operation has an error of at most 2^-52 of its result in any rounding mode;
// the bounds below are at most 16 operations deep, so a factor 1 +- 2^-47 covers them all. For
// extreme operands, with which underflow could occur, the answer is "not known".
constexpr double up = 1 + 0x1p-47, down = 1 - 0x1p-47;
constexpr double smallest = 0x1p-900, largest = 0x1p900;

// Bound m11 m22 - m12^2 from both sides. Each product has an error of 2^-52 of itself. Where they
// cancel, the error is a large part of the difference, and is bounded by the products' magnitude.
struct range {
  double low, high;
};
range determinant(const metric_tensor& m) {
  const double product = m.m11 * m.m22, square = m.m12 * m.m12;
  const double slack = 0x1p-49 * (product + square);
  return {product - square - slack, product - square + slack};
}

}  // namespace

site_index::site_index(const bounding_box& box, purpose asked_for)
    : nodes_(1),
      bounds_metrics_(asked_for == purpose::everything),
      root_{{}, {box.high.x / 2 - box.low.x / 2, box.high.y / 2 - box.low.y / 2}} {
  if (bounds_metrics_)
    inverses_.resize(1);
  else
    places_.resize(1);
  root_.middle = {box.low.x + root_.half.x, box.low.y + root_.half.y};
}

site_index::inverse_range site_index::inverse_range_of(const metric_tensor& m) {
  const range det = determinant(m);
  if (!(det.low > smallest && det.high < largest))
    return {infinity, infinity, 0, -infinity, infinity};
  const double a = -m.m12 / det.low, b = -m.m12 / det.high, lost = std::abs(a) * 0x1p-47;
  return {m.m22 / det.low * up, m.m11 / det.low * up, 1 / det.high * down, std::min(a, b) - lost,
          std::max(a, b) + lost};
}

site_index::inverse_range site_index::inverse_for(const site& s) const {
  return bounds_metrics_ ? inverse_range_of(s.metric) : inverse_range{};
}

// An empty node has count 0 and an inverted box, which is apart from everything.
void site_index::cover(std::uint32_t at, const point& q, const inverse_range& inverse) {
  node& n = nodes_[at];
  const bool is_first = n.count == 0;
  if (is_first) n.box = {q, q};
  n.box.include(q);
  if (!bounds_metrics_) return;
  inverse_range& all = inverses_[at];
  if (is_first) all = inverse;
  all.m11 = std::max(all.m11, inverse.m11);
  all.m22 = std::max(all.m22, inverse.m22);
  all.determinant = std::min(all.determinant, inverse.determinant);
  all.m12_low = std::min(all.m12_low, inverse.m12_low);
  all.m12_high = std::max(all.m12_high, inverse.m12_high);
}

void site_index::insert(const std::vector<site>& sites, vertex_index w) {
  const site& s = sites[w];
  const inverse_range inverse = inverse_for(s);
  std::uint32_t at = 0;
  cell here = root_;
  int level = 0;
  for (;; ++level) {
    cover(at, s.position, inverse);
    if (nodes_[at].first_child == none) {
      if (nodes_[at].count < leaf_capacity || level >= most_levels) break;
      split(sites, at, here);
    }
    ++nodes_[at].count;
    const std::uint32_t quadrant = here.quadrant(s.position);
    at = nodes_[at].first_child + quadrant;
    here = here.quarter(quadrant);
  }
  put_in_leaf(at, s.position, w);
  ++size_;
}

void site_index::renumber(const std::vector<vertex_index>& to) {
  for (const node& n : nodes_) {
    if (n.first_child != none || n.count == 0) continue;
    leaf_sites& here = leaves_[n.leaf];
    const std::uint32_t at_hand = std::min<std::uint32_t>(n.count, leaf_capacity);
    for (std::uint32_t i = 0; i < at_hand; ++i) here.first[i] = to[here.first[i]];
  }
  for (auto& rest : overflow_)
    for (vertex_index& w : rest) w = to[w];
}

void site_index::put_in_leaf(std::uint32_t at, const point& q, vertex_index w) {
  node& n = nodes_[at];
  if (n.leaf == none) {
    n.leaf = static_cast<std::uint32_t>(leaves_.size());
    leaves_.emplace_back();
    if (!bounds_metrics_) places_.emplace_back();
  }
  leaf_sites& here = leaves_[n.leaf];
  if (n.count < leaf_capacity) {
    here.first[n.count] = w;
    if (!bounds_metrics_) places_[n.leaf][n.count] = q;
  } else {
    if (here.overflow == none) {
      here.overflow = static_cast<std::uint32_t>(overflow_.size());
      overflow_.emplace_back();
    }
    overflow_[here.overflow].push_back(w);
  }
  ++n.count;
}

// Puts the first of the new leaves in the place of the old one.
void site_index::split(const std::vector<site>& sites, std::uint32_t at, const cell& whole) {
  const auto first = static_cast<std::uint32_t>(nodes_.size());
  for (int child = 0; child < 4; ++child) {
    nodes_.emplace_back();
    nodes_.back().box = {{infinity, infinity}, {-infinity, -infinity}};
  }
  if (bounds_metrics_) inverses_.resize(nodes_.size());
  const leaf_sites moved = leaves_[nodes_[at].leaf];
  nodes_[first + whole.quadrant(sites[moved.first[0]].position)].leaf =
      std::exchange(nodes_[at].leaf, none);
  nodes_[at].first_child = first;
  for (const vertex_index w : moved.first) {
    const point& q = sites[w].position;
    const std::uint32_t child = first + whole.quadrant(q);
    cover(child, q, inverse_for(sites[w]));
    put_in_leaf(child, q, w);
  }
}

// Takes the smallest node around v that has enough sites, not all on a line, and divides the metric
// area of its box among its sites.
double site_index::spacing_near(const site& v) const {
  constexpr std::uint32_t enough = 4;
  const double root = std::sqrt(std::max(0.0, determinant(v.metric).low));
  double spacing = 0;
  std::uint32_t at = 0;
  cell here = root_;
  while (!nodes_.empty()) {
    const node& n = nodes_[at];
    const double area = root * (n.box.high.x - n.box.low.x) * (n.box.high.y - n.box.low.y);
    if (n.count < enough) break;
    if (area > 0) spacing = std::sqrt(area / n.count);
    if (n.first_child == none) break;
    const std::uint32_t quadrant = here.quadrant(v.position);
    at = n.first_child + quadrant;
    here = here.quarter(quadrant);
  }
  return spacing;
}

site_index::centre site_index::centre_of(const site& v, double reach) {
  const range det = determinant(v.metric);
  const bool known = det.low > smallest && det.high < largest && reach < largest;
  return {&v, known ? det.low : 0, reach};
}

// Returns an upper bound of half the trace of M_w^-1 M_v for all sites of the node; infinite when
// none is known.
double site_index::half_trace_above(const node& n, const centre& c) const {
  if (!(c.determinant_below > 0)) return infinity;
  const metric_tensor& m = c.v->metric;
  const inverse_range& inverse = inverse_of(n);
  const double off_diagonal = 2 * (m.m12 > 0 ? inverse.m12_high : inverse.m12_low) * m.m12;
  const double diagonal = inverse.m11 * m.m11 + inverse.m22 * m.m22;
  const double t = (diagonal + off_diagonal + 0x1p-47 * (diagonal + std::abs(off_diagonal))) / 2;
  return t < 0x1p500 ? t : infinity;  // infinite if not a number
}

// Returns (1 + sigma) R for all sites of the node; infinite when not known. sigma^2 = t + sqrt(t^2
// - d), t half the trace and d the determinant of M_w^-1 M_v, grows with t and falls with d.
double site_index::limit(const node& n, const centre& c) const {
  const double t = half_trace_above(n, c);
  if (t == infinity) return infinity;
  const double d = inverse_of(n).determinant * c.determinant_below * down;
  const double sigma =
      std::sqrt((t + std::sqrt(std::max(0.0, (t * up) * (t * up) - d)) * up) * up) * up;
  return (1 + (sigma > 1 ? sigma : 1)) * c.reach * up;
}

// Returns the square of a rougher limit, which needs no root: (1 + sigma)^2 <= 2 + 2 sigma^2, and
// sigma^2 <= 2 t.
double site_index::rough_squared_limit(const node& n, const centre& c) const {
  const double t = half_trace_above(n, c);
  if (t == infinity) return infinity;
  return 2 * (1 + (2 * t > 1 ? 2 * t : 1)) * (c.reach * c.reach * up) * up;
}

// Bounds the distance by a covector. With any vector u and g = M_v u, every w has |w|_v >= g.w /
// |u|_v. The vector u leads to the middle of the box; the least g.w is at one of the box's corners.
// No monomial of g.w or of |u|_v^2 passes more than six roundings, and `size` bounds the sum of the
// monomials' magnitudes, itself off by no more: 2^-48 of it covers the errors. The ranges of
// `least_below` and `size` exclude underflow and overflow, as |u|_v^2 is at least the least g.w.
site_index::approach site_index::approach_of(const node& n, const centre& c) {
  const point& at = c.v->position;
  const point low{n.box.low.x - at.x, n.box.low.y - at.y},
      high{n.box.high.x - at.x, n.box.high.y - at.y};
  if (low.x <= 0 && low.y <= 0 && high.x >= 0 && high.y >= 0) return {};  // v is in the box
  const metric_tensor& m = c.v->metric;
  const point u{0.5 * low.x + 0.5 * high.x, 0.5 * low.y + 0.5 * high.y};
  const point g{m.m11 * u.x + m.m12 * u.y, m.m12 * u.x + m.m22 * u.y};
  const double least = g.x * (g.x > 0 ? low.x : high.x) + g.y * (g.y > 0 ? low.y : high.y);
  const point extent{std::max(std::abs(low.x), std::abs(high.x)),
                     std::max(std::abs(low.y), std::abs(high.y))};
  const double mixed = std::abs(m.m12);
  const double size = (m.m11 * extent.x + mixed * extent.y) * extent.x +
                      (mixed * extent.x + m.m22 * extent.y) * extent.y;
  const double least_below = least - 0x1p-48 * size;
  if (!(least_below > 0x1p-300 && size < 0x1p400 && extent.x + extent.y < 0x1p600)) return {};
  return {least_below * least_below, (u.x * g.x + u.y * g.y + 0x1p-48 * size) * up};
}

bool site_index::approach::is_beyond(double squared_limit) const {
  return squared_limit > 0x1p-500 && squared_least > squared_limit * square_above * up;
}

// Decides most nodes without a root: they are nearer than even equal metrics would reach, or
// farther than the rougher limit.
bool site_index::out_of_reach(const node& n, const centre& c) const {
  if (!(c.determinant_below > 0)) return false;
  const approach a = approach_of(n, c);
  if (!a.is_beyond(4 * (c.reach * c.reach) * up)) return false;
  if (a.is_beyond(rough_squared_limit(n, c))) return true;
  const double most = limit(n, c);
  return a.is_beyond(most * most * up);
}

// True if the whole box is certainly to the right of the line: its corner farthest to the left is.
bool site_index::is_right_of(const bounding_box& box, const point& from, const point& to) {
  const point leftmost{to.y > from.y ? box.low.x : box.high.x,
                       to.x > from.x ? box.high.y : box.low.y};
  return semi_static::orientation(from, to, leftmost).certainly(sign::negative);
}

// True if |q - v|_v is certainly above the limit. Monomials pass at most six roundings.
bool site_index::is_beyond(const point& q, const centre& c, double limit) {
  const metric_tensor& m = c.v->metric;
  const point d{q.x - c.v->position.x, q.y - c.v->position.y};
  const double xx = m.m11 * d.x * d.x, yy = m.m22 * d.y * d.y, xy = 2 * (m.m12 * d.x * d.y);
  const double square = xx + yy + xy - 0x1p-48 * (xx + yy + std::abs(xy));
  const bool in_range = std::abs(d.x) + std::abs(d.y) < 0x1p400 && square < 0x1p800;
  return in_range && limit > 0x1p-250 && square > limit * limit * up;
}

}  // namespace asterism::internal
