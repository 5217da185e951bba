// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/site_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "asterism/mesh/audit/number.hpp"

namespace asterism::internal::audit_detail {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// An operation in any rounding mode is off by at most 2^-52 of its result. No value below is a sum
// of monomials that meet more than eight: `step` bounds them and the roundings of the bound itself
// for a magnitude, the sum of the monomials' absolute values; `up` the three or four roundings
// after that. Underflow takes less than that within the ranges that are asked for.
constexpr double step = 0x1p-48, up = 1 + 0x1p-49;

// Returns an upper bound of the greater root of l^2 - trace l + determinant, which has two;
// infinite where not known.
double greatest_eigenvalue(bounded trace, bounded determinant) {
  const bounded half = trace * bounded(0.5);
  const double bound = (half + root(half * half - determinant)).upper();
  return bound < infinity ? bound : infinity;
}

tensor<bounded> adjugate(const tensor<bounded>& m) { return {m.m22, -m.m12, m.m11}; }

bounded trace_of_product(const tensor<bounded>& a, const tensor<bounded>& b) {
  return a.m11 * b.m11 + bounded(2) * a.m12 * b.m12 + a.m22 * b.m22;
}

metric_tensor plain_inverse(const metric_tensor& m) {
  const double d = m.m11 * m.m22 - m.m12 * m.m12;
  return {m.m22 / d, -m.m12 / d, m.m11 / d};
}

metric_tensor sum(const metric_tensor& a, const metric_tensor& b) {
  return {a.m11 + b.m11, a.m12 + b.m12, a.m22 + b.m22};
}

double product_bound(double a, double b) {
  const double product = (bounded(a) * bounded(b)).upper();
  return product < infinity ? product : infinity;
}

double positive_determinant(const metric_tensor& m) {
  const double below = positive_bound(tensor_of_doubles(m).determinant().lower());
  return below < infinity ? below : 0;
}

}  // namespace

site_tree::site_tree(const std::vector<site>& sites) : order_(sites.size()) {
  std::iota(order_.begin(), order_.end(), vertex_index{0});
  nodes_.reserve(4 * sites.size() / leaf_size + 1);
  if (!sites.empty()) build(0, sites.size(), sites);
  groups_.push_back(sites.size());
  places_.reserve(sites.size());
  for (const vertex_index w : order_) places_.push_back(sites[w].position);
}

// With B = `inverse`: the eigenvalues of M_w^-1 B^-1 are the inverses of those of B M_w, and the
// greater of these is divided by the determinant of B M_w to invert the smaller.
void site_tree::bound_leaf(node& n, const std::vector<site>& sites) const {
  n.inverse = {0, 0, 0};
  for (std::size_t i = n.first; i < n.last; ++i)
    n.inverse = sum(n.inverse, plain_inverse(sites[order_[i]].metric));
  n.determinant_below = positive_determinant(n.inverse);
  n.spread_squared = n.determinant_below > 0 ? 0 : infinity;
  if (n.determinant_below == 0) return;
  const tensor<bounded> b = tensor_of_doubles(n.inverse);
  for (std::size_t i = n.first; i < n.last; ++i) {
    const metric_tensor& metric = sites[order_[i]].metric;
    if (i > n.first && identical(metric, sites[order_[i - 1]].metric)) continue;  // bounded already
    const tensor<bounded> m = tensor_of_doubles(metric);
    const bounded determinant = b.determinant() * m.determinant();
    const double greatest = greatest_eigenvalue(trace_of_product(b, m), determinant);
    const double inverse = (bounded(1) / determinant).upper();
    n.spread_squared = greatest_bound(
        n.spread_squared, product_bound(greatest, inverse < infinity ? inverse : infinity));
  }
}

// M_w >= C^-1 / s for a child with inverse C, and C^-1 >= B^-1 / l with l the greater eigenvalue of
// C B^-1.
void site_tree::bound_parent(node& n, const node& left, const node& right) const {
  n.inverse = sum(left.inverse, right.inverse);
  n.determinant_below = positive_determinant(n.inverse);
  n.spread_squared = n.determinant_below > 0 ? 0 : infinity;
  if (n.determinant_below == 0) return;
  const tensor<bounded> b = tensor_of_doubles(n.inverse);
  const bounded inverse = bounded(1) / b.determinant();
  for (const node* child : {&left, &right}) {
    const tensor<bounded> c = tensor_of_doubles(child->inverse);
    const double greatest =
        greatest_eigenvalue(trace_of_product(c, adjugate(b)) * inverse, c.determinant() * inverse);
    n.spread_squared =
        greatest_bound(n.spread_squared, product_bound(greatest, child->spread_squared));
  }
}

