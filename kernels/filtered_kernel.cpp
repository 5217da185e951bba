// SPDX-License-Identifier: MIT
#include "asterism/kernels/filtered_kernel.hpp"

#include <cmath>

#include "asterism/core/integer.hpp"
#include "asterism/kernels/direction_cover.hpp"
#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/filtered_edge_test.hpp"
#include "asterism/kernels/fixed_width.hpp"
#include "asterism/kernels/interval_kernel.hpp"
#include "asterism/kernels/predicate_kernel.hpp"
#include "asterism/kernels/proposal.hpp"
#include "asterism/kernels/segment_witness.hpp"
#include "asterism/kernels/semi_static_filter.hpp"
#include "asterism/kernels/star_gap.hpp"
#include "asterism/kernels/turn_scale.hpp"
#include "asterism/kernels/vertex_hints.hpp"

namespace asterism {
using namespace internal;

static_assert(predicate_kernel<filtered_kernel>);

namespace {

void count(tier_counters* decided, predicate which, tier by) {
  if (decided != nullptr) ++decided->at(which, by);
}

// Evaluates intervals first, and exact numbers when these are undecided; counts the tier that
// decided.
template <class Ask>
[[gnu::noinline]] auto decide_slowly(tier_counters* decided, predicate which, const Ask& ask) {
  const auto answer = ask(interval_kernel{});
  count(decided, which, answer.certain() ? tier::interval : tier::exact);
  if (answer.certain()) return answer.value();
  const std::uint64_t before = limb_products_done;
  const auto exact = ask(exact_kernel{});
  if (decided != nullptr) decided->limb_products += limb_products_done - before;
  return exact;
}

// Decides tier by tier, like the function above, for predicates that cost no more than a function
// call. Exact integers of a fixed width come before intervals, as they cost less where they fit.
// Arguments are passed on in registers, and nothing is stored for a call that is not made.
template <predicate Which, auto OfShort, auto OfIntervals, auto OfExact, class... Arguments>
[[gnu::noinline]] auto decide_slowly(tier_counters* decided, const Arguments&... arguments) {
  auto answer = OfShort(arguments...);
  const bool fits = answer.certain();
  if (!fits) answer = (interval_kernel{}.*OfIntervals)(arguments...);
  count(decided, Which, !fits && answer.certain() ? tier::interval : tier::exact);
  return answer.certain() ? answer.value() : (exact_kernel{}.*OfExact)(arguments...);
}

template <predicate Which, auto OfShort, auto OfIntervals, auto OfExact, class Answer,
          class... Arguments>
Answer decide(tier_counters* decided, uncertain<Answer> first, const Arguments&... arguments) {
  if (!first.certain())
    return decide_slowly<Which, OfShort, OfIntervals, OfExact>(decided, arguments...);
  count(decided, Which, tier::semi_static);
  return first.value();
}

// Compares the bits, since this runs in the caller's environment.
bool equal_metrics(const site& v, const site& w, const site& x, const site& y) {
  return identical(v.metric, w.metric) && identical(v.metric, x.metric) &&
         identical(v.metric, y.metric);
}

// Decides edge_test by the gap of v's star between x and y, if w seems to lie in it and it is below
// 180 degrees; star_gap verifies these conditions.
uncertain_bool ask_gap(const site& v, const site& w, const site& x, const site& y) {
  const auto to_w = between(v.position, w.position), to_x = between(v.position, x.position),
             to_y = between(v.position, y.position);
  const bool left_of_x = cross(to_x, to_w) > 0, right_of_y = cross(to_w, to_y) > 0,
             y_left_of_x = cross(to_x, to_y) > 0;
  if (left_of_x != right_of_y || left_of_x != y_left_of_x) return {};
  return left_of_x ? star_gap(v, x, y).accepts(w) : star_gap(v, y, x).accepts(w);
}

// Evaluates the gap of v and, if that is undecided, the gap of w: both have the same answer, with
// different error bounds.
uncertain_bool ask_gaps(const site& v, const site& w, const site& x, const site& y) {
  const uncertain_bool by_v = ask_gap(v, w, x, y);
  return by_v.certain() ? by_v : ask_gap(w, v, x, y);
}
// Returns false if w is certainly refused, since no direction is left in which v and w may see a
// point that belongs to both; else undecided.
uncertain_bool ask_directions(const site& v, const site& w, const site& x, const site& y) {
  const bool refused = no_direction_is_left(v, w, x, y) || no_direction_is_left(w, v, x, y);
  return refused ? uncertain_bool(false) : uncertain_bool();
}

// True if plain doubles propose a point that shows the edge: the intervals, which begin with that
// point, then answer sooner than a cover of directions fails.
bool has_likely_witness(const site& v, const site& w, const site& x, const site& y) {
  return proposal([&] {
    const double turn = std::ldexp(1.0, turn_scale_exponent(v.metric));
    const auto hints = numeric::find_quick_hints(insertion_question<double>(v, w, x, y, turn));
    return hints && hints->witness;
  });
}

uncertain_bool ask_doubles(const site& v, const site& w, const site& x, const site& y) {
  if (segment_shows_edge(v, w, x, y)) return true;
  const uncertain_bool by_gaps = ask_gaps(v, w, x, y);
  if (by_gaps.certain() || has_likely_witness(v, w, x, y)) return by_gaps;
  return ask_directions(v, w, x, y);
}

}  // namespace

sign filtered_kernel::orientation(const point& p, const point& q, const point& r) const {
  return decide<predicate::orientation, &fixed_width::orientation, &interval_kernel::orientation,
                &exact_kernel::orientation>(decided_, semi_static::orientation(p, q, r), p, q, r);
}

bool filtered_kernel::is_positive_definite(const metric_tensor& metric) const {
  return decide<predicate::is_positive_definite, &fixed_width::is_positive_definite,
                &interval_kernel::is_positive_definite, &exact_kernel::is_positive_definite>(
      decided_, semi_static::is_positive_definite(metric), metric);
}

sign filtered_kernel::in_circle(const metric_tensor& m, const point& a, const point& b,
                                const point& c, const point& p) const {
  return decide<predicate::in_circle, &fixed_width::in_circle, &interval_kernel::in_circle,
                &exact_kernel::in_circle>(decided_, semi_static::in_circle(m, a, b, c, p), m, a, b,
                                          c, p);
}

sign filtered_kernel::compare_distance(const site& v, const site& w, const point& q) const {
  return decide<predicate::compare_distance, &fixed_width::compare_distance,
                &interval_kernel::compare_distance, &exact_kernel::compare_distance>(
      decided_, semi_static::compare_distance(v, w, q), v, w, q);
}

bool filtered_kernel::in_wedge(const site& v, const site& w, const point& q) const {
  return decide<predicate::in_wedge, &fixed_width::in_wedge, &interval_kernel::in_wedge,
                &exact_kernel::in_wedge>(decided_, semi_static::in_wedge(v, w, q), v, w, q);
}

sign filtered_kernel::dominates(const site& v, const site& w, const point& p) const {
  return decide<predicate::dominates, &fixed_width::dominates, &interval_kernel::dominates,
                &exact_kernel::dominates>(decided_, semi_static::dominates(v, w, p), v, w, p);
}

int filtered_kernel::voronoi_vertex_count(const site& u, const site& v, const site& w) const {
  const auto ask = [&](const auto& kernel) { return kernel.voronoi_vertex_count(u, v, w); };
  return decide_slowly(decided_, predicate::voronoi_vertex_count, ask);
}

int filtered_kernel::arc_intersection_count(const site& v, const site& w, const site& x) const {
  const auto ask = [&](const auto& kernel) { return kernel.arc_intersection_count(v, w, x); };
  return decide_slowly(decided_, predicate::arc_intersection_count, ask);
}

bool filtered_kernel::encroaches(const site& a, const site& b, const site& w) const {
  const auto ask = [&](const auto& kernel) { return kernel.encroaches(a, b, w); };
  return decide_slowly(decided_, predicate::encroaches, ask);
}

bool filtered_kernel::insertion_test(const site& v, const site& w, const site& x,
                                     const site& y) const {
  if (equal_metrics(v, w, x, y))
    return decide<predicate::insertion_test, &fixed_width::insertion_test_equal_metrics,
                  &interval_kernel::insertion_test, &exact_kernel::insertion_test>(
        decided_, semi_static::insertion_test_equal_metrics(v, w, x, y), v, w, x, y);
  const auto ask = [&](const auto& kernel) { return kernel.insertion_test(v, w, x, y); };
  const uncertain_bool quick = ask_directions(v, w, x, y);
  if (!quick.certain()) return decide_slowly(decided_, predicate::insertion_test, ask);
  count(decided_, predicate::insertion_test, tier::semi_static);
  return quick.value();
}

bool filtered_kernel::edge_test(const site& v, const site& w, const site& x, const site& y) const {
  if (equal_metrics(v, w, x, y))
    return decide<predicate::edge_test, &fixed_width::edge_test_equal_metrics,
                  &interval_kernel::edge_test, &exact_kernel::edge_test>(
        decided_, semi_static::insertion_test_equal_metrics(v, w, x, y), v, w, x, y);
  const auto ask = [&](const auto& kernel) { return kernel.edge_test(v, w, x, y); };
  const uncertain_bool quick = ask_doubles(v, w, x, y);
  if (!quick.certain()) return decide_slowly(decided_, predicate::edge_test, ask);
  count(decided_, predicate::edge_test, tier::semi_static);
  return quick.value();
}

uncertain_bool internal::filtered_edge_test(const site& v, const site& w, const site& x,
                                            const site& y, tier_counters& decided) {
  if (equal_metrics(v, w, x, y)) return filtered_kernel(decided).edge_test(v, w, x, y);
  const uncertain_bool quick = ask_doubles(v, w, x, y);
  count(&decided, predicate::edge_test, quick.certain() ? tier::semi_static : tier::interval);
  return quick.certain() ? quick : interval_kernel{}.edge_test(v, w, x, y);
}

}  // namespace asterism
