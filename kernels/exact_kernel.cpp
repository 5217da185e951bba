// SPDX-License-Identifier: MIT
#include "asterism/kernels/exact_kernel.hpp"

#include <optional>
#include <vector>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/core/square_root_sum.hpp"
#include "asterism/kernels/exact_arc.hpp"
#include "asterism/kernels/exact_to_interval.hpp"
#include "asterism/kernels/fixed_width.hpp"
#include "asterism/kernels/interval_arc_point.hpp"
#include "asterism/kernels/magnitude.hpp"
#include "asterism/kernels/predicate_kernel.hpp"
#include "asterism/kernels/root_line.hpp"
#include "asterism/kernels/staged_search.hpp"
#include "asterism/kernels/turn_scale.hpp"
#include "asterism/predicates/arc_intersections.hpp"
#include "asterism/predicates/compare_distance.hpp"
#include "asterism/predicates/domination.hpp"
#include "asterism/predicates/encroachment.hpp"
#include "asterism/predicates/in_circle.hpp"
#include "asterism/predicates/insertion_test.hpp"
#include "asterism/predicates/orientation.hpp"
#include "asterism/predicates/positive_definite.hpp"
#include "asterism/predicates/tie_breaking.hpp"
#include "asterism/predicates/voronoi_vertices.hpp"
#include "asterism/predicates/wedge.hpp"

namespace asterism {
using namespace internal;

static_assert(predicate_kernel<exact_kernel>);

namespace {

using exact::add_zeros;
using exact::arc;
using exact::dense_polynomial;
using exact::real_root;
using exact::root_line;

// The point p of the arc at parameter m, by its weighted displacement from v.
struct exact_arc_point {
  dyadic radicand;
  displacement<square_root_sum> from_v;
  square_root_sum weight;

  exact_arc_point(const arc& on, const dyadic& m) : radicand(on.e(m)) {
    const auto u = on.direction(dyadic(1), m);
    from_v = {square_root_sum(on.c * u.x), square_root_sum(on.c * u.y)};
    weight = square_root_sum(on.h(m), dyadic(1), radicand);
  }
  exact_arc_point(const exact_arc_point&) = delete;
  exact_arc_point& operator=(const exact_arc_point&) = delete;
};

struct exact_arithmetic {
  template <std::size_t Degree>
  static std::optional<std::vector<real_root>> real_roots(const polynomial<dyadic, Degree>& p) {
    return exact::isolate_real_roots(dense_polynomial(p));
  }
  template <std::size_t Degree>
  static sign sign_at(const polynomial<dyadic, Degree>& p, real_root& root) {
    return exact::sign_at(p, root);
  }
  template <class... Polynomials>
  static std::optional<std::vector<dyadic>> samples(const Polynomials&... polynomials) {
    root_line line;
    (line.add(dense_polynomial(polynomials), 0), ...);
    return line.samples();
  }
  static sign function_sign(const arc& on, const arc_function<dyadic>& f, const dyadic& m) {
    return exact::sign_at(on, f, m);
  }
};

bool is_true(uncertain_bool answer) { return answer.value(); }

constexpr unsigned tag_arc = 0, tag_x = 1, tag_y = 2, tag_other = 3;

struct insertion_sections {
  insertion_question<dyadic> question;
  root_line line;
  std::vector<dyadic> samples;
  arc_function<dyadic> equidistance_x, equidistance_y;

  insertion_sections(const site& v, const site& w, const site& x, const site& y)
      : question(convert<dyadic>(v), convert<dyadic>(w), convert<dyadic>(x), convert<dyadic>(y),
                 dyadic(1).scaled(turn_scale_exponent(v.metric))),
        equidistance_x(question.at_x.equidistance()),
        equidistance_y(question.at_y.equidistance()) {
    const arc& on = question.arc;
    line.add(dense_polynomial(on.e), tag_arc);
    line.add(dense_polynomial(on.h), tag_arc);
    line.add(dense_polynomial(on.a), tag_arc);
    add_zeros(line, on, equidistance_x, tag_x);
    add_zeros(line, on, equidistance_y, tag_y);
    const auto add_other = [&](const arc_function<dyadic>& f) {
      add_zeros(line, on, f, tag_other);
    };
    question.at_x.visit_other_critical_functions(add_other);
    question.at_y.visit_other_critical_functions(add_other);
    samples = line.samples();
  }

  bool on_arc(std::size_t k) const { return is_true(question.arc.contains(dyadic(1), samples[k])); }
  bool allowed(const neighbour_condition<dyadic>& by, std::size_t k) const {
    const exact_arc_point p(question.arc, samples[k]);
    return is_true(by.holds(p.from_v, p.weight));
  }

  bool any_good_section() const {
    for (std::size_t k = 0; k < samples.size(); ++k)
      if (on_arc(k) && allowed(question.at_x, k) && allowed(question.at_y, k)) return true;
    return false;
  }

  // Returns the sign of f at a root of the line that lies on the arc.
  sign value_at(const arc_function<dyadic>& f, real_root& root) const {
    return exact::sign_at(question.arc, f, root);
  }

