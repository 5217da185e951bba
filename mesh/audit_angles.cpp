// SPDX-License-Identifier: MIT
//
// Point 3: no angle below the bound, seen from any of the triangle's three vertices.
//
// With edge vectors a, b from a corner, a x b > 0, the angle in the metric M is at least theta
// exactly when a^T M b <= cot(theta) sqrt(det M) (a x b). All but cot(theta) is rational; where the
// left side is positive, squares are compared against a rational C <= cot(theta)^2 (docs/math/
// certificate.md, section 3): a pass proves the bound. The set of M that pass is a convex cone.
#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "asterism/mesh/audit_context.hpp"

namespace asterism::audit_detail {
namespace {

// cot(degrees)^2 between two rationals, equal where the value is rational: for a bound that is a
// rational number of degrees (every double is) that happens at 30, 45 and 60 only.
struct squared_cotangent {
  rational low, high;
  bounded filter;  // encloses both
};

// Below 2^-190 relative: 256 bits, four roundings.
rational squared_cotangent_rounded(double degrees, mpfr_rnd_t away, mpfr_rnd_t towards) {
  mpfr_t angle, pi;
  mpfr_init2(angle, 256);
  mpfr_init2(pi, 256);
  mpfr_const_pi(pi, away);
  mpfr_mul_d(angle, pi, degrees, away);
  mpfr_div_ui(angle, angle, 180, away);
  mpfr_tan(angle, angle, away);
  mpfr_sqr(angle, angle, away);
  mpfr_ui_div(angle, 1, angle, towards);
  rational result;
  mpfr_get_q(result.backend().data(), angle);
  mpfr_clear(pi);
  mpfr_clear(angle);
  return result;
}

squared_cotangent make_squared_cotangent(double degrees) {
  squared_cotangent c;
  if (degrees == 30)
    c.low = c.high = 3;
  else if (degrees == 45)
    c.low = c.high = 1;
  else if (degrees == 60)
    c.low = c.high = rational(1) / 3;
  else {
    c.low = squared_cotangent_rounded(degrees, MPFR_RNDU, MPFR_RNDD);
    c.high = squared_cotangent_rounded(degrees, MPFR_RNDD, MPFR_RNDU);
  }
  const double value = c.low.convert_to<double>();
  c.filter = bounded::within(value, value * 0x1p-50);
  return c;
}

struct corner {
  index at = 0, ahead = 0, behind = 0;  // counter-clockwise from `ahead` to `behind`
};

template <class Number>
struct corner_terms {
  Number left;   // a^T M b
  Number right;  // det M (a x b)^2
};

template <class Number>
corner_terms<Number> terms(const audit_context& context, const corner& c, index perspective) {
  const auto a = difference<Number>(context.at(c.ahead), context.at(c.at));
  const auto b = difference<Number>(context.at(c.behind), context.at(c.at));
  const auto m = tensor_of<Number>(context.subject.sites[perspective].metric);
  const Number area = cross(a, b);
  return {dot(a, m * b), m.determinant() * area * area};
}

// Is the angle proven to be at least the bound? Requires a x b > 0.
bool wide_enough(audit_context& context, const corner& c, index perspective,
                 const squared_cotangent& bound) {
  ++context.report.decisions;
  const auto quick = terms<bounded>(context, c, perspective);
  if (quick.left.certainly_negative()) return true;
  const bounded spare = bound.filter * quick.right - quick.left * quick.left;
  if (spare.certainly_positive()) return true;
  if (spare.certainly_negative() && quick.left.certainly_positive()) return false;
  ++context.report.exact_decisions;
  const auto exact = terms<rational>(context, c, perspective);
  return exact.left <= 0 || exact.left * exact.left <= bound.low * exact.right;
}

// Is the angle proven to be below the bound? Requires a x b > 0.
bool proven_narrow(audit_context& context, const corner& c, const squared_cotangent& bound) {
  ++context.report.decisions;
  ++context.report.exact_decisions;
  const auto exact = terms<rational>(context, c, c.at);
  return exact.left > 0 && exact.left * exact.left > bound.high * exact.right;
}

// Degrees, for information: long double, whose range holds products of four doubles.
double angle_in_degrees(const audit_context& context, const corner& c, index perspective) {
  const auto a = difference<long double>(context.at(c.ahead), context.at(c.at));
  const auto b = difference<long double>(context.at(c.behind), context.at(c.at));
  const auto m = tensor_of<long double>(context.subject.sites[perspective].metric);
  const long double height = std::sqrt(std::fmax(0.0L, m.determinant())) * cross(a, b);
  return static_cast<double>(std::atan2(height, dot(a, m * b)) * 180 /
                             std::numbers::pi_v<long double>);
}

// A sector of the domain at a corner, proven to be narrower than the bound.
struct narrow_sector {
  index at = 0, first = 0, last = 0;
};

// The sectors at v between a piece that leaves it and the next one, counter-clockwise, that
// reaches it, where that is less than a half turn.
std::vector<corner> sectors_at(const audit_context& context, index v) {
  std::vector<index> out, in;
  for (const directed_piece& side : context.sides) {
    if (side.a == v) out.push_back(side.b);
    if (side.b == v) in.push_back(side.a);
  }
  std::vector<corner> sectors;
  for (const index n : out)
    for (const index p : in) {
      const auto between = [&](index q) {
        return q != n && q != p && context.orientation(v, n, q) == sign::positive &&
               context.orientation(v, q, p) == sign::positive;
      };
      if (context.orientation(v, n, p) == sign::positive &&
          std::none_of(out.begin(), out.end(), between) &&
          std::none_of(in.begin(), in.end(), between))
        sectors.push_back({v, n, p});
    }
  return sectors;
}

// The narrow sectors of `v`, none if the exemption of v cannot be proven.
std::vector<narrow_sector> narrow_sectors(audit_context& context, index v,
                                          const squared_cotangent& bound) {
  std::vector<narrow_sector> narrow;
  for (const corner& c : sectors_at(context, v))
    if (proven_narrow(context, c, bound)) narrow.push_back({v, c.ahead, c.behind});
  return narrow;
}

std::vector<index> corners_to_prove(const audit_context& context) {
  std::vector<index> corners = context.options.exempt_corners;
  if (context.options.find_exempt_corners)
    for (const directed_piece& side : context.sides)
      // Only an input vertex is a corner; elsewhere the boundary is straight but for rounding.
      if (side.a < context.subject.given) corners.push_back(side.a);
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

std::vector<narrow_sector> exempt_sectors(audit_context& context, const squared_cotangent& bound) {
  const auto& claimed = context.options.exempt_corners;
  std::vector<narrow_sector> all;
  for (const index v : corners_to_prove(context)) {
    std::vector<narrow_sector> narrow;
    if (v < context.measured.size() && context.measured[v])
      narrow = narrow_sectors(context, v, bound);
    if (!narrow.empty())
      context.report.exempt_corners.push_back(v);
    else if (std::find(claimed.begin(), claimed.end(), v) != claimed.end())
      context.found(finding_kind::exemption_not_proven,
                    "the domain's angle at " + vertex_text(context, v) +
                        ", in its own metric, is not below the bound");
    all.insert(all.end(), narrow.begin(), narrow.end());
  }
  return all;
}

// Has the triangle a corner at one of the sectors, and lies it in it?
bool exempt(const audit_context& context, const triangle& t,
            const std::vector<narrow_sector>& sectors) {
  return std::any_of(sectors.begin(), sectors.end(), [&](const narrow_sector& s) {
    if (std::find(t.begin(), t.end(), s.at) == t.end()) return false;
    return std::all_of(t.begin(), t.end(), [&](index q) {
      return q == s.at || (context.orientation(s.at, s.first, q) != sign::negative &&
                           context.orientation(s.at, q, s.last) != sign::negative);
    });
  });
}

class angle_check {
 public:
  angle_check(audit_context& context, double degrees) : context_(context), degrees_(degrees) {
    if (degrees <= 0) return;  // trivially met
    bound_ = make_squared_cotangent(degrees);
    sectors_ = exempt_sectors(context, bound_);
  }

  void run(index t) {
    const triangle& c = context_.subject.triangles[t];
    if (!std::all_of(c.begin(), c.end(), [&](index v) { return context_.measured[v] != 0; }))
      return;
    if (context_.orientation(c[0], c[1], c[2]) != sign::positive) return;
    const bool may_fail = exempt(context_, c, sectors_);
    bool failed = false;
    for (std::size_t i = 0; i < 3; ++i)
      for (const index perspective : c)
        failed |= !examine(t, {c[i], c[(i + 1) % 3], c[(i + 2) % 3]}, perspective, may_fail);
    if (failed && may_fail) context_.report.exempt_triangles.push_back(t);
  }

 private:
  bool examine(index t, const corner& c, index perspective, bool may_fail) {
    const double angle = angle_in_degrees(context_, c, perspective);
    audited_angle& least = may_fail ? context_.report.worst_exempt : context_.report.worst;
    if (angle < least.degrees) least = {angle, t, c.at, perspective};
    if (degrees_ <= 0 || wide_enough(context_, c, perspective, bound_)) return true;
    if (!may_fail)
      context_.found(finding_kind::angle_below_bound,
                     "the angle at " + vertex_text(context_, c.at) + " of " +
                         triangle_text(context_, t) + " is " + number_text(angle) +
                         " degrees in the metric of " + vertex_text(context_, perspective) +
                         ", below " + number_text(degrees_));
    return false;
  }

  audit_context& context_;
  double degrees_;
  squared_cotangent bound_;
  std::vector<narrow_sector> sectors_;
};

}  // namespace

void check_angles(audit_context& context) {
  const double degrees = context.options.angle_bound.value_or(0);
  if (!(degrees >= 0 && degrees < 90)) {
    context.found(finding_kind::invalid_option,
                  "an angle bound of " + number_text(degrees) + " degrees is not in [0, 90)");
    return;
  }
  context.report.angles_checked = context.options.angle_bound.has_value();
  angle_check check(context, degrees);
  for (const index t : context.triangles) check.run(t);
}

}  // namespace asterism::audit_detail
