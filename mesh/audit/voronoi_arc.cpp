// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/voronoi_arc.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal::audit_detail {
namespace {

offset operator+(const offset& a, const offset& b) { return {a.x + b.x, a.y + b.y}; }
offset operator-(const offset& a, const offset& b) { return {a.x - b.x, a.y - b.y}; }
offset operator-(const offset& a) { return {-a.x, -a.y}; }
offset operator*(const bounded& factor, const offset& a) { return {factor * a.x, factor * a.y}; }
offset exactly(const vector2<double>& a) { return {a.x, a.y}; }
vector2<double> values(const offset& a) { return {a.x.value(), a.y.value()}; }

// Returns an upper bound of the absolute value of an enclosed number.
double magnitude(const bounded& a) { return greatest_bound(a.upper(), (-a).upper()); }

bool is_finite(const vector2<double>& a) {
  return std::abs(a.x) < infinity && std::abs(a.y) < infinity;
}

// Returns the start of Newton's method: the centre of the circle through the sites in the sum of
// the metrics.
vector2<double> centre_in_sum(const site& a, const site& b, const site& c) {
  const metric_tensor sum{a.metric.m11 + b.metric.m11 + c.metric.m11,
                          a.metric.m12 + b.metric.m12 + c.metric.m12,
                          a.metric.m22 + b.metric.m22 + c.metric.m22};
  const auto covector = [&](const vector2<double>& d) -> vector2<double> {
    return {sum.m11 * d.x + sum.m12 * d.y, sum.m12 * d.x + sum.m22 * d.y};
  };
  const auto to_b = values(between(a.position, b.position)),
             to_c = values(between(a.position, c.position));
  const auto g = covector(to_b), h = covector(to_c);
  const double half_b = 0.5 * dot(to_b, g), half_c = 0.5 * dot(to_c, h), turn = cross(g, h);
  return {(half_b * h.y - half_c * g.y) / turn, (g.x * half_c - h.x * half_b) / turn};
}

// True if D_i . (j - i) > 0 with D_i = M_i (q - i): i sees q within a right angle of j.
uncertain_bool sees(const site& i, const offset& q_from_i, const site& j) {
  const bounded value =
      dot(tensor_of_doubles(i.metric) * q_from_i, between(i.position, j.position));
  if (value.certainly_positive()) return true;
  if (value.certainly_negative()) return false;
  return {};
}

bool is_certainly_wedged(const std::array<const site*, 3>& sites, const offset& from_first) {
  for (std::size_t i = 0; i < 3; ++i) {
    const site &s = *sites[i], &next = *sites[(i + 1) % 3], &last = *sites[(i + 2) % 3];
    const offset q = from_first + between(s.position, sites[0]->position);
    if (!(sees(s, q, next) & sees(s, q, last)).certainly(true)) return false;
  }
  return true;
}

bounded square_norm(const tensor<bounded>& m, const offset& u) { return dot(u, m * u); }

// True if c0 + c1 u + c2 u^2 > 0 on [0, end], by Bernstein's coefficients.
bool certainly_positive_up_to(const bounded& c0, const bounded& c1, const bounded& c2,
                              const bounded& end) {
  const bounded middle = c0 + bounded(0.5) * c1 * end, last = c0 + c1 * end + c2 * end * end;
  if (!c0.certainly_positive() || !last.certainly_positive()) return false;
  return middle.certainly_positive() || (c0 * last - middle * middle).certainly_positive();
}

// True only if w is farther than a from all points a + u (b - a), u from 0 to `share`: |w-x|_w^2 -
// u^2 |b-a|_a^2 is positive.
bool certainly_farther(const site& a, const site& b, const site& w, double share) {
  const offset d = between(a.position, b.position), from_w = between(w.position, a.position);
  const tensor<bounded> own = tensor_of_doubles(w.metric);
  const bounded mixed = dot(from_w, own * d);
  return certainly_positive_up_to(square_norm(own, from_w), mixed + mixed,
                                  square_norm(own, d) - square_norm(tensor_of_doubles(a.metric), d),
                                  bounded(share));
}

bool within(const bounded& x, double centre, double radius) {
  return std::abs(x.value() - centre) + x.error() < radius * (1 - 0x1p-40);
}

}  // namespace