void site_tree::build(std::size_t first, std::size_t last, const std::vector<site>& sites) {
  const std::size_t self = nodes_.size();
  nodes_.emplace_back();
  node n;
  n.first = first;
  n.last = last;
  n.low = {infinity, infinity};
  n.high = {-infinity, -infinity};
  for (std::size_t i = first; i < last; ++i) {
    const point& q = sites[order_[i]].position;
    n.low = {std::min(n.low.x, q.x), std::min(n.low.y, q.y)};
    n.high = {std::max(n.high.x, q.x), std::max(n.high.y, q.y)};
  }
  if (last - first <= leaf_size) {
    bound_leaf(n, sites);
    groups_.push_back(first);
    nodes_[self] = n;
    return;
  }
  const std::size_t middle = first + (last - first) / 2;
  // Halved, as the difference of two finite doubles may overflow. The order decides cost alone,
  // and is total because positions are distinct.
  const bool wide = n.high.x / 2 - n.low.x / 2 > n.high.y / 2 - n.low.y / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [&](vertex_index a, vertex_index b) {
    const point &p = sites[a].position, &q = sites[b].position;
    if (wide) return lexicographically_less(p, q);
    return p.y < q.y || (p.y == q.y && p.x < q.x);
  });
  build(first, middle, sites);
  n.right = nodes_.size();
  build(middle, last, sites);
  bound_parent(n, nodes_[self + 1], nodes_[n.right]);
  nodes_[self] = n;
}

site_tree::centre site_tree::centre_of(const site& v, double reach) {
  return {v.position, v.position, v.metric, positive_determinant(v.metric), reach, 1};
}

// With B the first star's metric and tau^2 the spread, |u|_B <= tau |u|_v and
// M_w^-1 M_v <= tau^2 M_w^-1 B: what is beyond (1 + tau sigma_B) tau reach as B measures is too far
// from v, sigma_B that of B in place of M_v.
std::optional<site_tree::centre> site_tree::centre_of(const std::vector<reaching>& stars) {
  constexpr double most_spread = 4;
  if (stars.empty()) return std::nullopt;
  centre all = centre_of(stars.front().v, 0);
  const tensor<bounded> b = tensor_of_doubles(all.metric);
  const bounded inverse = bounded(1) / b.determinant();
  for (const auto& [v, reach] : stars) {
    const point& q = v.position;
    all.low = {std::min(all.low.x, q.x), std::min(all.low.y, q.y)};
    all.high = {std::max(all.high.x, q.x), std::max(all.high.y, q.y)};
    all.reach = std::max(all.reach, reach);
    const tensor<bounded> m = tensor_of_doubles(v.metric);
    const bounded determinant = m.determinant() * inverse;
    const double greatest =
        greatest_eigenvalue(trace_of_product(m, adjugate(b)) * inverse, determinant);
    const double against = (bounded(greatest) / determinant).upper();
    all.spread_squared = greatest_bound(all.spread_squared, greatest_bound(greatest, against));
  }
  if (!(all.spread_squared < most_spread && all.reach < infinity)) return std::nullopt;
  all.reach *= std::sqrt(all.spread_squared) * up;
  return all;
}

bool site_tree::gather(const std::vector<reaching>& stars, std::vector<std::size_t>& leaves) const {
  leaves.clear();
  const std::optional<centre> all = centre_of(stars);
  if (all) visit_leaves(*all, [&](std::size_t leaf) { leaves.push_back(leaf); });
  return all.has_value();
}

