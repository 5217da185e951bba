// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/site_tree.hpp"

#include <algorithm>
#include <numeric>

#include "asterism/mesh/audit/number.hpp"
#include "asterism/mesh/support/infinity.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal::audit_detail {
namespace {

// An operation in any rounding mode is off by at most 2^-52 of its result. Every value below is a
// sum of monomials that pass at most eight roundings: `step` times the magnitude, the sum of the
// monomials' absolute values, bounds these roundings and those of the bound itself; `up` bounds the
// three or four roundings after that. Underflow loses less than that within the ranges that are
// checked first.
constexpr double step = 0x1p-48, up = 1 + 0x1p-49;

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

// Returns an upper bound of the trace of b m. For g = m h the trace is at least the quotient of
// |g|^2 in b by |h|^2 in m. Loses fewer digits than a bound from eigenvalues where both metrics are
// much stretched.
double trace_above(const metric_tensor& b, const metric_tensor& m) {
  const double diagonal = b.m11 * m.m11 + b.m22 * m.m22, mixed = 2 * (b.m12 * m.m12);
  return (diagonal + mixed + step * (diagonal + std::abs(mixed)) + 0x1p-300) * up;
}

double product_bound(double a, double b) {
  const double product = (bounded(a) * bounded(b)).upper();
  return product < infinity ? product : infinity;
}

// Returns a lower bound of the determinant; 0 where none is known. The roundings of both products
// and of their difference, and underflow in the range that is checked, are less than 2^-50 of the
// sum of the products.
double determinant_below(const metric_tensor& m) {
  const double product = m.m11 * m.m22, square = m.m12 * m.m12;
  const double below = product - square - 0x1p-50 * (product + square);
  return below > 0x1p-900 && product < 0x1p1000 ? below : 0;
}

// Returns an upper bound of 1 / det m; infinite where the determinant is not certainly positive.
double inverse_determinant_above(const metric_tensor& m) {
  const double below = determinant_below(m);
  return below > 0x1p-200 ? 1 / below * up : infinity;
}

}  // namespace

site_tree::site_tree(const std::vector<site>& sites) : sites_(sites), order_(sites.size()) {
  std::iota(order_.begin(), order_.end(), vertex_index{0});
  if (!sites.empty()) {
    nodes_.resize(node_count(sites.size()));
    build(0, 0, sites.size());
  }
  for (const node& n : nodes_)
    if (n.right == 0) groups_.push_back(n.first);
  groups_.push_back(sites.size());
  places_.resize(sites.size());
  inverse_determinants_.resize(sites.size());
  constexpr std::size_t chunk = 1024;
  parallel_chunks(sites.size(), chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      places_[i] = sites[order_[i]].position;
      inverse_determinants_[i] = inverse_determinant_above(sites[order_[i]].metric);
    }
  });
  if (sites.size() <= most_with_covectors) bound_covectors();
}

// Bounds |g|_M for each covector. |g|^2 in M is g M^-1 g, the adjugate's value times the inverse
// determinant. The three monomials of the adjugate's value pass two roundings each; underflow loses
// less than the number that is added.
site_tree::by_covector site_tree::lengths_of(const metric_tensor& m, double inverse_determinant) {
  const double sum = m.m11 + m.m22, mixed = 2 * m.m12;
  const auto length = [&](double adjugate) {
    return std::sqrt((adjugate + step * sum) * inverse_determinant + 0x1p-300) * up;
  };
  return {length(m.m22), length(m.m11), length(sum - mixed), length(sum + mixed)};
}

void site_tree::bound_covectors() {
  lengths_.reserve(order_.size());
  for (std::size_t i = 0; i < order_.size(); ++i)
    lengths_.push_back(lengths_of(sites_[order_[i]].metric, inverse_determinants_[i]));
  covector_bounds_.resize(nodes_.size());
  // Goes from the last node to the first: children follow their parents.
  for (std::size_t i = nodes_.size(); i-- > 0;) covector_bounds_[i] = bounds_of(i);
}

