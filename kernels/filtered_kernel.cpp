// SPDX-License-Identifier: MIT
#include "asterism/kernels/filtered_kernel.hpp"

#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/interval_kernel.hpp"

namespace asterism {

namespace {

// Interval first, exact when undecided; counts who decided.
template <class Ask>
auto decide(tier_counters& counters, predicate which, const Ask& ask) {
  const auto answer = ask(interval_kernel{});
  ++counters.at(which, answer.certain() ? tier::interval : tier::exact);
  return answer.certain() ? answer.value() : ask(exact_kernel{});
}

}  // namespace

sign filtered_kernel::orientation(const point& p, const point& q, const point& r) const {
  const auto ask = [&](const auto& kernel) { return kernel.orientation(p, q, r); };
  return decide(counters_, predicate::orientation, ask);
}

bool filtered_kernel::is_positive_definite(const metric_tensor& metric) const {
  const auto ask = [&](const auto& kernel) { return kernel.is_positive_definite(metric); };
  return decide(counters_, predicate::is_spd, ask);
}

sign filtered_kernel::compare_distance(const site& v, const site& w, const point& q) const {
  const auto ask = [&](const auto& kernel) { return kernel.compare_distance(v, w, q); };
  return decide(counters_, predicate::compare_distance, ask);
}

bool filtered_kernel::in_wedge(const site& v, const site& w, const point& q) const {
  const auto ask = [&](const auto& kernel) { return kernel.in_wedge(v, w, q); };
  return decide(counters_, predicate::in_wedge, ask);
}

sign filtered_kernel::dominates(const site& v, const site& w, const point& p) const {
  const auto ask = [&](const auto& kernel) { return kernel.dominates(v, w, p); };
  return decide(counters_, predicate::dominates, ask);
}

int filtered_kernel::voronoi_vertex_count(const site& u, const site& v, const site& w) const {
  const auto ask = [&](const auto& kernel) { return kernel.voronoi_vertex_count(u, v, w); };
  return decide(counters_, predicate::voronoi_vertex_count, ask);
}

int filtered_kernel::arc_intersection_count(const site& v, const site& w, const site& x) const {
  const auto ask = [&](const auto& kernel) { return kernel.arc_intersection_count(v, w, x); };
  return decide(counters_, predicate::arc_intersection_count, ask);
}

bool filtered_kernel::encroaches(const site& a, const site& b, const site& w) const {
  const auto ask = [&](const auto& kernel) { return kernel.encroaches(a, b, w); };
  return decide(counters_, predicate::encroaches, ask);
}

bool filtered_kernel::insertion_test(const site& v, const site& w, const site& x,
                                     const site& y) const {
  const auto ask = [&](const auto& kernel) { return kernel.insertion_test(v, w, x, y); };
  return decide(counters_, predicate::insertion_test, ask);
}

bool filtered_kernel::edge_test(const site& v, const site& w, const site& x, const site& y) const {
  const auto ask = [&](const auto& kernel) { return kernel.edge_test(v, w, x, y); };
  return decide(counters_, predicate::edge_test, ask);
}

}  // namespace asterism
