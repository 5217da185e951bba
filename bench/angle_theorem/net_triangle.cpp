// SPDX-License-Identifier: MIT
#include "net_triangle.hpp"

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "interval_quotient.hpp"

namespace asterism::internal::angle_theorem {
namespace {

struct plane_interval {
  interval x = 0, y = 0;
};

plane_interval operator-(const plane_interval& a, const plane_interval& b) {
  return {a.x - b.x, a.y - b.y};
}
interval inner(const plane_interval& a, const plane_interval& b) { return a.x * b.x + a.y * b.y; }
interval square_norm(const plane_interval& a) { return squared(a.x) + squared(a.y); }
interval cross(const plane_interval& a, const plane_interval& b) { return a.x * b.y - a.y * b.x; }

// A site b or c: its vector from x, its vector from a, and the greatest distortion between its
// metric and a's.
struct other_site {
  plane_interval from_vertex, from_observer;
  double distortion = 1;
};

// Returns the greatest distortion between a and a site within `distance`: 1/(1 - sigma d). The
// distance in a's metric is at least the smaller of the two distances.
double greatest_distortion(const interval& distance, const hypotheses& given) {
  const interval rest = interval(1) - interval(given.variation) * interval(distance.sup());
  if (!(rest.inf() > 0)) return given.distortion_cap;
  return std::min(given.distortion_cap, (interval(1) / rest).sup());
}

other_site make_site(const configuration_box& box, int first, const hypotheses& given) {
  other_site s;
  s.from_vertex = {interval(box.low[first], box.high[first]),
                   interval(box.low[first + 1], box.high[first + 1])};
  s.from_observer = {s.from_vertex.x + interval(1), s.from_vertex.y};
  s.distortion =
      greatest_distortion(square_root_of_non_negative(square_norm(s.from_observer)), given);
  return s;
}

// Bounds |w|^2 in the metric of a site with |u| = 1 and known distortion.
struct length_bound {
  interval w2, u2, area2;    // |w|^2, |u|^2, (w x u)^2 in a's metric
  interval sum, difference;  // (t^2 + t^-2)/2 and (t^2 - t^-2)/2 for the distortion t