offset between(const point& from, const point& to) {
  return {bounded(to.x) - bounded(from.x), bounded(to.y) - bounded(from.y)};
}

bool is_certainly_farther_than_nearer_end(const site& a, const site& b, const site& w) {
  const offset d = between(a.position, b.position);
  const double from_a = root(square_norm(tensor_of_doubles(a.metric), d)).value(),
               from_b = root(square_norm(tensor_of_doubles(b.metric), d)).value();
  // Divides the segment where both ends are about equally far. Any share is valid: it only affects
  // how often the test succeeds.
  const double share = from_b / (from_a + from_b);
  if (!(share > 0 && share < 1)) return false;
  // Measures the remainder from b, with its length rounded up.
  const double rest = std::min(1.0, (1 - share) * (1 + 0x1p-48) + 0x1p-60);
  return certainly_farther(a, b, w, share) && certainly_farther(b, a, w, rest);
}

enclosed_arc::difference_of_distances::difference_of_distances(const site& v, const site& z) {
  const offset d = between(v.position, z.position);
  const tensor<bounded> own = tensor_of_doubles(v.metric), other = tensor_of_doubles(z.metric);
  form = {own.m11 - other.m11, own.m12 - other.m12, own.m22 - other.m22};
  const offset covector = other * d;
  linear = covector + covector;
  constant = -dot(d, covector);
}

bounded enclosed_arc::difference_of_distances::at(const offset& r) const {
  return dot(r, form * r + linear) + constant;
}

offset enclosed_arc::difference_of_distances::gradient(const offset& r) const {
  const offset half = form * r;
  return half + half + linear;
}

// Encloses the vertex by Newton's method in plain doubles, then applies Krawczyk's test to a box
// around the result.
std::optional<offset> enclose_voronoi_vertex(const site& a, const site& b, const site& c) {
  const enclosed_arc::difference_of_distances to_b(a, b), to_c(a, c);
  vector2<double> p = centre_in_sum(a, b, c), move{};
  constexpr int most_steps = 12;
  for (int step = 0; step < most_steps; ++step) {
    if (!is_finite(p)) return std::nullopt;
    const offset at = exactly(p), value{to_b.at(at), to_c.at(at)};
    const offset g = to_b.gradient(at), h = to_c.gradient(at);
    const vector2<double> gv = values(g), hv = values(h);
    const double turn = cross(gv, hv);
    // Computes the inverse of the matrix with rows g and h, approximately.
    const vector2<double> row_x{hv.y / turn, -gv.y / turn}, row_y{-hv.x / turn, gv.x / turn};
    const offset newton{dot(exactly(row_x), value), dot(exactly(row_y), value)};
    move = values(newton);
    const double length = std::abs(move.x) + std::abs(move.y);
    if (length > 0x1p-40 * (std::abs(p.x) + std::abs(p.y))) {
      p = {p.x - move.x, p.y - move.y};
      continue;
    }
    const double least = 0x1p-44 * (std::abs(p.x) + std::abs(p.y));
    const vector2<double> radius{4 * (std::abs(move.x) + newton.x.error()) + least,
                                 4 * (std::abs(move.y) + newton.y.error()) + least};
    const offset aside{bounded::within(0, radius.x), bounded::within(0, radius.y)};
    const offset box = at + aside, slope_b = to_b.gradient(box), slope_c = to_c.gradient(box);
    const offset first{bounded(1) - dot(exactly(row_x), {slope_b.x, slope_c.x}),
                       -dot(exactly(row_x), {slope_b.y, slope_c.y})},
        second{-dot(exactly(row_y), {slope_b.x, slope_c.x}),
               bounded(1) - dot(exactly(row_y), {slope_b.y, slope_c.y})};
    const offset image = at - newton + offset{dot(first, aside), dot(second, aside)};
    if (!within(image.x, p.x, radius.x) || !within(image.y, p.y, radius.y)) return std::nullopt;
    return is_certainly_wedged({&a, &b, &c}, image) ? std::optional(image) : std::nullopt;
  }
  return std::nullopt;
}

