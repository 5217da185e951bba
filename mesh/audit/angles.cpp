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
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/audit/context.hpp"
#include "asterism/mesh/support/sort_unique.hpp"
#include "asterism/mesh/support/wide_range.hpp"

namespace asterism::internal::audit_detail {
namespace {

// cot(degrees)^2 between two rationals, equal where the value is rational: for a bound that is a
// rational number of degrees (every double is) that happens at 30, 45 and 60 only.
struct squared_cotangent {
  rational low, high;
  bounded filter;         // encloses both
  double root_below = 0;  // at most the root of `low`
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
  c.root_below = root(c.filter).lower();
  return c;
}

struct corner {
  vertex_index at = 0, ahead = 0, behind = 0;  // counter-clockwise from `ahead` to `behind`
};

template <class Number>
struct corner_terms {
  Number left;   // a^T M b
  Number right;  // det M (a x b)^2
};

template <class Number>
corner_terms<Number> terms(const audit_context& context, const corner& c,
                           vertex_index perspective) {
  const auto a = difference<Number>(context.at(c.ahead), context.at(c.at));
  const auto b = difference<Number>(context.at(c.behind), context.at(c.at));
  const auto m = tensor_of<Number>(context.subject.sites[perspective].metric);
  const Number area = cross(a, b);
  return {dot(a, m * b), m.determinant() * area * area};
}

// Is the angle proven to be at least the bound? Requires a x b > 0.
bool wide_enough(const audit_context& context, audit_tally& tally, const corner& c,
                 vertex_index perspective, const squared_cotangent& bound) {
  ++tally.part.decisions;
  const auto quick = terms<bounded>(context, c, perspective);
  if (quick.left.certainly_negative()) return true;
  const bounded spare = bound.filter * quick.right - quick.left * quick.left;
  if (spare.certainly_positive()) return true;
  if (spare.certainly_negative() && quick.left.certainly_positive()) return false;
  ++tally.part.exact_decisions;
  const auto exact = terms<rational>(context, c, perspective);
  return exact.left <= 0 || exact.left * exact.left <= bound.low * exact.right;
}

// Is the angle proven to be below the bound? Requires a x b > 0.
bool proven_narrow(const audit_context& context, audit_tally& tally, const corner& c,
                   vertex_index perspective, const squared_cotangent& bound) {
  ++tally.part.decisions;
  ++tally.part.exact_decisions;
  const auto exact = terms<rational>(context, c, perspective);
  return exact.left > 0 && exact.left * exact.left > bound.high * exact.right;
}

// Degrees, for information.
double angle_in_degrees(const audit_context& context, const corner& c, vertex_index perspective) {
  const auto a = difference<wide_range>(context.at(c.ahead), context.at(c.at));
  const auto b = difference<wide_range>(context.at(c.behind), context.at(c.at));
  const auto m = tensor_of<wide_range>(context.subject.sites[perspective].metric);
  const wide_range height = root(m.determinant()) * cross(a, b);
  const auto [up, along] = scaled(height, dot(a, m * b));
  return elementary::atan2(up, along) * 180 / std::numbers::pi;
}

// A sector of the domain at a corner, proven to be narrower than the bound.
struct narrow_sector {
  vertex_index at = 0, first = 0, last = 0;
};

// A sector narrower than half the bound, with a segment inside the domain beside it, followed to
// the given vertices at the far ends of its two segments. The points in between are in
// wedge_points.
struct narrow_wedge {
  vertex_index at = 0, first_end = 0, last_end = 0;
};

// That a vertex other than the corner is on a segment of a wedge.
struct wedge_point {
  vertex_index vertex = 0;
  std::size_t wedge = 0;
  bool last = false;  // on which of the two segments

