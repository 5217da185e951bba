// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/site_tree.hpp"

#include <algorithm>
#include <numeric>

#include "asterism/mesh/audit/number.hpp"
#include "asterism/mesh/support/infinity.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal::audit_detail {
namespace {

// Returns an upper bound of the greater root of l^2 - trace l + determinant, a polynomial with two
// real roots; infinite where none is proved.
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

}  // namespace

site_tree::site_tree(const std::vector<site>& sites) : order_(sites.size()) {
  std::iota(order_.begin(), order_.end(), vertex_index{0});
  bound_roundings(sites);
  resize_in_threads(sites_, sites.size());
  if (!sites.empty()) {
    resize_in_threads(nodes_, node_count(sites.size()));
    build(sites, 0, 0, sites.size());
  }
  for (const node& n : nodes_)
    if (n.right == 0) groups_.push_back(n.first);
  groups_.push_back(sites.size());
}

void site_tree::bound_roundings(const std::vector<site>& sites) {
  double greatest = 0;
  for (const site& s : sites)
    greatest = std::max(greatest, std::abs(s.position.x) + std::abs(s.position.y));
  lost_ = roundings::step * greatest;
}

// Visits the nodes from the last to the first: both children follow their parent.
void site_tree::take_sites(const std::vector<site>& sites) {
  bound_roundings(sites);
  std::vector<char> has_changed(nodes_.size(), 0);
  constexpr std::size_t nodes_at_once = 256;
  parallel_chunks(nodes_.size(), nodes_at_once,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    for (std::size_t self = begin; self < end; ++self) {
                      node& n = nodes_[self];
                      if (n.right != 0) continue;
                      has_changed[self] = take_sites_of_leaf(n, sites);
                      if (has_changed[self] != 0) bound_leaf(n);
                    }
                  });
  // Bounds children before their parents.
  for (std::size_t self = nodes_.size(); self-- > 0;) {
    node& n = nodes_[self];
    if (n.right == 0) continue;
    has_changed[self] = has_changed[self + 1] | has_changed[n.right];
    if (has_changed[self] != 0) bound_parent(n, nodes_[self + 1], nodes_[n.right]);
  }
}

bool site_tree::take_sites_of_leaf(const node& n, const std::vector<site>& sites) {
  bool has_changed = false;
  for (std::size_t i = n.first; i < n.last; ++i) {
    const site& is = sites[order_[i]];
    has_changed = has_changed || !(sites_[i].position == is.position) ||
                  !identical(sites_[i].metric, is.metric);
    sites_[i] = is;
  }
  return has_changed;
}

void site_tree::bound_leaf(node& n) const {
  n.least = all_of(infinity);
  n.greatest = all_of(-infinity);
  by_covector squares = all_of(0);
  for (std::size_t i = n.first; i < n.last; ++i) {
    const by_covector values = values_at(sites_[i].position);
    n.least = -greater_of(-n.least, -values);
    n.greatest = greater_of(n.greatest, values);
    const metric_tensor& m = sites_[i].metric;
    squares = greater_of(squares, squared_lengths(m, inverse_determinant_above(m)));
  }
  n.length = roots_above(squares);
  bound_metrics_of_leaf(n);
}

// Bounds the spread, with B = `inverse`: the eigenvalues of M_w^-1 B^-1 are the inverses of those
// of B M_w, and the greater of these is divided by the determinant of B M_w to invert the smaller.
void site_tree::bound_metrics_of_leaf(node& n) const {
  n.inverse = {0, 0, 0};
  for (std::size_t i = n.first; i < n.last; ++i)
    n.inverse = sum(n.inverse, plain_inverse(sites_[i].metric));
  n.spread_squared = determinant_below(n.inverse) > 0 ? 0 : infinity;
  if (n.spread_squared == infinity) return;
  const tensor<bounded> b = tensor_of_doubles(n.inverse);
  for (std::size_t i = n.first; i < n.last; ++i) {
    const metric_tensor& metric = sites_[i].metric;
    if (i > n.first && identical(metric, sites_[i - 1].metric)) continue;  // bounded already
    const tensor<bounded> m = tensor_of_doubles(metric);
    const bounded determinant = b.determinant() * m.determinant();
    const double greatest = greatest_eigenvalue(trace_of_product(b, m), determinant);
    const double inverse = (bounded(1) / determinant).upper();
    n.spread_squared = greatest_bound(
        n.spread_squared, product_bound(greatest, inverse < infinity ? inverse : infinity));
  }
}