// Finds the first root: f_v - f_u at l times the direction is A l^2 + 2 H l - C, negative at l = 0.
// Its first root is where it changes from negative to positive.
std::optional<offset> enclose_bisector_point(const site& v, const site& u,
                                             const offset& direction) {
  const tensor<bounded> own = tensor_of_doubles(v.metric), other = tensor_of_doubles(u.metric);
  const offset d = between(v.position, u.position), covector = other * d;
  if (!dot(direction, own * d).certainly_positive()) return std::nullopt;
  const bounded a = dot(direction, own * direction) - dot(direction, other * direction),
                h = dot(direction, covector), c = dot(d, covector);
  const double radicand = h.value() * h.value() + a.value() * c.value();
  if (!(radicand > 0)) return std::nullopt;
  const double root = c.value() / (h.value() + std::sqrt(radicand));
  if (!(root > 0 && root < infinity)) return std::nullopt;
  const auto value = [&](double l) { return (a * bounded(l) + h + h) * bounded(l) - c; };
  for (double step = 0x1p-48; step < 0x1p-8; step *= 8) {
    const double low = root * (1 - step), high = root * (1 + step);
    if (value(low).certainly_negative() && value(high).certainly_positive())
      return bounded::within(root, 2 * root * step) * direction;
  }
  return std::nullopt;
}

enclosed_arc::enclosed_arc(const site& v, const site& u, const offset& from, const offset& to)
    : v_(v), u_(u), bisector_(v, u) {
  constexpr int most_halvings = 10;
  if (!add_spans(from, to, most_halvings)) spans_.clear();
  for (const span& s : spans_) extend_reach(s);
  if (spans_.empty()) reach_ = infinity;
}

bool enclosed_arc::add_spans(const offset& from, const offset& to, int depth) {
  if (const auto s = make_span(from, to)) {
    spans_.push_back(*s);
    return true;
  }
  if (depth == 0) return false;
  const auto cut = middle(from, to);
  return cut && add_spans(from, *cut, depth - 1) && add_spans(*cut, to, depth - 1);
}

std::optional<enclosed_arc::span> enclosed_arc::make_span(const offset& from,
                                                          const offset& to) const {
  span s{from, to, {}, 0};
  const offset slope_from = bisector_.gradient(from), slope_to = bisector_.gradient(to);
  vector2<double> n{slope_from.x.value() + slope_to.x.value(),
                    slope_from.y.value() + slope_to.y.value()};
  const double size = std::max(std::abs(n.x), std::abs(n.y));
  n = {n.x / size, n.y / size};
  if (!is_finite(n)) return std::nullopt;
  s.across = n;
  const offset across = exactly(n), chord = to - from;
  const double bend = magnitude(dot(chord, bisector_.form * chord));
  const bounded slope_a = dot(across, slope_from), slope_b = dot(across, slope_to);
  if (!slope_a.certainly_positive() || !slope_b.certainly_positive()) return std::nullopt;
  const double slope = std::min(slope_a.lower(), slope_b.lower());
  // Adds a least bulge far above the least error of `bounded`, so that a straight arc passes the
  // tests below.
  constexpr double least_bulge = 0x1p-900;
  s.bulge = 1.25 * bend / slope + least_bulge;
  if (!(s.bulge < infinity)) return std::nullopt;

  // Tests that the slope of f_v - f_u across the span, times the bulge, exceeds the bend of f_v -
  // f_u along it.
  const bounded curving = dot(across, bisector_.form * across);
  const bounded lost = bounded(0.5) * bounded(s.bulge) * bounded(magnitude(curving));
  const bounded risen = (bounded(slope) - lost) * bounded(s.bulge) - bounded(bend);
  if (!(risen.lower() >= 0)) return std::nullopt;

  // Tests that all of the span is in the wedge of v and u.
  const offset aside = bounded(0.25 * s.bulge) * across;
  const offset to_u = between(v_.position, u_.position);
  const offset seen_from_v = tensor_of_doubles(v_.metric) * to_u,
               seen_from_u = tensor_of_doubles(u_.metric) * (-to_u);
  for (const offset& end : {from, to})
    for (const offset& corner : {end + aside, end - aside})
      if (!dot(corner, seen_from_v).certainly_positive() ||
          !dot(corner - to_u, seen_from_u).certainly_positive())
        return std::nullopt;
  return s;
}