// Returns the trace of tau^2 inverse M_v, from above: at least its greater eigenvalue.
double site_tree::trace_above(const node& n, const centre& v) {
  const metric_tensor &b = n.inverse, &m = v.metric;
  const double diagonal = b.m11 * m.m11 + b.m22 * m.m22, mixed = 2 * (b.m12 * m.m12);
  const double magnitude = diagonal + std::abs(mixed);
  const double trace = (diagonal + mixed + step * magnitude + 0x1p-899) * v.spread_squared * up;
  return trace < 0x1p501 && n.spread_squared < 0x1p500 ? trace : infinity;
}

// Bounds sigma: sigma^2 is at most spread_squared times the greater eigenvalue of inverse M_v.
double site_tree::limit(const node& n, const centre& v) {
  const double half = 0.5 * trace_above(n, v);
  if (half == infinity) return infinity;
  const double own = v.determinant_below * (v.spread_squared * v.spread_squared);
  const double determinant = n.determinant_below * own * (1 - 0x1p-49);
  const double rest = half * half * up - determinant;
  const double greatest = (half + std::sqrt(rest > 0 ? rest : 0) * up) * up;
  const double sigma = std::sqrt(n.spread_squared * greatest * up) * up;
  return (1 + (sigma > 1 ? sigma : 1)) * v.reach * up;
}

// (1 + sigma)^2 <= 2 + 2 sigma^2.
double site_tree::rough_squared_limit(const node& n, const centre& v) {
  const double trace = trace_above(n, v);
  if (trace == infinity) return infinity;
  const double sigma_squared = n.spread_squared * trace * up;
  return 2 * (1 + (sigma_squared > 1 ? sigma_squared : 1)) * (v.reach * v.reach * up) * up;
}

// With c any vector and g = M_v c, every w has |w|_v >= g.w / |c|_v. c leads to the middle of the
// box of all w - v; the least g.w is at one of its corners.
site_tree::approach site_tree::approach_of(const node& n, const centre& v) {
  const point low{n.low.x - v.high.x, n.low.y - v.high.y};
  const point high{n.high.x - v.low.x, n.high.y - v.low.y};
  if (low.x <= 0 && low.y <= 0 && high.x >= 0 && high.y >= 0) return {};  // they meet
  const metric_tensor& m = v.metric;
  const point c{0.5 * low.x + 0.5 * high.x, 0.5 * low.y + 0.5 * high.y};
  const point g{m.m11 * c.x + m.m12 * c.y, m.m12 * c.x + m.m22 * c.y};
  const double least = g.x * (g.x > 0 ? low.x : high.x) + g.y * (g.y > 0 ? low.y : high.y);
  const point extent{std::max(std::abs(low.x), std::abs(high.x)),
                     std::max(std::abs(low.y), std::abs(high.y))};
  const double mixed = std::abs(m.m12);
  const double size = (m.m11 * extent.x + mixed * extent.y) * extent.x +
                      (mixed * extent.x + m.m22 * extent.y) * extent.y;
  const double least_below = least - step * size;
  if (!(least_below > 0x1p-300 && size < 0x1p400 && extent.x + extent.y < 0x1p600)) return {};
  return {least_below * least_below, (c.x * g.x + c.y * g.y + step * size) * up};
}

bool site_tree::approach::is_beyond(double squared_limit) const {
  return squared_limit > 0x1p-500 && squared_least > squared_limit * square_above * up;
}

// Takes no root where a node is nearer than equal metrics would reach, or farther than a rougher
// bound.
bool site_tree::too_far(const node& n, const centre& v) {
  const approach a = approach_of(n, v);
  if (!a.is_beyond(4 * (v.reach * v.reach) * up)) return false;
  if (a.is_beyond(rough_squared_limit(n, v))) return true;
  const double most = limit(n, v);
  return a.is_beyond(most * most * up);
}

bool site_tree::beyond(const point& q, const centre& v, double most) {
  const metric_tensor& m = v.metric;
  const point d{q.x - v.low.x, q.y - v.low.y};
  const double xx = m.m11 * d.x * d.x, yy = m.m22 * d.y * d.y, xy = 2 * (m.m12 * d.x * d.y);
  const double square = xx + yy + xy - step * (xx + yy + std::abs(xy)), bound = most * most * up;
  const bool in_range = std::abs(d.x) + std::abs(d.y) < 0x1p400 && square < 0x1p800;
  return in_range && most > 0x1p-250 && square > bound;
}

}  // namespace asterism::internal::audit_detail
