// SPDX-License-Identifier: MIT
#include "arc_sections.hpp"

#include <CGAL/Sqrt_extension.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "conic.hpp"
#include "sheared.hpp"
#include "unit_interval_roots.hpp"

namespace asterism::oracle {
namespace {

// Numbers a + b sqrt(c) with rational a, b, c.
using root_number = CGAL::Sqrt_extension<rational, rational>;
using sample_point = basic_point<root_number>;

// Returns the conic as a polynomial in Y whose coefficients are polynomials in X.
std::array<univariate, 3> by_powers_of_y(const conic& g) {
  return {univariate{g.constant, g.x, g.xx}, univariate{g.y, g.xy}, univariate{g.yy}};
}

// True if the highest power of Y has a constant coefficient that is not zero. Then the curve has no
// vertical line, and at each X as many complex points, with multiplicity, as its degree.
bool is_upright(const conic& g) {
  const bool straight = sign_of(g.xx) == 0 && sign_of(g.xy) == 0 && sign_of(g.yy) == 0;
  return straight ? sign_of(g.y) != 0 : sign_of(g.yy) != 0;
}

// Returns polynomials whose zeros contain the abscissas at which `other` changes sign along the
// curve. Usually that is one, the resultant. If it vanishes, the curves have a common component.
// `other` is zero there, and equals beta Y + gamma along the curve. It then changes sign only where
// the remaining component meets beta = 0, or at the curve's double points, which are critical in
// any case.
std::vector<univariate> abscissas_of_zeros(const conic& curve, const conic& other) {
  const auto [c0, c1, c2] = by_powers_of_y(curve);
  const auto [k0, k1, k2] = by_powers_of_y(other);
  univariate resultant, beta, gamma;
  if (sign_of(curve.yy) == 0) {
    resultant = k2 * c0 * c0 - k1 * c0 * c1 + k0 * c1 * c1;
  } else {
    const univariate ratio = {other.yy / curve.yy};
    beta = k1 - ratio * c1;
    gamma = k0 - ratio * c0;
    resultant = c2 * gamma * gamma - c1 * beta * gamma + c0 * beta * beta;
  }
  if (!is_zero(resultant)) return {resultant};
  std::vector<univariate> cuts;
  for (const univariate& p : {beta, gamma})
    if (!is_zero(p)) cuts.push_back(p);
  return cuts;
}

univariate discriminant(const conic& curve) {
  const auto [c0, c1, c2] = by_powers_of_y(curve);
  return c1 * c1 - univariate{rational(4)} * c2 * c0;
}

struct critical_curve {
  conic curve;
  critical_kind kind;
};

// Adds curves whose common points with Vor{v,w} have the abscissas at which the number of curve
// points on the segments to or from x may change, or x meets the border of the triangle v, w, p.
void add_critical_curves_of(const exact_site& v, const exact_site& w, const exact_site& x,
                            critical_kind equidistant, std::vector<critical_curve>& curves) {
  for (const exact_site* owner : {&v, &w}) {
    const conic g = bisector(*owner, x);
    curves.push_back({g, equidistant});
    curves.push_back({tangent_pair(g, owner->position), tangency});
    curves.push_back({tangent_pair(g, x.position), tangency});
    curves.push_back({line_through(owner->position, x.position), line_event});
  }
}

struct cut {
  algebraic_number abscissa;
  unsigned kinds;
};

std::vector<cut> sorted_cuts(const conic& curve, const std::vector<critical_curve>& criticals) {
  std::vector<cut> cuts;
  const auto add_zeros = [&cuts](const univariate& p, unsigned kind) {
    for (const algebraic_number& root : distinct_real_roots(p)) cuts.push_back({root, kind});
  };
  for (const critical_curve& critical : criticals)
    for (const univariate& p : abscissas_of_zeros(curve, critical.curve))
      add_zeros(p, critical.kind);
  // Adds the abscissas of vertical tangents and double points. A double line has one branch.
  if (sign_of(curve.yy) != 0)
    if (const univariate d = discriminant(curve); !is_zero(d)) add_zeros(d, tangency);
  std::stable_sort(cuts.begin(), cuts.end(),
                   [](const cut& a, const cut& b) { return a.abscissa < b.abscissa; });
  std::vector<cut> distinct;
  for (const cut& c : cuts) {
    if (!distinct.empty() && distinct.back().abscissa == c.abscissa)
      distinct.back().kinds |= c.kinds;
    else
      distinct.push_back(c);
  }
  return distinct;
}

// Returns the points of the curve at an abscissa, by ordinate; empty if there are none.
std::vector<sample_point> points_at(const conic& curve, const rational& abscissa) {
  const auto coefficients = by_powers_of_y(curve);
  const rational c0 = evaluate(coefficients[0], abscissa), c1 = evaluate(coefficients[1], abscissa);
  const rational c2 = curve.yy;
  if (sign_of(c2) == 0) return {{root_number(abscissa), root_number(-c0 / c1)}};
  const rational middle = -c1 / (rational(2) * c2), radicand = middle * middle - c0 / c2;
  if (sign_of(radicand) < 0) return {};
  if (sign_of(radicand) == 0) return {{root_number(abscissa), root_number(middle)}};
  return {{root_number(abscissa), root_number(middle, rational(-1), radicand)},
          {root_number(abscissa), root_number(middle, rational(1), radicand)}};
}

int sign_of(const root_number& value) { return static_cast<int>(CGAL::sign(value)); }

// Returns the number of curve points on the segment from the site to p. The site is not on the
// curve.
int points_on_segment(const conic& g, const exact_site& from, const sample_point& p) {
  const rational &px = from.position.x, &py = from.position.y;
  const rational two(2);
  const root_number ux = p.x - root_number(px), uy = p.y - root_number(py);
  const root_number slope_x(two * g.xx * px + g.xy * py + g.x);
  const root_number slope_y(g.xy * px + two * g.yy * py + g.y);
  return roots_in_closed_unit_interval(
      root_number(g.at(from.position)), slope_x * ux + slope_y * uy,
      ux * (root_number(g.xx) * ux + root_number(g.xy) * uy) + root_number(g.yy) * uy * uy);
}

int turn(const sample_point& p, const sample_point& q, const sample_point& r) {
  return sign_of((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
}

sample_point at_site(const exact_site& s) {
  return {root_number(s.position.x), root_number(s.position.y)};
}

// Requires a, b, c not collinear.
bool in_closed_triangle(const sample_point& q, const sample_point& a, const sample_point& b,
                        const sample_point& c) {
  const int side = turn(a, b, c);
  return turn(a, b, q) * side >= 0 && turn(b, c, q) * side >= 0 && turn(c, a, q) * side >= 0;
}

// Evaluates the definition of the insertion test at one point of Vor{v,w}.
class definition {
 public:
  definition(const exact_site& v, const exact_site& w, const exact_site& x, const exact_site& y)
      : v_(v), w_(w), x_(x), y_(y), between_(bisector(v, w)) {}

  bool holds_at(const sample_point& p) const {
    return points_on_segment(between_, v_, p) == 1 && points_on_segment(between_, w_, p) == 1 &&
           !in_closed_triangle(at_site(x_), at_site(v_), at_site(w_), p) &&
           !in_closed_triangle(at_site(y_), at_site(v_), at_site(w_), p) && dominates(v_, x_, p) &&
           dominates(w_, x_, p) && dominates(v_, y_, p) && dominates(w_, y_, p);
  }

 private:
  static bool dominates(const exact_site& s, const exact_site& over, const sample_point& p) {
    const conic g = bisector(s, over);
    return points_on_segment(g, s, p) < points_on_segment(g, over, p);
  }

  const exact_site &v_, &w_, &x_, &y_;
  conic between_;
};

// Returns a slope with which Vor{v,w} is upright. Of any three distinct slopes at most two are not.
std::array<exact_site, 4> brought_upright(const std::array<const exact_site*, 4>& sites) {
  std::array<exact_site, 4> moved;
  for (const rational& slope : {rational(3, 7), rational(-5, 11), rational(13, 17)}) {
    for (std::size_t i = 0; i < 4; ++i) moved[i] = sheared(*sites[i], slope);
    if (is_upright(bisector(moved[0], moved[1]))) break;
  }
  return moved;
}

void look_for_ties(const conic& curve, const conic& with_x, const conic& with_y,
                   const std::vector<cut>& cuts, swept_arc& answer) {
  const auto in_x = abscissas_of_zeros(curve, with_x), in_y = abscissas_of_zeros(curve, with_y);
  const bool isolated = in_x.size() == 1 && in_y.size() == 1;
  answer.may_have_point_equidistant_from_four =
      !isolated || !are_coprime(in_x.front(), in_y.front());
  answer.tie_may_be_beyond_first_order =
      !isolated || !is_square_free(in_x.front()) || !is_square_free(in_y.front()) ||
      std::any_of(cuts.begin(), cuts.end(), [](const cut& c) {
        constexpr unsigned all = equidistant_from_x | equidistant_from_y | tangency;
        return (c.kinds & all) == all;
      });
}

std::vector<good_run> runs_of_branch(const std::vector<bool>& good, const std::vector<cut>& cuts) {
  std::vector<good_run> runs;
  for (std::size_t i = 0; i < good.size(); ++i) {
    if (!good[i]) continue;
    good_run run;
    run.kinds_at_low_end = i > 0 ? cuts[i - 1].kinds : 0;
    while (i + 1 < good.size() && good[i + 1]) ++i;
    run.kinds_at_high_end = i < cuts.size() ? cuts[i].kinds : 0;
    runs.push_back(run);
  }
  return runs;
}

}  // namespace

swept_arc sweep(const exact_site& v, const exact_site& w, const exact_site& x,
                const exact_site& y) {
  const auto [sv, sw, sx, sy] = brought_upright({&v, &w, &x, &y});
  const conic curve = bisector(sv, sw);
  // Visibility changes at points of tangency, in which the curve meets its polars.
  std::vector<critical_curve> criticals = {{polar_line(curve, sv.position), tangency},
                                           {polar_line(curve, sw.position), tangency},
                                           {line_through(sv.position, sw.position), line_event}};
  add_critical_curves_of(sv, sw, sx, equidistant_from_x, criticals);
  add_critical_curves_of(sv, sw, sy, equidistant_from_y, criticals);
  const std::vector<cut> cuts = sorted_cuts(curve, criticals);

  std::vector<algebraic_number> abscissas;
  abscissas.reserve(cuts.size());
  for (const cut& c : cuts) abscissas.push_back(c.abscissa);
  const definition insertion(sv, sw, sx, sy);
  std::array<std::vector<bool>, 2> good;
  for (const rational& abscissa : samples_between(abscissas)) {
    const std::vector<sample_point> points = points_at(curve, abscissa);
    for (std::size_t branch = 0; branch < 2; ++branch)
      good[branch].push_back(branch < points.size() && insertion.holds_at(points[branch]));
  }
  swept_arc answer;
  for (const std::vector<bool>& branch : good)
    for (const good_run& run : runs_of_branch(branch, cuts)) answer.good_runs.push_back(run);
  look_for_ties(curve, bisector(sv, sx), bisector(sv, sy), cuts, answer);
  return answer;
}

}  // namespace asterism::oracle