  // Returns on which side of z's bisector the section lies that z (x or y) allows at contact k:
  // positive if z is farther than v there, as usual; negative if z is nearer there but hidden
  // behind the cells of v and w.
  sign side_allowed(const neighbour_condition<dyadic>& z, const arc_function<dyadic>& equidistance,
                    std::size_t k) const {
    const std::size_t section = allowed(z, k) ? k : k + 1;
    return -exact_arithmetic::function_sign(question.arc, equidistance, samples[section]);
  }

  // True if the section allowed by x and the one allowed by y touch at cut k, and all four sites
  // are equally far from the point there.
  bool is_four_site_contact(std::size_t k) {
    constexpr std::uint64_t both = (1U << tag_x) | (1U << tag_y);
    exact::cut& at = line.cuts()[k];
    if ((at.vanishing & both) != both) return false;
    if (!on_arc(k) || !on_arc(k + 1) || !exact::is_on_arc(question.arc, at.root)) return false;
    const bool touch = (allowed(question.at_x, k) && allowed(question.at_y, k + 1)) ||
                       (allowed(question.at_y, k) && allowed(question.at_x, k + 1));
    return touch && value_at(equidistance_x, at.root) == sign::zero &&
           value_at(equidistance_y, at.root) == sign::zero;
  }
};

// Searches for a witness or a cover: first with exact coefficients enclosed by intervals, which
// settles questions undecided only because coefficients were rounded or exact zeros lost; then in
// exact numbers alone. Undecided on ties and tangencies, and if the magnitudes do not let doubles
// propose parameters.
[[gnu::noinline]] uncertain_bool search_upward(const std::array<site, 4>& sites) {
  constexpr int most_ranges = 64;
  return search_in_stages<interval, interval_arc_point, dyadic>(sites, most_ranges);
}

uncertain_bool search_arc(const site& v, const site& w, const site& x, const site& y) {
  // Leaves questions that a few ranges do not settle to the sections of the line. These are ties or
  // tangencies, which ranges never settle, and sections take less time. Sets of 64 questions one
  // unit from the border, and of 64 ties, took 28 and 108 ms with 64 ranges, 24 and 73 with 32, 22
  // and 56 with 16, 24 and 47 with 8.
  constexpr int most_ranges = 16;
  const floating_point_scope scope(rounding::nearest);
  const scaled_input<4, 0> input({&v, &w, &x, &y}, {});
  if (!input.usable) return {};
  {
    const floating_point_scope upward(rounding::upward);
    const uncertain_bool found = search_upward(input.sites);
    if (found.certain()) return found;
  }
  return search_in_stages<dyadic, exact_arc_point>(input.sites, most_ranges);
}

bool equal_metrics(const site& v, const site& w, const site& x, const site& y) {
  return v.metric == w.metric && v.metric == x.metric && v.metric == y.metric;
}

template <class TieRule>
bool equal_metric_answer(const site& v, const site& w, const site& x, const site& y,
                         TieRule&& tie) {
  const auto as_exact = [](const site& s) { return convert<dyadic>(s.position); };
  return is_true(insertion_test_equal_metrics(convert<dyadic>(v).metric, as_exact(v), as_exact(w),
                                              as_exact(x), as_exact(y), tie));
}

// Holds the predicates over integers of any size, for questions beyond a fixed width.
namespace unbounded {

sign orientation(const point& p, const point& q, const point& r) {
  return asterism::internal::orientation(convert<dyadic>(p), convert<dyadic>(q), convert<dyadic>(r))
      .value();
}

bool is_positive_definite(const metric_tensor& metric) {
  return is_true(
      asterism::internal::is_positive_definite(convert<dyadic>(site{{}, metric}).metric));
}

sign in_circle(const metric_tensor& m, const point& a, const point& b, const point& c,
               const point& p) {
  return asterism::internal::in_circle(convert<dyadic>(site{{}, m}).metric, convert<dyadic>(a),
                                       convert<dyadic>(b), convert<dyadic>(c), convert<dyadic>(p))
      .value();
}

sign compare_distance(const site& v, const site& w, const point& q) {
  return asterism::internal::compare_distance(convert<dyadic>(v), convert<dyadic>(w),
                                              convert<dyadic>(q))
      .value();
}

bool in_wedge(const site& v, const site& w, const point& q) {
  return is_true(
      asterism::internal::in_wedge(convert<dyadic>(v), convert<dyadic>(w), convert<dyadic>(q)));
}

sign dominates(const site& v, const site& w, const point& p) {
  return asterism::internal::dominates(convert<dyadic>(v), convert<dyadic>(w), convert<dyadic>(p))
      .value();
}

}  // namespace unbounded

}  // namespace

sign exact_kernel::orientation(const point& p, const point& q, const point& r) const {
  const uncertain_sign found = fixed_width::orientation(p, q, r);
  return found.certain() ? found.value() : unbounded::orientation(p, q, r);
}

bool exact_kernel::is_positive_definite(const metric_tensor& metric) const {
  const uncertain_bool found = fixed_width::is_positive_definite(metric);
  return found.certain() ? found.value() : unbounded::is_positive_definite(metric);
}

sign exact_kernel::in_circle(const metric_tensor& m, const point& a, const point& b, const point& c,
                             const point& p) const {
  const uncertain_sign found = fixed_width::in_circle(m, a, b, c, p);
  return found.certain() ? found.value() : unbounded::in_circle(m, a, b, c, p);
}

sign exact_kernel::compare_distance(const site& v, const site& w, const point& q) const {
  const uncertain_sign found = fixed_width::compare_distance(v, w, q);
  return found.certain() ? found.value() : unbounded::compare_distance(v, w, q);
}

bool exact_kernel::in_wedge(const site& v, const site& w, const point& q) const {
  const uncertain_bool found = fixed_width::in_wedge(v, w, q);
  return found.certain() ? found.value() : unbounded::in_wedge(v, w, q);
}

sign exact_kernel::dominates(const site& v, const site& w, const point& p) const {
  const uncertain_sign found = fixed_width::dominates(v, w, p);
  return found.certain() ? found.value() : unbounded::dominates(v, w, p);
}

int exact_kernel::voronoi_vertex_count(const site& u, const site& v, const site& w) const {
  return asterism::internal::voronoi_vertex_count<exact_arithmetic>(
             convert<dyadic>(u), convert<dyadic>(v), convert<dyadic>(w))
      .value();
}

int exact_kernel::arc_intersection_count(const site& v, const site& w, const site& x) const {
  const arc on(convert<dyadic>(v), convert<dyadic>(w),
               dyadic(1).scaled(turn_scale_exponent(v.metric)));
  return asterism::internal::arc_intersection_count<exact_arithmetic>(on, convert<dyadic>(x))
      .value();
}

bool exact_kernel::encroaches(const site& a, const site& b, const site& w) const {
  const encroachment_question<dyadic> question(convert<dyadic>(a), convert<dyadic>(b),
                                               convert<dyadic>(w));
  root_line line;
  line.add(dense_polynomial(question.against_a), 0);
  line.add(dense_polynomial(question.against_b), 0);
  line.add(dense_polynomial(std::vector<dyadic>{dyadic(0), dyadic(1)}), 0);  // the end a
  for (const dyadic& m : line.samples())
    if (is_true(question.holds(dyadic(1), m))) return true;
  return false;
}

namespace {

// Opens a scope, out of line, since doubles are compared here, and a processor set to flush
// compares subnormal numbers as zeros (core/floating_point_environment.hpp).
[[gnu::noinline]] bool insertion_test_in_scope(const site& v, const site& w, const site& x,
                                               const site& y) {
  if (equal_metrics(v, w, x, y)) {
    const uncertain_bool short_answer = fixed_width::insertion_test_equal_metrics(v, w, x, y);
    return short_answer.certain() ? short_answer.value()
                                  : equal_metric_answer(v, w, x, y, [] { return false; });
  }
  const uncertain_bool found = search_arc(v, w, x, y);
  return found.certain() ? found.value() : insertion_sections(v, w, x, y).any_good_section();
}

[[gnu::noinline]] bool edge_test_in_scope(const site& v, const site& w, const site& x,
                                          const site& y) {
  if (equal_metrics(v, w, x, y)) {
    const uncertain_bool short_answer = fixed_width::edge_test_equal_metrics(v, w, x, y);
    if (short_answer.certain()) return short_answer.value();
    return equal_metric_answer(v, w, x, y, [&] {
      return equal_metric_tie_goes_to_edge(v.position, w.position, x.position, y.position);
    });
  }
  // Accepts a certain "no" of the search, which excludes a tie (kernels/arc_search.hpp).
  const uncertain_bool found = search_arc(v, w, x, y);
  if (found.certain()) return found.value();
  insertion_sections sections(v, w, x, y);
  if (sections.any_good_section()) return true;
  for (std::size_t k = 0; k < sections.line.cuts().size(); ++k) {
    if (!sections.is_four_site_contact(k)) continue;
    real_root& contact = sections.line.cuts()[k].root;
    const auto sign_at_contact = [&](const plane_quadratic<dyadic>& q) {
      return sections.value_at(sections.question.arc.restrict(q), contact);
    };
    if (tie_goes_to_edge<dyadic>(
            {convert<dyadic>(v), convert<dyadic>(w), convert<dyadic>(x), convert<dyadic>(y)},
            {v.position, w.position, x.position, y.position},
            {sections.side_allowed(sections.question.at_x, sections.equidistance_x, k),
             sections.side_allowed(sections.question.at_y, sections.equidistance_y, k)},
            sign_at_contact))
      return true;
  }
  return false;
}

}  // namespace

bool exact_kernel::insertion_test(const site& v, const site& w, const site& x,
                                  const site& y) const {
  const floating_point_scope scope(rounding::nearest);
  return insertion_test_in_scope(v, w, x, y);
}

bool exact_kernel::edge_test(const site& v, const site& w, const site& x, const site& y) const {
  const floating_point_scope scope(rounding::nearest);
  return edge_test_in_scope(v, w, x, y);
}

}  // namespace asterism
