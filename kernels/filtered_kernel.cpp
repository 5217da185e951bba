// SPDX-License-Identifier: MIT
#include "asterism/kernels/filtered_kernel.hpp"

#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/interval_kernel.hpp"
#include "asterism/kernels/semi_static_filter.hpp"
#include "asterism/kernels/star_gap.hpp"

namespace asterism {

namespace {

// Interval first, exact when undecided; counts who decided.
template <class Ask>
[[gnu::noinline]] auto decide_slowly(tier_counters& counters, predicate which, const Ask& ask) {
  const auto answer = ask(interval_kernel{});
  ++counters.at(which, answer.certain() ? tier::interval : tier::exact);
  return answer.certain() ? answer.value() : ask(exact_kernel{});
}

// The answer of the semi-static tier when it has one.
template <class Answer, class Ask>
Answer decide(tier_counters& counters, predicate which, uncertain<Answer> first, const Ask& ask) {
  if (first.certain()) {
    ++counters.at(which, tier::semi_static);
    return first.value();
  }
  return decide_slowly(counters, which, ask);
}

// In the caller's environment, so by the bits.
bool equal_metrics(const site& v, const site& w, const site& x, const site& y) {
  return identical(v.metric, w.metric) && identical(v.metric, x.metric) &&
         identical(v.metric, y.metric);
}

// edge_test as a question about one gap of v's star, when w looks to be in one of less than half a
// turn; star_gap verifies what it needs of that.
uncertain_bool ask_gap(const site& v, const site& w, const site& x, const site& y) {
  const auto to_w = between(v.position, w.position), to_x = between(v.position, x.position),
             to_y = between(v.position, y.position);
  const bool left_of_x = cross(to_x, to_w) > 0, right_of_y = cross(to_w, to_y) > 0,
             y_left_of_x = cross(to_x, to_y) > 0;
  if (left_of_x != right_of_y || left_of_x != y_left_of_x) return {};
  return left_of_x ? star_gap(v, x, y).accepts(w) : star_gap(v, y, x).accepts(w);
}

// The question is the same to v and to w; one of them may see it more clearly.
uncertain_bool ask_gaps(const site& v, const site& w, const site& x, const site& y) {
  const uncertain_bool by_v = ask_gap(v, w, x, y);
  return by_v.certain() ? by_v : ask_gap(w, v, x, y);
}

}  // namespace

sign filtered_kernel::orientation(const point& p, const point& q, const point& r) const {
  const auto ask = [&](const auto& kernel) { return kernel.orientation(p, q, r); };
  return decide(counters_, predicate::orientation, semi_static::orientation(p, q, r), ask);
}

bool filtered_kernel::is_positive_definite(const metric_tensor& metric) const {
  const auto ask = [&](const auto& kernel) { return kernel.is_positive_definite(metric); };
  return decide(counters_, predicate::is_spd, semi_static::is_positive_definite(metric), ask);
}

sign filtered_kernel::compare_distance(const site& v, const site& w, const point& q) const {
  const auto ask = [&](const auto& kernel) { return kernel.compare_distance(v, w, q); };
  return decide(counters_, predicate::compare_distance, semi_static::compare_distance(v, w, q),
                ask);
}

bool filtered_kernel::in_wedge(const site& v, const site& w, const point& q) const {
  const auto ask = [&](const auto& kernel) { return kernel.in_wedge(v, w, q); };
  return decide(counters_, predicate::in_wedge, semi_static::in_wedge(v, w, q), ask);
}

sign filtered_kernel::dominates(const site& v, const site& w, const point& p) const {
  const auto ask = [&](const auto& kernel) { return kernel.dominates(v, w, p); };
  return decide(counters_, predicate::dominates, semi_static::dominates(v, w, p), ask);
}

int filtered_kernel::voronoi_vertex_count(const site& u, const site& v, const site& w) const {
  const auto ask = [&](const auto& kernel) { return kernel.voronoi_vertex_count(u, v, w); };
  return decide_slowly(counters_, predicate::voronoi_vertex_count, ask);
}

int filtered_kernel::arc_intersection_count(const site& v, const site& w, const site& x) const {
  const auto ask = [&](const auto& kernel) { return kernel.arc_intersection_count(v, w, x); };
  return decide_slowly(counters_, predicate::arc_intersection_count, ask);
}

bool filtered_kernel::encroaches(const site& a, const site& b, const site& w) const {
  const auto ask = [&](const auto& kernel) { return kernel.encroaches(a, b, w); };
  return decide_slowly(counters_, predicate::encroaches, ask);
}

bool filtered_kernel::insertion_test(const site& v, const site& w, const site& x,
                                     const site& y) const {
  const auto ask = [&](const auto& kernel) { return kernel.insertion_test(v, w, x, y); };
  const uncertain_bool first = equal_metrics(v, w, x, y)
                                   ? semi_static::insertion_test_equal_metrics(v, w, x, y)
                                   : uncertain_bool();
  return decide(counters_, predicate::insertion_test, first, ask);
}

bool filtered_kernel::edge_test(const site& v, const site& w, const site& x, const site& y) const {
  const auto ask = [&](const auto& kernel) { return kernel.edge_test(v, w, x, y); };
  const uncertain_bool first = equal_metrics(v, w, x, y)
                                   ? semi_static::insertion_test_equal_metrics(v, w, x, y)
                                   : ask_gaps(v, w, x, y);
  return decide(counters_, predicate::edge_test, first, ask);
}

}  // namespace asterism