  friend bool operator<(const wedge_point& l, const wedge_point& r) {
    return std::tie(l.vertex, l.wedge, l.last) < std::tie(r.vertex, r.wedge, r.last);
  }
};

struct narrow_wedges {
  std::vector<narrow_wedge> list;
  std::vector<wedge_point> points;  // sorted
};

struct directed_edges {
  std::vector<directed_subsegment> list;  // sorted by a
  std::vector<std::size_t> start;         // as audit_context::side_start
};

directed_edges reversed_sides(const audit_context& context) {
  directed_edges reversed;
  for (const directed_subsegment& side : context.sides)
    reversed.list.push_back({side.b, side.a, side.subsegment});
  std::sort(reversed.list.begin(), reversed.list.end(), [](const auto& l, const auto& r) {
    return std::array{l.a, l.subsegment, l.b} < std::array{r.a, r.subsegment, r.b};
  });
  reversed.start = starts_of(reversed.list, context.subject.sites.size());
  return reversed;
}

// The sectors at v between a subsegment that leaves it and the next one, counter-clockwise, that
// reaches it, where that is less than a half turn.
// `arriving` are the boundary edges as sides reversed, those that reach v leaving it.
std::vector<corner> sectors_at(const audit_context& context, const directed_edges& arriving,
                               vertex_index v) {
  std::vector<vertex_index> out, in;
  for (std::size_t i = context.side_start[v]; i < context.side_start[v + 1]; ++i)
    out.push_back(context.sides[i].b);
  for (std::size_t i = arriving.start[v]; i < arriving.start[v + 1]; ++i)
    in.push_back(arriving.list[i].b);
  std::vector<corner> sectors;
  for (const vertex_index n : out)
    for (const vertex_index p : in) {
      const auto between = [&](vertex_index q) {
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
std::vector<narrow_sector> narrow_sectors(audit_context& context, const directed_edges& arriving,
                                          vertex_index v, const squared_cotangent& bound) {
  std::vector<narrow_sector> narrow;
  audit_tally tally;
  for (const corner& c : sectors_at(context, arriving, v))
    if (proven_narrow(context, tally, c, c.at, bound)) narrow.push_back({v, c.ahead, c.behind});
  context.take(std::move(tally));
  return narrow;
}

std::vector<vertex_index> corners_to_prove(const audit_context& context) {
  std::vector<vertex_index> corners = context.options.exempt_corners;
  if (context.options.find_exempt_corners)
    for (const directed_subsegment& side : context.sides)
      // Only an input vertex is a corner; elsewhere the boundary is straight but for rounding.
      if (side.a < context.subject.given) corners.push_back(side.a);
  sort_unique(corners);
  return corners;
}

std::vector<narrow_sector> exempt_sectors(audit_context& context, const squared_cotangent& bound) {
  std::vector<vertex_index> claimed = context.options.exempt_corners;
  std::sort(claimed.begin(), claimed.end());
  const directed_edges arriving = reversed_sides(context);
  std::vector<narrow_sector> all;
  for (const vertex_index v : corners_to_prove(context)) {
    std::vector<narrow_sector> narrow;
    if (v < context.measured.size() && context.measured[v])
      narrow = narrow_sectors(context, arriving, v, bound);
    if (!narrow.empty())
      context.report.exempt_corners.push_back(v);
    else if (std::binary_search(claimed.begin(), claimed.end(), v))
      context.found(finding_kind::exemption_not_proven,
                    "the domain's angle at " + vertex_text(context, v) +
                        ", in its own metric, is not below the bound");
    all.insert(all.end(), narrow.begin(), narrow.end());
  }
  return all;
}

// The segment that leaves `corner` for `next`, from subsegment to subsegment as far as the next
// given vertex; `edges` are the sides that leave a vertex, or those that reach it, reversed. Empty
// if it does not get there: more or fewer than one way on is a fault of another check.
std::vector<vertex_index> follow(const audit_context& context,
                                 const std::vector<directed_subsegment>& edges,
                                 const std::vector<std::size_t>& start, vertex_index corner,
                                 vertex_index next) {
  std::vector<vertex_index> chain = {next};
  for (vertex_index from = corner; chain.back() >= context.subject.given;) {
    const vertex_index at = chain.back();
    std::vector<vertex_index> onward;
    for (std::size_t i = start[at]; i < start[at + 1]; ++i)
      if (edges[i].b != from) onward.push_back(edges[i].b);
    if (onward.size() != 1 || chain.size() > edges.size()) return {};
    from = at;
    chain.push_back(onward.front());
  }
  return chain;
}

bool is_internal(const audit_context& context, vertex_index a, vertex_index b) {
  const std::size_t subsegment = find_subsegment(context, a, b);
  return subsegment < context.subject.boundary.size() &&
         context.subject.boundary[subsegment].internal;
}

narrow_wedges wedges_of(audit_context& context, const std::vector<narrow_sector>& sectors,
                        const squared_cotangent& half) {
  narrow_wedges wedges;
  audit_tally tally;
  const directed_edges arriving = reversed_sides(context);
  for (const narrow_sector& s : sectors) {
    if (!is_internal(context, s.at, s.first) && !is_internal(context, s.last, s.at)) continue;
    const auto first = follow(context, context.sides, context.side_start, s.at, s.first);
    const auto last = follow(context, arriving.list, arriving.start, s.at, s.last);
    if (first.empty() || last.empty()) continue;
    const corner whole{s.at, first.back(), last.back()};
    if (context.orientation(whole.at, whole.ahead, whole.behind) != sign::positive) continue;
    if (!proven_narrow(context, tally, whole, s.at, half)) continue;
    for (const vertex_index v : first) wedges.points.push_back({v, wedges.list.size(), false});
    for (const vertex_index v : last) wedges.points.push_back({v, wedges.list.size(), true});
    wedges.list.push_back({s.at, first.back(), last.back()});
  }
  context.take(std::move(tally));
  std::sort(wedges.points.begin(), wedges.points.end());
  return wedges;
}

bool lies_in(const audit_context& context, const filtered_kernel& kernel, const triangle& t,
             const narrow_sector& s) {
  const point &at = context.at(s.at), &first = context.at(s.first), &last = context.at(s.last);
  return std::all_of(t.begin(), t.end(), [&](vertex_index q) {
    return q == s.at || (kernel.orientation(at, first, context.at(q)) != sign::negative &&
                         kernel.orientation(at, context.at(q), last) != sign::negative);
  });
}

// Has the triangle a corner at one of the sectors, sorted by corner, and lies it in it?
bool exempt(const audit_context& context, const filtered_kernel& kernel, const triangle& t,
            const std::vector<narrow_sector>& sectors) {
  return std::any_of(t.begin(), t.end(), [&](vertex_index v) {
    auto s = std::lower_bound(sectors.begin(), sectors.end(), v,
                              [](const narrow_sector& n, vertex_index key) { return n.at < key; });
    while (s != sectors.end() && s->at == v && !lies_in(context, kernel, t, *s)) ++s;
    return s != sectors.end() && s->at == v;
  });
}

// A triangle in plain doubles, as one metric sees it. Each edge component is off by at most eps =
// 2^-52 of itself, whichever way the machine rounds, and no monomial of the terms below meets more
// than four roundings besides those of its two components: 8 eps of the magnitude bound them, and
// the few roundings of the bound itself. Within `in_range` what underflow takes is below 2^-600.
struct plain_triangle {
  plain_triangle(const audit_context& context, const triangle& t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const point &from = context.at(t[i]), &to = context.at(t[(i + 1) % 3]);
      edge[i] = {to.x - from.x, to.y - from.y};
      extent = std::fmax(extent, std::abs(edge[i].x) + std::abs(edge[i].y));
    }
    const double left = edge[0].x * edge[1].y, right = edge[0].y * edge[1].x;
    area_below = left - right - step * (std::abs(left) + std::abs(right)) - lost;
  }

  static constexpr double step = 0x1p-49, lost = 0x1p-600;
  std::array<vector2<double>, 3> edge;  // from corner i to the next
  double extent = 0;
  double area_below = 0;
};

// Of each corner an upper bound of the cotangent of its angle; infinite where not known.
std::array<double, 3> cotangents_above(const plain_triangle& t, const metric_tensor& m) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> above = {infinity, infinity, infinity};
  const double product = m.m11 * m.m22, square = m.m12 * m.m12;
  const double determinant_below =
      product - square - plain_triangle::step * (product + square) - plain_triangle::lost;
  const bool in_range = t.extent < 0x1p200 && m.m11 + m.m22 < 0x1p400;
  if (!(in_range && determinant_below > 0 && t.area_below > 0)) return above;
  const double height = std::sqrt(determinant_below) * t.area_below;
  if (!(height > 0x1p-700)) return above;
  const double inverse = 1 / height;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &a = t.edge[i], &c = t.edge[(i + 2) % 3];
    const double xx = a.x * c.x, xy = a.x * c.y + a.y * c.x, yy = a.y * c.y;
    const double size = m.m11 * std::abs(xx) +
                        std::abs(m.m12) * (std::abs(a.x * c.y) + std::abs(a.y * c.x)) +
                        m.m22 * std::abs(yy);
    const double left = -(m.m11 * xx + m.m12 * xy + m.m22 * yy);
    above[i] = (left + plain_triangle::step * size + plain_triangle::lost) * inverse;
    above[i] += std::abs(above[i]) * plain_triangle::step;
  }
  return above;
}

// What the triangles are held against; the same for all.
struct audited_requirement {
  double degrees = 0;
  squared_cotangent bound;
  std::vector<narrow_sector> sectors;
  narrow_wedges wedges;
};

// Are all its corners on the two segments of one wedge, some on each, and is that proven to be
// narrower than the bound as all three of them measure it?
bool crosses_narrow_wedge(const audit_context& context, audit_tally& tally, const triangle& t,
                          const audited_requirement& wanted) {
  const auto& points = wanted.wedges.points;
  const auto is_on = [&](vertex_index v, std::size_t wedge, bool last) {
    return std::binary_search(points.begin(), points.end(), wedge_point{v, wedge, last});
  };
  const vertex_index one = *std::max_element(t.begin(), t.end());
  for (auto p = std::lower_bound(points.begin(), points.end(), wedge_point{one, 0, false});
       p != points.end() && p->vertex == one; ++p) {
    const narrow_wedge& w = wanted.wedges.list[p->wedge];
    const bool across = std::any_of(t.begin(), t.end(),
                                    [&](vertex_index v) { return is_on(v, p->wedge, !p->last); });
    const bool within = std::all_of(t.begin(), t.end(), [&](vertex_index v) {
      return v == w.at || is_on(v, p->wedge, false) || is_on(v, p->wedge, true);
    });
    if (across && within && std::all_of(t.begin(), t.end(), [&](vertex_index v) {
          return proven_narrow(context, tally, {w.at, w.first_end, w.last_end}, v, wanted.bound);
        }))
      return true;
  }
  return false;
}

class angle_check {
 public:
  angle_check(const audit_context& context, audit_tally& tally, const audited_requirement& wanted)
      : context_(context), tally_(tally), wanted_(wanted) {}