site_tree::covector_bounds site_tree::bounds_of(std::size_t self) const {
  covector_bounds all;
  all.least.fill(infinity);
  all.greatest.fill(-infinity);
  all.length.fill(0);
  const auto take = [&all](const covector_bounds& some) {
    for (std::size_t k = 0; k < all.length.size(); ++k) {
      all.least[k] = std::min(all.least[k], some.least[k]);
      all.greatest[k] = std::max(all.greatest[k], some.greatest[k]);
      all.length[k] = std::max(all.length[k], some.length[k]);
    }
  };
  const node& n = nodes_[self];
  if (n.right != 0) {
    for (const std::size_t child : {self + 1, n.right}) take(covector_bounds_[child]);
    return all;
  }
  for (std::size_t i = n.first; i < n.last; ++i) {
    const point& q = places_[i];
    const double x = q.x, y = q.y, lost = step * (std::abs(x) + std::abs(y));
    take({{x - lost, y - lost, x + y - lost, x - y - lost},
          {x + lost, y + lost, x + y + lost, x - y + lost},
          lengths_[i]});
  }
  return all;
}

// Bounds the spread, with B = `inverse`: the eigenvalues of M_w^-1 B^-1 are the inverses of those
// of B M_w, and the greater of these is divided by the determinant of B M_w to invert the smaller.
void site_tree::bound_leaf(node& n) const {
  n.inverse = {0, 0, 0};
  for (std::size_t i = n.first; i < n.last; ++i)
    n.inverse = sum(n.inverse, plain_inverse(sites_[order_[i]].metric));
  n.spread_squared = determinant_below(n.inverse) > 0 ? 0 : infinity;
  if (n.spread_squared == infinity) return;
  const tensor<bounded> b = tensor_of_doubles(n.inverse);
  for (std::size_t i = n.first; i < n.last; ++i) {
    const metric_tensor& metric = sites_[order_[i]].metric;
    if (i > n.first && identical(metric, sites_[order_[i - 1]].metric))
      continue;  // bounded already
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
void site_tree::bound_parent(node& n, const node& left, const node& right) const {
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

// Builds the node with this number, and those below it: large halves in parallel.
void site_tree::build(std::size_t self, std::size_t first, std::size_t last) {
  node n;
  n.first = first;
  n.last = last;
  n.low = {infinity, infinity};
  n.high = {-infinity, -infinity};
  for (std::size_t i = first; i < last; ++i) {
    const point& q = sites_[order_[i]].position;
    n.low = {std::min(n.low.x, q.x), std::min(n.low.y, q.y)};
    n.high = {std::max(n.high.x, q.x), std::max(n.high.y, q.y)};
  }
  if (last - first <= leaf_size) {
    // Sorts by number: std::nth_element leaves another order in each standard library.
    std::sort(order_.begin() + static_cast<std::ptrdiff_t>(first),
              order_.begin() + static_cast<std::ptrdiff_t>(last));
    bound_leaf(n);
    nodes_[self] = n;
    return;
  }
  const std::size_t middle = first + (last - first) / 2;
  // Halves coordinates, as the difference of two finite doubles may overflow. The order decides
  // cost alone, and is total because positions are distinct.
  const bool wide = n.high.x / 2 - n.low.x / 2 > n.high.y / 2 - n.low.y / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [&](vertex_index a, vertex_index b) {
    const point &p = sites_[a].position, &q = sites_[b].position;
    if (wide) return lexicographically_less(p, q);
    return p.y < q.y || (p.y == q.y && p.x < q.x);
  });
  n.right = self + 1 + node_count(middle - first);
  const auto build_half = [&](std::size_t half) {
    if (half == 0)
      build(self + 1, first, middle);
    else
      build(n.right, middle, last);
  };
  constexpr std::size_t worth_a_task = 4096;
  if (last - first >= worth_a_task)
    parallel_for(2, build_half);
  else
    for (std::size_t half = 0; half < 2; ++half) build_half(half);
  bound_parent(n, nodes_[self + 1], nodes_[n.right]);
  nodes_[self] = n;
}

site_tree::centre site_tree::centre_of(const site& v, double reach) {
  centre one;
  one.low = one.high = v.position;
  one.metric = v.metric;
  one.reach = reach;
  return one;
}

site_tree::centre site_tree::centre_with_covectors(const reaching& star) {
  centre one = centre_of(star.v, star.reach);
  const auto& [x, y] = star.v.position;
  one.value = {x, y, x + y, x - y};
  one.lost = step * (std::abs(x) + std::abs(y));
  one.length = lengths_of(star.v.metric, inverse_determinant_above(star.v.metric));
  one.outline = star.outline;
  return one;
}

// Without an outline, sites matter up to (|g|_v + max(|g|_v, |g|_w)) R.
site_tree::reaches_along site_tree::reaches_of(const reaching& star, const centre& one) {
  reaches_along all;
  for (std::size_t k = 0; k < covectors; ++k) {
    const double own = one.length[k], twice = 2 * own * star.reach;
    if (star.outline != nullptr)
      all[k] = reach_in(*star.outline, k, own);
    else
      all[k].fill({twice, 0, own, twice, star.reach});
  }
  return all;
}

// The greatest g . p + l length(p) of all points is a convex function of the length l: below the
// chord from 0 to `own`, and from there on below a line as steep as the greatest length.
site_tree::both_ways site_tree::reach_in(const star_outline& outline, std::size_t covector,
                                         double own) {
  reach_along forth, back;
  if (!(own < infinity)) return {forth, back};
  forth.none = back.none = forth.at_own = back.at_own = 0;
  forth.own = back.own = own;
  double lost = 0;
  outline.visit([&](const outline_point& p) {
    const auto& [at, length] = p;
    const by_covector values{at.x, at.y, at.x + at.y, at.x - at.y};
    const double value = values[covector], more = own * length;
    lost = std::max(lost, step * (std::abs(at.x) + std::abs(at.y)));
    forth.none = std::max(forth.none, value);
    back.none = std::max(back.none, -value);
    forth.at_own = std::max(forth.at_own, value + more);
    back.at_own = std::max(back.at_own, more - value);
    forth.steep = std::max(forth.steep, length);
  });
  back.steep = forth.steep;
  for (reach_along* one : {&forth, &back}) {
    one->none += lost;
    one->at_own += lost;
    one->rise = std::max(0.0, (one->at_own - one->none) / own);
  }
  return {forth, back};
}

// With B the first star's metric and tau^2 the spread, |g|_v <= tau |g|_B. The lemma holds with tau
// |g|_B in place of |g|_v; or, divided by tau, with |g|_B, |g|_w / tau, and tau times the reach.
std::optional<site_tree::centre> site_tree::centre_of(const std::vector<reaching>& stars) {
  constexpr double most_spread = 4;
  if (stars.empty()) return std::nullopt;
  centre all = centre_of(stars.front().v, 0);
  const tensor<bounded> b = tensor_of_doubles(all.metric);
  const bounded inverse = bounded(1) / b.determinant();
  for (const reaching& star : stars) {
    const site& v = star.v;
    const point& q = v.position;
    all.low = {std::min(all.low.x, q.x), std::min(all.low.y, q.y)};
    all.high = {std::max(all.high.x, q.x), std::max(all.high.y, q.y)};
    all.reach = std::max(all.reach, star.reach);
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

bool site_tree::gather(const std::vector<reaching>& stars, std::vector<std::size_t>& leaves,
                       std::size_t from) const {
  leaves.clear();
  const std::optional<centre> all = centre_of(stars);
  if (all) visit_leaves(*all, from, [&](std::size_t leaf) { leaves.push_back(leaf); });
  return all.has_value();
}

bool site_tree::gather(const std::vector<reaching>& stars, nearby_sites& nearby,
                       std::size_t most_leaves) const {
  nearby.nth.clear();
  nearby.share.clear();
  nearby.leaves.clear();
  const std::optional<centre> all = centre_of(stars);
  if (!all) return false;
  const bool may_be_many = !has_covectors();
  visit_leaves(*all, 0, [&](std::size_t leaf) {
    nearby.leaves.push_back(leaf);
    return may_be_many || nearby.leaves.size() <= most_leaves;
  });
  if (!may_be_many && nearby.leaves.size() > most_leaves) return false;
  list_sites(*all, nearby);
  return true;
}

bool site_tree::gather(const std::vector<reaching>& stars, nearby_leaves& nearby) const {
  if (!has_covectors() || stars.empty()) return false;
  nearby.centres.clear();
  nearby.along.clear();
  nearby.leaves.clear();
  nearby.along.reserve(stars.size() + 1);
  for (const reaching& star : stars) {
    centre& one = nearby.centres.emplace_back(centre_with_covectors(star));
    one.along = &nearby.along.emplace_back(reaches_of(star, one));
  }
  centre all = centre_of(stars.front().v, infinity);
  all.value = nearby.centres.front().value;
  all.lost = nearby.centres.front().lost;
  all.along = &nearby.along.emplace_back(joined(nearby));
  visit_leaves(all, 0, [&](std::size_t leaf) { nearby.leaves.push_back(leaf); });
  return true;
}

// Takes values relative to the first star's, so that the greatest is not negative. Each star's
// bound is a convex function of the dual length.
site_tree::reaches_along site_tree::joined(const nearby_leaves& stars) {
  const centre& first = stars.centres.front();
  reaches_along all;
  for (std::size_t k = 0; k < covectors; ++k)
    for (const bool back : {false, true}) {
      reach_along& joined = all[k][back];
      const double own = first.length[k];
      joined = {0, 0, own, 0, 0};
      for (std::size_t i = 0; i < stars.centres.size(); ++i) {
        const centre& one = stars.centres[i];
        const reach_along& some = stars.along[i][k][back];
        const double shift = back ? first.value[k] - one.value[k] : one.value[k] - first.value[k];
        const double lost = first.lost + one.lost;
        joined.none = greatest_bound(joined.none, shift + some.none + lost);
        joined.at_own = greatest_bound(joined.at_own, shift + some.at(own) + lost);
        joined.steep = greatest_bound(joined.steep, std::max(some.rise, some.steep));
      }
      joined.rise = std::max(0.0, (joined.at_own - joined.none) / own);
    }
  return all;
}

void site_tree::list_sites(const centre& stars, nearby_sites& nearby) const {
  constexpr double most = 0x1p398;
  const auto is_in_range = [](const point& low, const point& high) {
    return low.x > -most && low.y > -most && high.x < most && high.y < most;
  };
  nearby.is_in_range = is_in_range(stars.low, stars.high);
  for (const std::size_t leaf : nearby.leaves) {
    const node& n = nodes_[leaf];
    nearby.is_in_range = nearby.is_in_range && is_in_range(n.low, n.high);
    for (std::size_t i = n.first; i < n.last; ++i) nearby.nth.push_back(i);
    nearby.share.resize(nearby.nth.size(), share_of(n, stars));
  }
  nearby.x.resize(nearby.nth.size());
  nearby.y.resize(nearby.nth.size());
  nearby.measured.resize(nearby.nth.size());
  for (std::size_t k = 0; k < nearby.nth.size(); ++k) {
    nearby.x[k] = places_[nearby.nth[k]].x;
    nearby.y[k] = places_[nearby.nth[k]].y;
  }
}

bool site_tree::is_measurable(const site& v, double reach) {
  const metric_tensor& m = v.metric;
  return reach > 0x1p-200 && reach < 0x1p200 && m.m11 > 0x1p-900 && m.m22 > 0x1p-900 &&
         m.m11 + m.m22 < 0x1p1000;
}

// Rounds the square down: of m11 dx^2 + 2 m12 dx dy + m22 dy^2 no monomial passes more than seven
// roundings, 2^-49 of it, and the middle one is no more than the sum of the others, as the metric
// is positive definite: 2^-48 of that sum covers all, and m11 and m22 are reduced by 2^-46 of
// themselves. Positions are less than 2^399 apart, so that underflow loses less than 2^-670, in
// values that are compared with 2^-400 or more. An infinite value means that the site is too far; a
// NaN makes every comparison false, which keeps the site.
void site_tree::measure(nearby_sites& nearby, const site& v) {
  constexpr double down = 1 - 0x1p-46;
  const auto& [place, m] = v;
  const double m11 = m.m11 * down, m12 = 2 * m.m12, m22 = m.m22 * down;
  const double *xs = nearby.x.data(), *ys = nearby.y.data(), *shares = nearby.share.data();
  double* measured = nearby.measured.data();
  for (std::size_t k = 0; k < nearby.nth.size(); ++k) {
    const double x = xs[k] - place.x, y = ys[k] - place.y;
    measured[k] = ((m11 * x + m12 * y) * x + m22 * y * y) * shares[k];
  }
}

// Tries the covector g = M h. The computed g has an error of at most `step` times its magnitudes;
// h, a pair of doubles, need not be exact. Where the box is too near even for equal metrics, as
// most boxes are, the rest is not computed.
site_tree::separation site_tree::separation_along(const point& h, const offset_box& to,
                                                  const centre& v, const inverse_bound& inverse) {
  const metric_tensor &m = v.metric, &b = inverse.tensor;
  const point g{m.m11 * h.x + m.m12 * h.y, m.m12 * h.x + m.m22 * h.y};
  const point size{m.m11 * std::abs(h.x) + std::abs(m.m12 * h.y),
                   std::abs(m.m12 * h.x) + m.m22 * std::abs(h.y)};
  const point extent{std::max(std::abs(to.low.x), std::abs(to.high.x)),
                     std::max(std::abs(to.low.y), std::abs(to.high.y))};
  const double least = g.x * (g.x > 0 ? to.low.x : to.high.x) +
                       g.y * (g.y > 0 ? to.low.y : to.high.y) -
                       step * (size.x * extent.x + size.y * extent.y);
  const double own = g.x * h.x + g.y * h.y,
               own_size = size.x * std::abs(h.x) + size.y * std::abs(h.y);
  const double own_squared = (own + step * own_size + 0x1p-300) * up;
  if (!(least > 0x1p-300 && least * least > 4 * (v.reach * v.reach) * own_squared)) return {};
  const bool in_range = size.x + size.y < 0x1p200 && b.m11 + b.m22 < 0x1p200 &&
                        std::abs(h.x) + std::abs(h.y) < 0x1p200 && inverse.factor < 0x1p200;
  if (!in_range) return {};
  const double other = b.m11 * g.x * g.x + b.m22 * g.y * g.y + 2 * (b.m12 * g.x * g.y),
               other_size = b.m11 * size.x * size.x + b.m22 * size.y * size.y +
                            2 * (std::abs(b.m12) * size.x * size.y);
  const double factor = inverse.factor / v.spread_squared;
  const double other_squared = (other + step * other_size + 0x1p-300) * factor * up;
  const double turned = trace_above(b, m) * factor * up * own_squared * up;
  return {least, own_squared, std::min(other_squared, turned)};
}

// Takes roots only where the bounds 4 a^2 and 2 a^2 + 2 b^2 of (a + b)^2 do not decide: a^2 is
// own_squared, and b^2 the greater of own_squared and other_squared.
bool site_tree::separation::is_beyond(double reach) const {
  if (!(least > 0 && reach < 0x1p200)) return false;
  constexpr double smallest_reach = 0x1p-200;
  const double r = std::max(reach, smallest_reach), square = least * least / up;
  const double other = std::max(own_squared, other_squared);
  if (!(square > 4 * (r * r) * own_squared)) return false;
  if (square > 2 * (r * r) * (own_squared + other) * up) return true;
  return least > r * (std::sqrt(own_squared) + std::sqrt(other)) * up;
}

// Tries the covector M c, with M the metric of v and c the displacement from v to the middle of the
// box; if that suffices for equal metrics, also the covector chosen by both metrics.
bool site_tree::too_far(const offset_box& to, const centre& v, const inverse_bound& inverse) {
  const bool may_meet = to.low.x <= 0 && to.low.y <= 0 && to.high.x >= 0 && to.high.y >= 0;
  if (may_meet || !(inverse.factor < infinity && v.reach < infinity)) return false;
  const point c{0.5 * to.low.x + 0.5 * to.high.x, 0.5 * to.low.y + 0.5 * to.high.y};
  const separation plain = separation_along(c, to, v, inverse);
  return plain.least > 0 && (plain.is_beyond(v.reach) || too_far_from_both(c, to, v, inverse));
}

// Tries the covector along which both ellipses together are farthest from the middle c of the box:
// with P and Q the inverses (P + Q)^-1 c, which is M h for h = (1 + Q M)^-1 c.
bool site_tree::too_far_from_both(const point& c, const offset_box& to, const centre& v,
                                  const inverse_bound& inverse) {
  const metric_tensor &m = v.metric, &b = inverse.tensor;
  const double factor = inverse.factor / v.spread_squared;
  const double a11 = 1 + factor * (b.m11 * m.m11 + b.m12 * m.m12),
               a12 = factor * (b.m11 * m.m12 + b.m12 * m.m22),
               a21 = factor * (b.m12 * m.m11 + b.m22 * m.m12),
               a22 = 1 + factor * (b.m12 * m.m12 + b.m22 * m.m22);
  const double scale = 1 / (a11 + a22);
  const point h{scale * (a22 * c.x - a12 * c.y), scale * (a11 * c.y - a21 * c.x)};
  return separation_along(h, to, v, inverse).is_beyond(v.reach);
}

bool site_tree::too_far(const node& n, const centre& v) {
  const offset_box to{{n.low.x - v.high.x, n.low.y - v.high.y},
                      {n.high.x - v.low.x, n.high.y - v.low.y}};
  if (v.outline != nullptr) return is_outside(n, to, *v.outline);
  return too_far(to, v, {n.inverse, n.spread_squared});
}

// Uses that M_w >= A / (tau^2 det B) for all sites w of the node, A the adjugate of its tensor B.
bool site_tree::is_outside(const node& n, const offset_box& to, const star_outline& outline) {
  const bool may_meet = to.low.x <= 0 && to.low.y <= 0 && to.high.x >= 0 && to.high.y >= 0;
  if (may_meet) return false;
  const metric_tensor& b = n.inverse;
  const double product = b.m11 * b.m22, square = b.m12 * b.m12,
               determinant = product - square + step * (product + square);
  // Below this the products may have underflowed, and the determinant be no upper bound.
  constexpr double least_determinant = 0x1p-900;
  if (!(determinant > least_determinant)) return false;
  return outline.excludes(to, {{b.m22, -b.m12, b.m11}, n.spread_squared * determinant * up});
}

bool site_tree::too_far(const site& w, const centre& v) {
  return too_far({w.position.x - v.low.x, w.position.y - v.low.y}, w.metric,
                 inverse_determinant_above(w.metric), v);
}

// Applies the test of a box to the single displacement d: both corners of the box are d, and the
// bound on its metrics is the adjugate over the determinant. With h = d the left side of the lemma
// and |g|_v^2 are one number; the values and their errors are those of separation_along, and up^3
// covers the roundings of the comparison.
bool site_tree::too_far(const point& d, const metric_tensor& m, double inverse_determinant,
                        const centre& v) {
  const metric_tensor& a = v.metric;
  const point g{a.m11 * d.x + a.m12 * d.y, a.m12 * d.x + a.m22 * d.y};
  const point size{a.m11 * std::abs(d.x) + std::abs(a.m12 * d.y),
                   std::abs(a.m12 * d.x) + a.m22 * std::abs(d.y)};
  const double square = g.x * d.x + g.y * d.y,
               error = step * (size.x * std::abs(d.x) + size.y * std::abs(d.y));
  const double least = square - error, own = (square + error + 0x1p-300) * up;
  const double r_squared = v.reach * v.reach;
  if (!(least * least > 4 * r_squared * own)) return false;
  const double across = m.m12 * g.x * g.y;
  const double mixed = std::abs(m.m12) * size.x * size.y;
  const double other = m.m22 * g.x * g.x + m.m11 * g.y * g.y - 2 * across,
               magnitude = m.m22 * size.x * size.x + m.m11 * size.y * size.y + 2 * mixed;
  const double other_squared = (other + step * magnitude + 0x1p-300) * inverse_determinant * up;
  constexpr double most = 0x1p200, least_squared = 0x1p-400;
  const bool in_range = least > 0x1p-300 && size.x + size.y < most && m.m11 + m.m22 < most &&
                        std::abs(d.x) + std::abs(d.y) < most && inverse_determinant < most &&
                        v.reach < most;
  if (!in_range) return false;
  if (least * least > 2 * std::max(r_squared, least_squared) *
                          (own + std::max(own, other_squared)) * (up * up * up))
    return true;
  const inverse_bound inverse{{m.m22, -m.m12, m.m11}, inverse_determinant};
  const double turned = trace_above(inverse.tensor, a) * inverse_determinant * up * own * up;
  const separation plain{least, own, std::min(other_squared, turned)};
  return plain.is_beyond(v.reach) || too_far_from_both(d, {d, d}, v, inverse);
}

// Bounds ((1 + sigma) reach)^2: (1 + sigma)^2 <= 2 + 2 sigma^2, and sigma^2 is at most the trace of
// M_w^-1 M_v, or 1 if that is more.
double site_tree::far_squared(const node& n, const centre& v) {
  if (!(n.spread_squared < 0x1p200 && v.reach < 0x1p200)) return infinity;
  const double trace = trace_above(n.inverse, v.metric) * n.spread_squared * up;
  const double far = 2 * (1 + (trace > 1 ? trace : 1)) * (v.reach * v.reach * up) * up;
  return far > 0x1p-500 && far < 0x1p700 ? far : infinity;
}

// Bounds 1 / (1 + sigma)^2 from below: (1 + sigma)^2 <= 2 + 2 sigma^2, and sigma^2 is at most the
// product of both spreads and the greater eigenvalue of B M, or 1 if that is more. B is the node's
// tensor and M that of the stars. The radicand has an error of a few roundings of the trace's
// square.
double site_tree::share_of(const node& n, const centre& stars) {
  if (!(n.spread_squared < 0x1p200)) return 0;
  const double half = 0.5 * trace_above(n.inverse, stars.metric), square = half * half,
               determinant = determinant_below(n.inverse) * determinant_below(stars.metric);
  const double radicand = std::max(0.0, square - determinant) + step * square;
  const double sigma_squared =
      (half + std::sqrt(radicand)) * n.spread_squared * stars.spread_squared * (up * up);
  if (!(sigma_squared < 0x1p200)) return 0;
  return 1 / (2 * (1 + (sigma_squared > 1 ? sigma_squared : 1)) * up);
}

// Bounds the rounding errors: each monomial passes at most six roundings.
bool site_tree::is_farther(const point& d, const metric_tensor& m, double far_squared) {
  const double xx = m.m11 * d.x * d.x, yy = m.m22 * d.y * d.y, xy = 2 * (m.m12 * d.x * d.y);
  const double square = xx + yy + xy - step * (xx + yy + std::abs(xy));
  return square > far_squared * up && square < 0x1p800 && std::abs(d.x) + std::abs(d.y) < 0x1p400;
}

bool site_tree::is_too_far(const site& v, double reach, const site& w) {
  return too_far(w, centre_of(v, reach));
}

}  // namespace asterism::internal::audit_detail