// Encloses a point of the arc that lies between two others; none if that is not certain.
std::optional<offset> enclosed_arc::middle(const offset& from, const offset& to) const {
  const vector2<double> direction{0.5 * (from.x.value() + to.x.value()),
                                  0.5 * (from.y.value() + to.y.value())};
  if (!is_finite(direction)) return std::nullopt;
  const auto cut = enclose_bisector_point(v_, u_, exactly(direction));
  if (!cut || !cross(from, *cut).certainly_positive() || !cross(*cut, to).certainly_positive())
    return std::nullopt;
  return cut;
}

// Extends the reach to a span: f_v on it is at most the greatest value at the corners of a
// parallelogram that contains it, whose corners are the span's ends moved aside in both directions.
void enclosed_arc::extend_reach(const span& s) {
  const offset aside = bounded(0.25 * s.bulge) * exactly(s.across);
  const tensor<bounded> own = tensor_of_doubles(v_.metric);
  for (const offset& end : {s.from, s.to})
    for (const offset& corner : {end + aside, end - aside})
      reach_ = greatest_bound(reach_, root(dot(corner, own * corner)).upper());
}

uncertain_bool enclosed_arc::is_nearer(const site& w, bool tied_from, bool tied_to) const {
  if (!usable()) return {};
  constexpr int most_halvings = 8;
  const difference_of_distances to_w(v_, w);
  uncertain_bool any = false;
  for (const span& s : spans_) {
    any = any | is_nearer(to_w, s, tied_from && &s == &spans_.front(),
                          tied_to && &s == &spans_.back(), most_halvings);
    if (any.certainly(true)) return any;
  }
  return any;
}

// Tests a sufficient condition: with e = f_w - f_v at the ends, f_w - f_v >= e0 (1 - t) + e1 t - k
// t (1 - t). For k <= e0 + e1 that is at least e0 (1 - t)^2 + e1 t^2: positive but for a tied end.
// For e0, e1 > 0 it is positive if k < e0 + e1 + 2 sqrt(e0 e1).
uncertain_bool enclosed_arc::is_nearer(const difference_of_distances& w, const span& s,
                                       bool tied_from, bool tied_to, int depth) const {
  // Makes an exact zero, whereas `bounded` gives all other zeros a least error.
  const bounded zero = bounded::within(0, 0);
  const bounded from = tied_from ? zero : -w.at(s.from), to = tied_to ? zero : -w.at(s.to);
  if (from.certainly_negative() || to.certainly_negative()) return true;
  const double from_below = tied_from ? 0 : from.lower(), to_below = tied_to ? 0 : to.lower();
  const bool positive_ends = (tied_from || from_below > 0) && (tied_to || to_below > 0);
  if (positive_ends && !(tied_from && tied_to)) {
    const offset chord = s.to - s.from, across = exactly(s.across);
    const bounded slope_from = dot(across, w.gradient(s.from)),
                  slope_to = dot(across, w.gradient(s.to));
    const double slope = greatest_bound(magnitude(slope_from), magnitude(slope_to));
    const double curving = greatest_bound(0, dot(across, w.form * across).upper());
    const bounded bulge(s.bulge);
    const bounded k = bulge * (bounded(slope) + bounded(0.25) * bulge * bounded(curving)) -
                      dot(chord, w.form * chord);
    const bounded excess = k - bounded(from_below) - bounded(to_below);
    if (excess.upper() <= 0) return false;
    if ((bounded(4) * bounded(from_below) * bounded(to_below) - excess * excess)
            .certainly_positive())
      return false;
  }
  if (depth == 0) return {};
  const auto cut = middle(s.from, s.to);
  if (!cut) return {};
  const auto first = make_span(s.from, *cut), second = make_span(*cut, s.to);
  if (!first || !second) return {};
  const uncertain_bool on_first = is_nearer(w, *first, tied_from, false, depth - 1);
  if (on_first.certainly(true)) return true;
  return on_first | is_nearer(w, *second, false, tied_to, depth - 1);
}

}  // namespace asterism::internal::audit_detail
