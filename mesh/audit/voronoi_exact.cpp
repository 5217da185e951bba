// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/voronoi_exact.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "asterism/kernels/exact_to_interval.hpp"
#include "asterism/kernels/turn_scale.hpp"
#include "asterism/predicates/encroachment.hpp"
#include "asterism/predicates/in_circle.hpp"

namespace asterism::internal::audit_detail {
namespace {

using exact_site = basic_site<dyadic>;

// Returns (p - i)^T M_i (j - i), with p relative to `origin`: positive where i sees p within a
// right angle of j.
plane_quadratic<dyadic> wedge_side(const basic_point<dyadic>& origin, const exact_site& i,
                                   const exact_site& j) {
  const auto covector = apply(i.metric, between(i.position, j.position));
  return {{dyadic(0), dyadic(0), dyadic(0)}, covector, dot(covector, between(i.position, origin))};
}

// Returns bounds of the number in doubles, from its two dyadic bounds.
bounded around(const dyadic& low, const dyadic& high) {
  const interval below = enclose(low), above = enclose(high);
  const double middle = 0.5 * below.inf() + 0.5 * above.sup();
  const bounded width = bounded(above.sup()) - bounded(below.inf());
  if (!(width.upper() < std::numeric_limits<double>::infinity()))
    return bounded::within(0, std::numeric_limits<double>::infinity());
  return bounded::within(middle, width.upper());
}

}  // namespace

exact_voronoi_arc::exact_voronoi_arc(const site& v, const site& u)
    : v_(v),
      u_(u),
      on_(convert<dyadic>(v), convert<dyadic>(u), dyadic(1).scaled(turn_scale_exponent(v.metric))) {
}

bool exact_voronoi_arc::is_wedged_with(const site& third, parameter at) const {
  const exact_site x = convert<dyadic>(third);
  const auto& origin = on_.v.position;
  for (const auto& side : {wedge_side(origin, on_.v, x), wedge_side(origin, x, on_.v),
                           wedge_side(origin, on_.w, x), wedge_side(origin, x, on_.w)})
    if (exact::sign_at(on_, on_.restrict(side), at) != sign::positive) return false;
  return true;
}

std::optional<exact_voronoi_arc::parameter> exact_voronoi_arc::vertex(const site& third) const {
  const auto equidistance = on_.restrict(distance_difference(on_.v, convert<dyadic>(third)));
  exact::root_line line;
  exact::add_zeros(line, on_, equidistance, 0);
  for (exact::cut& c : line.cuts()) {
    if (!exact::is_on_arc(on_, c.root)) continue;
    if (exact::sign_at(on_, equidistance, c.root) != sign::zero) continue;
    if (is_wedged_with(third, c.root)) return c.root;
  }
  return std::nullopt;
}

exact_voronoi_arc::parameter exact_voronoi_arc::on_segment() {
  const exact::dense_polynomial itself(std::vector<dyadic>{dyadic(0), dyadic(1)});
  return {itself, dyadic(0), dyadic(0), sign::positive};
}

arc_meeting exact_voronoi_arc::meeting_with(const site& w, parameter from, parameter to) const {
  const auto excess = on_.restrict(distance_difference(on_.v, convert<dyadic>(w)));  // f_v - f_w
  exact::root_line line;
  line.add(from.defining(), 0);
  line.add(to.defining(), 0);
  exact::add_zeros(line, on_, excess, 1);
  const std::vector<dyadic> samples = line.samples();
  arc_meeting meeting;
  meeting.at_from = exact::sign_at(on_, excess, from) == sign::zero;
  meeting.at_to = exact::sign_at(on_, excess, to) == sign::zero;
  for (std::size_t k = 0; k < line.cuts().size(); ++k) {
    exact::real_root& cut = line.cuts()[k].root;
    const bool after_from = compare(from, cut) == sign::negative;
    if (after_from && compare(to, cut) == sign::positive &&
        exact::sign_at(on_, excess, cut) == sign::zero)
      meeting.between = true;
    // Evaluates the section of the arc that ends at this root.
    if (!after_from || compare(to, cut) == sign::negative) continue;
    const sign sample = exact::sign_at(on_, excess, samples[k]);
    meeting.nearer = meeting.nearer || sample == sign::positive;
    meeting.between = meeting.between || sample == sign::zero;
  }
  return meeting;
}

offset exact_voronoi_arc::enclose(parameter at) const {
  constexpr int most_halvings = 512, halvings_a_turn = 128;
  const double turn = std::ldexp(1.0, turn_scale_exponent(v_.metric));
  const offset to_u = audit_detail::between(v_.position, u_.position),
               covector = tensor_of_doubles(v_.metric) * to_u,
               across{bounded(turn) * -covector.y, bounded(turn) * covector.x};
  for (int halvings = 1; halvings <= most_halvings; ++halvings) {
    at.refine();
    if (halvings % halvings_a_turn == 0 || at.is_dyadic()) {
      const bounded m = around(at.low(), at.high());
      const offset direction{to_u.x + m * across.x, to_u.y + m * across.y};
      if (const auto found = enclose_bisector_point(v_, u_, direction)) return *found;
      if (at.is_dyadic()) break;
    }
  }
  const bounded unknown = bounded::within(0, std::numeric_limits<double>::infinity());
  return {unknown, unknown};
}

// Decides by two differences: f_w - f_a and f_w - f_b along the segment are positive at a,
// respectively at b. Where w meets the segment without encroaching, the greater of the two
// differences is zero.
segment_meeting meeting_with_segment(const site& a, const site& b, const site& w) {
  const encroachment_question<dyadic> question(convert<dyadic>(a), convert<dyadic>(b),
                                               convert<dyadic>(w));
  segment_meeting meeting = segment_meeting::apart;
  for (const auto& [one, other] : {std::pair(&question.against_a, &question.against_b),
                                   std::pair(&question.against_b, &question.against_a)})
    for (exact::real_root& root : exact::isolate_real_roots(exact::dense_polynomial(*one))) {
      if (root.sign_of_value(exact::dense_polynomial(std::vector{dyadic(0), dyadic(1)})) !=
          sign::positive)
        continue;
      const sign beside = exact::sign_at(*other, root);
      if (beside == sign::negative) return segment_meeting::as_near;
      if (beside == sign::zero) meeting = segment_meeting::at_middle;
    }
  return meeting;
}

sign excess_at_centre(const metric_tensor& metric, const point& a, const point& b, const point& c,
                      const point& d) {
  const auto exact = [](const point& p) { return convert<dyadic>(p); };
  const basic_metric_tensor<dyadic> m{dyadic(metric.m11), dyadic(metric.m12), dyadic(metric.m22)};
  return -in_circle(m, exact(a), exact(b), exact(c), exact(d)).value();
}

}  // namespace asterism::internal::audit_detail