  void run(vertex_index t) {
    const triangle& c = context_.subject.triangles[t];
    if (!std::all_of(c.begin(), c.end(), [&](vertex_index v) { return context_.measured[v] != 0; }))
      return;
    if (tally_.kernel().orientation(context_.at(c[0]), context_.at(c[1]), context_.at(c[2])) !=
        sign::positive)
      return;
    const bool may_fail = exempt(context_, tally_.kernel(), c, wanted_.sectors) ||
                          crosses_narrow_wedge(context_, tally_, c, wanted_);
    const plain_triangle plain(context_, c);
    bool failed = false;
    for (const vertex_index perspective : c) {
      const auto above = cotangents_above(plain, context_.subject.sites[perspective].metric);
      for (std::size_t i = 0; i < 3; ++i) {
        const corner at{c[i], c[(i + 1) % 3], c[(i + 2) % 3]};
        note_angle(t, at, perspective, may_fail, above[i]);
        failed |= !is_wide(t, at, perspective, may_fail, above[i]);
      }
    }
    if (failed) (may_fail ? tally_.part.exempt_triangles : tally_.part.low_triangles).push_back(t);
  }

 private:
  // Only what may be the least angle so far is measured.
  void note_angle(vertex_index t, const corner& c, vertex_index perspective, bool may_fail,
                  double above) {
    double& greatest = greatest_cotangent_[may_fail ? 1 : 0];
    if (above < greatest) return;
    audited_angle& least = may_fail ? tally_.part.worst_exempt : tally_.part.worst;
    const double angle = angle_in_degrees(context_, c, perspective);
    if (!(angle < least.degrees)) return;
    least = {angle, t, c.at, perspective};
    const double cotangent = 1 / elementary::tan(angle * std::numbers::pi / 180);
    greatest = cotangent - 1e-9 * (1 + std::abs(cotangent));
  }