// Derives a node's bound from its children's: M_w >= C^-1 / s for a child with inverse C, and C^-1
// >= B^-1 / l with l the greater eigenvalue of C B^-1.
void site_tree::bound_parent(node& n, const node& left, const node& right) {
  n.least = -greater_of(-left.least, -right.least);
  n.greatest = greater_of(left.greatest, right.greatest);
  n.length = greater_of(left.length, right.length);
  n.inverse = sum(left.inverse, right.inverse);
  n.spread_squared = determinant_below(n.inverse) > 0 ? 0 : infinity;
  if (n.spread_squared == infinity) return;
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

// Uses that after d halvings all parts have sites / 2^d sites, rounded down or up. If these numbers
// are 8 and 9, parts of 9 are halved once more.
std::size_t site_tree::node_count(std::size_t sites) {
  std::size_t parts = 1;
  while (sites / parts > leaf_size) parts *= 2;
  const bool some_are_halved = sites / parts == leaf_size;
  const std::size_t leaves = some_are_halved ? parts + sites % parts : parts;
  return 2 * leaves - 1;
}

// Puts the lesser half of these sites first, along the greater extent of their box. The order
// decides cost alone, and is total because positions are distinct.
void site_tree::halve(const std::vector<site>& sites, std::size_t first, std::size_t middle,
                      std::size_t last) {
  point low{infinity, infinity}, high{-infinity, -infinity};
  for (std::size_t i = first; i < last; ++i) {
    const point& q = sites[order_[i]].position;
    low = {std::min(low.x, q.x), std::min(low.y, q.y)};
    high = {std::max(high.x, q.x), std::max(high.y, q.y)};
  }
  // Halves coordinates, as the difference of two finite doubles may overflow.
  const bool wide = high.x / 2 - low.x / 2 > high.y / 2 - low.y / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [&](vertex_index a, vertex_index b) {
    const point &p = sites[a].position, &q = sites[b].position;
    if (wide) return lexicographically_less(p, q);
    return p.y < q.y || (p.y == q.y && p.x < q.x);
  });
}

// Builds the node with this number, and those below it: large halves in parallel.
void site_tree::build(const std::vector<site>& sites, std::size_t self, std::size_t first,
                      std::size_t last) {
  node n;
  n.first = static_cast<std::uint32_t>(first);
  n.last = static_cast<std::uint32_t>(last);
  n.right = 0;
  if (last - first <= leaf_size) {
    // Sorts by number: std::nth_element leaves another order in each standard library.
    std::sort(order_.begin() + static_cast<std::ptrdiff_t>(first),
              order_.begin() + static_cast<std::ptrdiff_t>(last));
    for (std::size_t i = first; i < last; ++i) sites_[i] = sites[order_[i]];
    bound_leaf(n);
    nodes_[self] = n;
    return;
  }
  const std::size_t middle = first + (last - first) / 2;
  halve(sites, first, middle, last);
  n.right = static_cast<std::uint32_t>(self + 1 + node_count(middle - first));
  const auto build_half = [&](std::size_t half) {
    if (half == 0)
      build(sites, self + 1, first, middle);
    else
      build(sites, n.right, middle, last);
  };
  constexpr std::size_t worth_a_task = 4096;
  if (last - first >= worth_a_task)
    parallel_for(2, build_half);
  else
    for (std::size_t half = 0; half < 2; ++half) build_half(half);
  bound_parent(n, nodes_[self + 1], nodes_[n.right]);
  nodes_[self] = n;
}

// For the covector x, sites w in a node matter only with |w.x - v.x| <= (|x|_v + max(|x|_v, |x|_w))
// reach, of which `most` is an upper bound: its three roundings and that of the difference are
// within `up`, and underflow within the summand.
bool site_tree::may_reach(const site& v, double reach) const {
  if (!(reach < infinity)) return true;
  const by_covector own =
      roots_above(squared_lengths(v.metric, inverse_determinant_above(v.metric)));
  const two_doubles at = pair(v.position.x, v.position.y);
  const auto excludes = [&](const node& n) {
    const two_doubles most =
        (own.axes + greater_of(own, n.length).axes) * both(reach * roundings::up) + both(0x1p-900);
    return any_less(most, n.least.axes - at) || any_less(most, at - n.greatest.axes);
  };
  bool is_found = false;
  descend(excludes, [&is_found](std::size_t) {
    is_found = true;
    return false;
  });
  return is_found;
}

void site_tree::gather(std::span<const star_extent> stars, std::vector<std::size_t>& leaves,
                       std::size_t from) const {
  leaves.clear();
  if (stars.empty()) return;
  visit_leaves(star_extent(stars), from, [&](std::size_t leaf) { leaves.push_back(leaf); });
}

}  // namespace asterism::internal::audit_detail