  // Returns an upper bound, for any m >= 0: m + the greatest trace(M (w w^T - m u u^T)) over all M
  // between t^-2 and t^2, from the eigenvalues of that matrix.
  interval at(double m) const {
    const interval trace = w2 - interval(m) * u2;
    return interval(m) + sum * trace +
           difference * square_root_of_non_negative(squared(trace) + interval(4 * m) * area2);
  }
};

// Returns an m near the least bound, for the middle of the box. Any m gives a valid bound, and the
// bound is convex in m.
double best_multiplier(const length_bound& bound) {
  const auto middle = [](const interval& i) { return (i.inf() + i.sup()) / 2; };
  const double w2 = middle(bound.w2), u2 = middle(bound.u2), area2 = middle(bound.area2);
  const double sum = middle(bound.sum), difference = middle(bound.difference);
  const auto value = [&](double m) {
    const double trace = w2 - m * u2;
    return m + sum * trace + difference * std::sqrt(trace * trace + 4 * m * area2);
  };
  double low = 0, high = 8;
  for (int step = 0; step < 30; ++step) {
    const double first = low + (high - low) * 0.4, second = low + (high - low) * 0.6;
    (value(first) < value(second) ? high : low) = value(first) < value(second) ? second : first;
  }
  return low;
}

// True if w is certainly shorter than the spacing in the site's metric.
bool certainly_shorter(const plane_interval& w, const other_site& site, const hypotheses& given) {
  const interval spacing2 = squared(interval(given.spacing));
  const interval t2 = squared(interval(site.distortion));
  length_bound bound;
  bound.w2 = square_norm(w);
  if ((t2 * bound.w2).sup() < spacing2.inf()) return true;
  // If w is too long even with t^-2 in place of t^2, no multiplier shows that it is short.
  if ((bound.w2 / t2).inf() >= spacing2.sup()) return false;
  bound.u2 = square_norm(site.from_vertex);
  bound.area2 = squared(cross(w, site.from_vertex));
  bound.sum = (t2 + interval(1) / t2) / interval(2);
  bound.difference = (t2 - interval(1) / t2) / interval(2);
  return bound.at(best_multiplier(bound)).sup() < spacing2.inf();
}

// True if no point of the box is a site at distance 1 from x in its own metric and far enough from
// a in one of the two metrics.
bool impossible(const other_site& s, const hypotheses& given) {
  const interval t2 = squared(interval(s.distortion));
  const interval radius2 = square_norm(s.from_vertex);
  if (radius2.inf() > t2.sup() || (radius2 * t2).sup() < 1) return true;
  return square_norm(s.from_observer).sup() < squared(interval(given.spacing)).inf() &&
         certainly_shorter(s.from_observer, s, given);
}

// True if the angle between p and q is certainly at least the bound.
bool certainly_wide(const plane_interval& p, const plane_interval& q, const hypotheses& given) {
  const interval area = cross(p, q);
  const interval size = area.inf() >= 0 ? area
                                        : interval(area.sup() <= 0 ? -area.sup() : 0,
                                                   std::max(area.sup(), -area.inf()));
  return (interval(given.cotangent) * size - inner(p, q)).inf() >= 0;
}

double cotangent_from_below(double degrees) {
  mpfr_t x, pi;
  mpfr_inits2(256, x, pi, static_cast<mpfr_ptr>(nullptr));
  // The cotangent falls: a bound of the argument from above gives one of the result from below.
  mpfr_const_pi(pi, MPFR_RNDU);
  mpfr_mul_d(x, pi, degrees, MPFR_RNDU);
  mpfr_div_ui(x, x, 180, MPFR_RNDU);
  mpfr_cot(x, x, MPFR_RNDD);
  const double result = mpfr_get_d(x, MPFR_RNDD);
  mpfr_clears(x, pi, static_cast<mpfr_ptr>(nullptr));
  return result;
}

}  // namespace

hypotheses make_hypotheses(double variation, double ratio, double degrees) {
  const floating_point_scope scope(rounding::upward);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  hypotheses h;
  h.variation = variation == 0 ? 0 : std::nextafter(variation, infinity);
  h.spacing = (interval(1) / interval(ratio == 1 ? 1 : std::nextafter(ratio, infinity))).inf();
  h.cotangent = cotangent_from_below(std::nextafter(degrees, infinity));
  h.distortion_cap = (interval(1) / squared(interval(1) - interval(h.variation))).sup();
  return h;
}

box_verdict judge(const configuration_box& box, const hypotheses& given) {
  const other_site b = make_site(box, 0, given), c = make_site(box, 2, given);
  const plane_interval &to_b = b.from_observer, &to_c = c.from_observer;
  // Mirror images, and the exchange of b and c, do not change the statement.
  if (cross(to_b, to_c).sup() < 0 || (to_b.y + to_c.y).sup() < 0) return box_verdict::excluded;
  if (impossible(b, given) || impossible(c, given)) return box_verdict::excluded;
  const plane_interval b_to_c = c.from_vertex - b.from_vertex;
  const plane_interval c_to_b = b.from_vertex - c.from_vertex;
  const plane_interval b_to_a = plane_interval{} - to_b, c_to_a = plane_interval{} - to_c;
  if (certainly_wide(to_b, to_c, given) && certainly_wide(b_to_a, b_to_c, given) &&
      certainly_wide(c_to_a, c_to_b, given))
    return box_verdict::angles_hold;
  if (certainly_shorter(b_to_c, b, given) && certainly_shorter(b_to_c, c, given))
    return box_verdict::excluded;
  return box_verdict::undecided;
}

}  // namespace asterism::internal::angle_theorem