  bool is_wide(vertex_index t, const corner& c, vertex_index perspective, bool may_fail,
               double above) {
    if (wanted_.degrees <= 0) return true;
    if (above < wanted_.bound.root_below) {
      ++tally_.part.decisions;
      return true;
    }
    if (wide_enough(context_, tally_, c, perspective, wanted_.bound)) return true;
    if (!may_fail)
      tally_.found(finding_kind::angle_below_bound,
                   "the angle at " + vertex_text(context_, c.at) + " of " +
                       triangle_text(context_, t) + " is " +
                       number_text(angle_in_degrees(context_, c, perspective)) +
                       " degrees in the metric of " + vertex_text(context_, perspective) +
                       ", below " + number_text(wanted_.degrees));
    return false;
  }

  const audit_context& context_;
  audit_tally& tally_;
  const audited_requirement& wanted_;
  // Of the least angle so far, rather too small; of triangles away from exempt corners, and others.
  std::array<double, 2> greatest_cotangent_ = {-std::numeric_limits<double>::infinity(),
                                               -std::numeric_limits<double>::infinity()};
};

}  // namespace

void check_angles(audit_context& context) {
  audited_requirement wanted;
  wanted.degrees = context.options.angle_bound.value_or(0);
  if (!(wanted.degrees >= 0 && wanted.degrees < 90)) {
    context.found(finding_kind::invalid_option, "an angle bound of " + number_text(wanted.degrees) +
                                                    " degrees is not in [0, 90)");
    return;
  }
  context.report.angles_checked = context.options.angle_bound.has_value();
  if (wanted.degrees > 0) {  // else trivially met
    wanted.bound = make_squared_cotangent(wanted.degrees);
    wanted.sectors = exempt_sectors(context, wanted.bound);
    wanted.wedges = wedges_of(context, wanted.sectors, make_squared_cotangent(wanted.degrees / 2));
  }
  const auto check = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    angle_check part(context, tally, wanted);
    for (std::size_t i = begin; i < end; ++i) part.run(context.triangles[i]);
  };
  check_in_parallel(context, context.triangles.size(), check);
}

}  // namespace asterism::internal::audit_detail
