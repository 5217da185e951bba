// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/curves.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "asterism/mesh/audit/roots.hpp"

namespace asterism::internal::audit_detail {
namespace {

using rational_point = vector2<rational>;

// Largest distance of a computed point from its curve, in units in the last place of the largest
// number it is computed from. A point of an arc is computed as centre plus radius times a cosine,
// with an error below four units; a point of a cubic by three rounds of means, with an error below
// five units, and its parameter with an error of three.
constexpr double units_off = 16;
// Largest distance of an arc's last vertex from its circle, as a part of the radius: domains are
// accepted up to that distance (domain/divide_curves.hpp).
constexpr double digits_off = 1e-6;

rational_point exact(const point& p) { return {rational(p.x), rational(p.y)}; }
rational_point minus(const rational_point& a, const rational_point& b) {
  return {a.x - b.x, a.y - b.y};
}
rational squared(const rational_point& a) { return dot(a, a); }
const rational& greatest(const rational& a, const rational& b) { return a < b ? b : a; }

point blend(const point& a, const point& b, double t) {
  return {(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y};
}

// Returns the scalar product of the displacement from q to the cubic's point at t with the
// derivative there, in doubles: negative before the nearest point.
double progress(const std::array<point, 4>& p, const point& q, double t) {
  const point a = blend(p[0], p[1], t), b = blend(p[1], p[2], t), c = blend(p[2], p[3], t);
  const point d = blend(a, b, t), e = blend(b, c, t), at = blend(d, e, t);
  return (at.x - q.x) * (e.x - d.x) + (at.y - q.y) * (e.y - d.y);
}

}  // namespace

curve_measure::curve_measure(const domain& d, const domain_curve& curve) : curve_(&curve) {
  const point &start = d.vertices[curve.vertices.front()], &end = d.vertices[curve.vertices.back()];
  control_ = {start, curve.control[0], curve.control[1], end};
  if (curve.kind != curve_kind::arc) return;
  const rational square = squared(minus(exact(start), exact(curve.centre)));
  radius_below_ = root_below(square);
  radius_above_ = root_above(square);
}

double curve_measure::reach() const {
  double most = 0;
  for (const point& p : control_) most = std::max({most, std::abs(p.x), std::abs(p.y)});
  if (curve_->kind == curve_kind::cubic) return most;
  most = std::max(std::abs(control_[0].x), std::abs(control_[0].y));
  return std::max(
      {most, std::abs(curve_->centre.x), std::abs(curve_->centre.y), double_above(radius_above_)});
}

// Returns the polar form of the cubic: symmetric, affine in each argument, f(t, t, t) on the curve.
vector2<rational> curve_measure::blossom(double u, double v, double w) const {
  std::array<rational_point, 4> p = {exact(control_[0]), exact(control_[1]), exact(control_[2]),
                                     exact(control_[3])};
  std::size_t left = 3;
  for (const double t : {u, v, w}) {
    const rational after(t), before = rational(1) - after;
    for (std::size_t i = 0; i < left; ++i)
      p[i] = {before * p[i].x + after * p[i + 1].x, before * p[i].y + after * p[i + 1].y};
    --left;
  }
  return p[0];
}

rational curve_measure::distance_to(const point& q, double t) const {
  if (curve_->kind == curve_kind::cubic)
    return root_above(squared(minus(exact(q), blossom(t, t, t))));
  const rational square = squared(minus(exact(q), exact(curve_->centre)));
  return greatest(root_above(square) - radius_below_, radius_above_ - root_below(square));
}

sign curve_measure::turn(const point& a, const point& b) const {
  const sign s = filtered_kernel().orientation(curve_->centre, a, b);
  return curve_->clockwise ? -s : s;
}

bool curve_measure::is_within(const point& q0, const point& q, const point& q1) const {
  return curve_->kind == curve_kind::cubic ||
         (turn(q0, q) == sign::positive && turn(q, q1) == sign::positive);
}

std::optional<double> curve_measure::parameter_of(const point& q, double t0, double t1) const {
  if (curve_->kind == curve_kind::arc) return t0;
  if (!(progress(control_, q, t0) < 0) || !(progress(control_, q, t1) > 0)) return std::nullopt;
  constexpr int halvings = 64;  // more than the bits between two doubles
  double low = t0, high = t1;
  for (int i = 0; i < halvings; ++i) {
    const double t = low + (high - low) / 2;
    (progress(control_, q, t) < 0 ? low : high) = t;
  }
  return low;
}

// Maps chord to arc along the rays from the centre: that is one to one, and moves a point by the
// difference of its distance from the centre and the radius. On the chord that distance is at
// least that of the chord's nearest point, and at most that of one of its ends.
std::optional<rational> curve_measure::arc_distance(const point& q0, const point& q1) const {
  if (turn(q0, q1) != sign::positive) return std::nullopt;
  const rational_point c = exact(curve_->centre), a = minus(exact(q0), c), b = minus(exact(q1), c);
  const rational_point along = minus(b, a);
  const bool has_foot = dot(a, along) < 0 && dot(b, along) > 0;
  const rational area = cross(a, b);
  const rational nearest =
      has_foot ? rational(area * area / squared(along)) : std::min(squared(a), squared(b));
  const rational farthest = greatest(squared(a), squared(b));
  return greatest(radius_above_ - root_below(nearest), root_above(farthest) - radius_below_);
}

// Bounds the distance by the control points b0 to b3 of the piece. Their distances from the chord's
// line are d0 to d3; b0 and b3 are within e of the chord's ends. In Bernstein's basis b1 and b2
// have at most three quarters of the weight, so that the piece is within m = max(|d0|, |d3|) + 3/4
// max(|d1|, |d2|) of the line. If the feet of b1 and b2 are on the chord, the piece is within m + e
// of the chord; else it is within the largest distance of a control point from the chord, as the
// chord is convex. Each point of the chord is the foot of a point of the piece, except within e of
// the chord's ends; there it is within 2 e of b0 or b3.
rational curve_measure::cubic_distance(const point& q0, double t0, const point& q1,
                                       double t1) const {
  const std::array<rational_point, 4> b = {blossom(t0, t0, t0), blossom(t0, t0, t1),
                                           blossom(t0, t1, t1), blossom(t1, t1, t1)};
  const rational_point from = exact(q0), to = exact(q1), along = minus(to, from);
  const rational length = squared(along);
  const rational ends = root_above(greatest(squared(minus(b[0], from)), squared(minus(b[3], to))));
  std::array<rational, 4> off;
  rational farthest = 0;
  bool is_beside = true;
  for (std::size_t i = 0; i < 4; ++i) {
    const rational_point way = minus(b[i], from);
    const rational height = cross(along, way), part = dot(along, way);
    off[i] = height * height / length;
    if (part >= 0 && part <= length) {
      farthest = greatest(farthest, off[i]);
      continue;
    }
    if (i == 1 || i == 2) is_beside = false;
    farthest = greatest(farthest, std::min(squared(way), squared(minus(b[i], to))));
  }
  const rational line =
      root_above(greatest(off[0], off[3])) + rational(0.75) * root_above(greatest(off[1], off[2]));
  const rational piece = is_beside ? rational(line + ends) : root_above(farthest);
  return greatest(piece, line + 2 * ends);
}

std::optional<rational> curve_measure::distance_of_chord(const point& q0, double t0,
                                                         const point& q1, double t1) const {
  if (curve_->kind == curve_kind::arc) return arc_distance(q0, q1);
  if (!(t0 < t1)) return std::nullopt;
  return cubic_distance(q0, t0, q1, t1);
}

curve_audit::curve_audit(audit_context& context) : context_(&context) {
  const auto& curves = context.options.original->curves;
  curves_.resize(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c)
    if (!add(c))
      context.found(finding_kind::curve_deviation, text(c) + " is none that leads along vertices");
}

std::string curve_audit::text(std::size_t curve) const {
  return "curve " + number_of(*context_, curve) + " of the domain";
}

// Enters a curve if it is valid: its parameters finite and increasing, its vertices in range, and
// its chords no chords of another curve. Returns false for invalid curves.
bool curve_audit::add(std::size_t curve) {
  const domain& d = *context_->options.original;
  const domain_curve& c = d.curves[curve];
  const auto is_finite = [](const point& p) { return std::isfinite(p.x) && std::isfinite(p.y); };
  if (c.vertices.size() < 2 || c.parameters.size() != c.vertices.size()) return false;
  for (const vertex_index v : c.vertices)
    if (v >= d.vertices.size() || !is_finite(d.vertices[v])) return false;
  if (c.parameters.front() != 0 || c.parameters.back() != 1) return false;
  for (std::size_t i = 0; i + 1 < c.parameters.size(); ++i)
    if (!(c.parameters[i] < c.parameters[i + 1])) return false;
  if (!is_finite(c.centre) || !is_finite(c.control[0]) || !is_finite(c.control[1])) return false;
  if (c.kind == curve_kind::arc && c.centre == d.vertices[c.vertices.front()]) return false;
  curves_[curve].emplace(d, c);
  for (std::size_t i = 0; i + 1 < c.vertices.size(); ++i)
    if (!chords_.try_emplace(std::minmax(c.vertices[i], c.vertices[i + 1]), chord{curve, i, false})
             .second)
      return false;
  ++context_->report.curves.curves;
  return check_vertices(curve) && check_turn(curve);
}

// Checks that the domain's vertices along the curve are on it, but for rounding.
bool curve_audit::check_vertices(std::size_t curve) {
  const domain& d = *context_->options.original;
  const domain_curve& c = d.curves[curve];
  const curve_measure& measure = *curves_[curve];
  const double unit = unit_in_last_place(measure.reach());
  for (std::size_t i = 0; i < c.vertices.size(); ++i) {
    const rational off = measure.distance_to(d.vertices[c.vertices[i]], c.parameters[i]);
    const bool is_end_of_arc = c.kind == curve_kind::arc && i + 1 == c.vertices.size();
    const double allowed =
        is_end_of_arc ? std::max(digits_off * measure.reach(), units_off * unit) : units_off * unit;
    ++context_->report.decisions;
    ++context_->report.exact_decisions;
    if (off > rational(allowed))
      context_->found(finding_kind::curve_deviation,
                      vertex_text(*context_, c.vertices[i]) + " is up to " +
                          number_text(double_above(off)) + " away from " + text(curve));
  }
  const bool is_circle = c.vertices.front() == c.vertices.back();
  context_->report.curves.vertices += c.vertices.size() - (is_circle ? 1 : 0);
  return true;
}

// Checks that an arc's pieces together turn less than once around the centre, or once for a circle:
// no piece but the first passes the direction of the start, and only the last may end on it. That
// each piece turns forward is checked when it is measured.
bool curve_audit::check_turn(std::size_t curve) {
  const domain& d = *context_->options.original;
  const domain_curve& c = d.curves[curve];
  if (c.kind != curve_kind::arc) return true;
  const point& start = d.vertices[c.vertices.front()];
  for (std::size_t i = 1; i + 1 < c.vertices.size(); ++i) {
    const sign before = curves_[curve]->turn(d.vertices[c.vertices[i]], start);
    const sign after = curves_[curve]->turn(start, d.vertices[c.vertices[i + 1]]);
    const bool may_reach = i + 2 == c.vertices.size();
    if (before == sign::positive &&
        (after == sign::positive || (!may_reach && after == sign::zero)))
      return false;
  }
  return true;
}

// Divides the mesh's vertices along a chord at those that are on the curve, and measures each part.
std::vector<std::vector<vertex_index>> curve_audit::parts_of(std::vector<vertex_index> along,
                                                             chord& at) {
  const domain_curve& c = context_->options.original->curves[at.curve];
  const curve_measure& curve = *curves_[at.curve];
  at.seen = true;
  if (along.front() != c.vertices[at.first]) std::reverse(along.begin(), along.end());
  const double end = c.parameters[at.first + 1];
  const rational allowed(units_off * unit_in_last_place(curve.reach()));
  double from = c.parameters[at.first];
  std::vector<std::vector<vertex_index>> parts{{along.front()}};
  for (std::size_t i = 1; i < along.size(); ++i) {
    const point &start = context_->at(parts.back().front()), &q = context_->at(along[i]);
    double t = end;
    bool is_on = i + 1 == along.size();
    if (!is_on) {
      const auto found = curve.parameter_of(q, from, end);
      is_on = found && curve.is_within(start, q, context_->at(along.back())) &&
              curve.distance_to(q, *found) <= allowed;
      if (is_on) t = *found;
      ++(is_on ? context_->report.curves.vertices : context_->report.curves.off_curve);
    }
    parts.back().push_back(along[i]);
    if (!is_on) continue;
    measure(curve, at.curve, parts.back().front(), from, along[i], t);
    from = t;
    if (i + 1 < along.size()) parts.push_back({along[i]});
  }
  return parts;
}

void curve_audit::measure(const curve_measure& curve, std::size_t number, vertex_index a, double t0,
                          vertex_index b, double t1) {
  ++context_->report.decisions;
  ++context_->report.exact_decisions;
  const auto distance = curve.distance_of_chord(context_->at(a), t0, context_->at(b), t1);
  if (!distance) {
    context_->found(finding_kind::curve_deviation, "from " + vertex_text(*context_, a) + " to " +
                                                       vertex_text(*context_, b) + " " +
                                                       text(number) + " is not followed");
    return;
  }
  double& largest = context_->report.curves.largest_distance;
  largest = std::max(largest, double_above(*distance));
}

void curve_audit::finish() {
  for (const auto& [ends, one] : chords_)
    if (!one.seen)
      context_->found(finding_kind::curve_deviation,
                      "no segment from " + vertex_text(*context_, ends.first) + " to " +
                          vertex_text(*context_, ends.second) + ", a chord of " + text(one.curve));
  curve_report& report = context_->report.curves;
  if (report.off_curve == 0 || !std::isfinite(context_->report.largest_deviation)) return;
  report.largest_distance = double_above(rational(report.largest_distance) +
                                         rational(context_->report.largest_deviation));
}

}  // namespace asterism::internal::audit_detail
