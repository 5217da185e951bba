// SPDX-License-Identifier: MIT
#include "asterism/kernels/star_gap.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace asterism::internal {

using namespace star_gap_detail;

namespace {

// Returns the relative error to which divisors and roots in side conditions are known,
// `ingredient`. A side condition is decided only where it is more than `tolerance`, eight times
// this, times its magnitude away from zero: it need not be sharp. Both grow with the frame's rho
// only if that is large.
double ingredient_tolerance(double rho) {
  const double needed = 0x1p14 * rho;
  return needed > 0x1p-18 ? needed : 0x1p-18;
}

// Bounds of the directions z + step n: each in this range is a valid choice, without an overflow,
// and without an underflow that matters.
constexpr double least_step = 0x1p-30, most_step = 0x1p10;

// Returns the greater number; std::fmax is slower, as it handles NaNs.
double greater(double a, double b) { return a > b ? a : b; }

displacement<double> quarter_turn(const displacement<double>& u) { return {-u.y, u.x}; }

metric_tensor complement(const metric_tensor& n) { return {1 - n.m11, -n.m12, 1 - n.m22}; }

double extent_of(const displacement<double>& u) { return std::abs(u.x) + std::abs(u.y); }

}  // namespace

star_gap::star_gap(const site& v, const site& y, const site& x) : frame_(v) {
  x_.site = frame_.bring(x);
  y_.site = frame_.bring(y);
  if (!frame_.usable() || !normal_frame::in_range(x_.site) || !normal_frame::in_range(y_.site))
    return;
  x_.dual = apply(x_.site.metric, x_.site.offset);
  y_.dual = apply(y_.site.metric, y_.site.offset);
  x_.c = dot(x_.site.offset, x_.dual);
  y_.c = dot(y_.site.offset, y_.dual);
  ingredient_ = ingredient_tolerance(frame_.rho());
  tolerance_ = 8 * ingredient_;
  enclosure_ = 0.125 * ingredient_;
  has_vertex_ = find_vertex();
  if (!has_vertex_) aim_between();
  u_squared_ = dot(u_, u_);
  u_extent_ = extent_of(u_);
  if (!normal_frame::within(u_extent_, normal_frame::most_length)) return;
  can_accept_ = enclose_meeting(x_) && enclose_meeting(y_);
  if (!can_accept_) return;
  lowest_ = x_.lowest < y_.lowest ? x_.lowest : y_.lowest;
  highest_ = greater(x_.highest, y_.highest);
  can_refuse_ = lowest_ > 0 &&
                dot(u_, x_.site.offset) > tolerance_ * (u_extent_ * x_.site.extent) &&
                dot(u_, y_.site.offset) > tolerance_ * (u_extent_ * y_.site.extent);
}

// Finds the vertex by Newton's method for f_v - f_z = u.(I - N)u + 2 u.N d - C at z = x, y, from
// the centre of the circle through v, x and y in the sum of the three metrics.
bool star_gap::find_vertex() {
  const metric_tensor at_x = complement(x_.site.metric), at_y = complement(y_.site.metric);
  const double half_x = 0.5 * x_.c, half_y = 0.5 * y_.c;
  const metric_tensor sum{1 + x_.site.metric.m11 + y_.site.metric.m11,
                          x_.site.metric.m12 + y_.site.metric.m12,
                          1 + x_.site.metric.m22 + y_.site.metric.m22};
  const auto& to_x = x_.site.offset;
  const auto& to_y = y_.site.offset;
  const auto sum_x = apply(sum, to_x), sum_y = apply(sum, to_y);
  const double long_x = dot(to_x, sum_x), long_y = dot(to_y, sum_y);
  const double half_inverse = 0.5 / cross(sum_x, sum_y);
  displacement<double> u{half_inverse * (long_x * sum_y.y - long_y * sum_x.y),
                         half_inverse * (long_y * sum_x.x - long_x * sum_y.x)};
  constexpr int most_steps = 10;
  for (int step = 0; step < most_steps; ++step) {
    const auto bent_x = apply(at_x, u), bent_y = apply(at_y, u);
    const double excess_x = dot(u, 0.5 * bent_x + x_.dual) - half_x,
                 excess_y = dot(u, 0.5 * bent_y + y_.dual) - half_y;
    const auto slope_x = bent_x + x_.dual, slope_y = bent_y + y_.dual;
    const double inverse = 1 / cross(slope_x, slope_y);
    const displacement<double> move{inverse * (excess_x * slope_y.y - excess_y * slope_x.y),
                                    inverse * (excess_y * slope_x.x - excess_x * slope_y.x)};
    u = u - move;
    const double size = extent_of(u);
    if (extent_of(move) <= 0x1p-14 * size) {
      u_ = u;
      return dot(u, x_.site.offset) > 0 && dot(u, y_.site.offset) > 0;
    }
    if (!(size <= normal_frame::most_length)) return false;
  }
  return false;
}

// Sets the direction u midway between those of x and y, each divided by its own length.
void star_gap::aim_between() {
  const double x_inverse = 1 / std::sqrt(x_.c), y_inverse = 1 / std::sqrt(y_.c);
  const double length = 1 / greater(x_inverse, y_inverse);
  u_ = (length * x_inverse) * x_.site.offset + (length * y_inverse) * y_.site.offset;
}

// Encloses the first meeting of the ray along u with the bisector of v and z, and prepares the
// bound from below. The enclosure is verified: the ray equation is certainly negative at its lower
// end and positive at its upper one.
bool star_gap::enclose_meeting(neighbour& z) const {
  z.seen_u = apply(z.site.metric, u_);
  const ray_equation<double> ray(z.site.metric, z.site.offset, z.dual, u_, u_squared_);
  z.a = ray.a;
  const double discriminant = ray.discriminant();
  if (!(discriminant > 0)) return never_met(z, ray, discriminant);
  const double inverse_c = 1 / ray.c, root = std::sqrt(discriminant), inverse_root = 1 / root;
  const double s = (ray.h + root) * inverse_c;
  const double extent = z.site.extent, trace = z.site.trace, rho = frame_.rho();
  const double error = ray_depth * rho * ray_magnitude(1.125 * s, extent, trace, u_extent_);
  const double above = error * inverse_root;
  if (!(s > 0 && above <= 0.125 * s)) return never_met(z, ray, discriminant);
  z.highest = s + above;
  if (!(ray.at(s - above) < -error && ray.at(z.highest) > error)) return false;
  const double convexity_error = convexity_depth * rho * convexity_magnitude(extent, trace);
  // Adds to the error of the ray equation the change by a replacement of det N with C / |d|^2, for
  // which s_z is concave where it may not be so (docs/math/star-gap-proof.md).
  const double u_over_c = (u_extent_ * u_extent_) * inverse_c;
  const double lower_error = error + 3 * convexity_error * u_over_c;
  const double below = lower_error * inverse_root;
  z.lowest = s - below;
  if (!(below <= 0.125 * s && ray.at(z.lowest) < -lower_error)) z.lowest = 0;
  const double c = convexity(ray.c, z.site.determinant, z.site.offset);
  if (!bound_below(z, discriminant, inverse_root, c > convexity_error)) z.lowest = 0;
  return true;
}

// True if the ray certainly never meets the bisector, so that z blocks nothing: either the roots
// are not real or both are negative.
bool star_gap::never_met(neighbour& z, const ray_equation<double>& ray, double discriminant) const {
  const double extent = z.site.extent, trace = z.site.trace, rho = frame_.rho();
  const double bound = rho * discriminant_magnitude(extent, trace, u_extent_);
  z.lowest = z.highest = 0;
  if (discriminant < -discriminant_depth * bound) return true;
  const double h_error = ray_depth * rho * (2 * trace * (extent * u_extent_));
  const double a_error = ray_depth * rho * ((u_extent_ * u_extent_) * (1 + trace));
  return ray.h < -h_error && ray.a < -a_error;
}

// Prepares the lower bound of s: its tangent at u if s is certainly convex, else its linear part
// and a bend for which its root is concave.
bool star_gap::bound_below(neighbour& z, double discriminant, double inverse_root,
                           bool convex) const {
  const auto& d = z.site.offset;
  const double extent = z.site.extent, trace = z.site.trace, rho = frame_.rho();
  const double inverse_c = 1 / z.c;
  if (!(c_depth * rho * c_magnitude(extent, trace) <= ingredient_ * z.c)) return false;
  z.slope = inverse_c * z.dual;
  z.slope_magnitude = 2 * trace * extent * inverse_c;
  if (!convex) {
    if (!(rho * (trace * trace) <= 2 * ingredient_ * z.site.determinant)) return false;
    const double inverse_square = 1 / dot(d, d);
    z.bend = (1 + tolerance_) * greater(z.site.determinant * inverse_c, inverse_square);
    return true;
  }
  if (!(discriminant_depth * rho * discriminant_magnitude(extent, trace, u_extent_) <=
        ingredient_ * discriminant))
    return false;
  z.inverse_root = inverse_root;
  const double bend = z.site.determinant * inverse_c, turned = cross(u_, d);
  z.slope.x += inverse_root * (u_.x - bend * turned * d.y);
  z.slope.y += inverse_root * (u_.y + bend * turned * d.x);
  z.slope_magnitude +=
      inverse_root * u_extent_ * (1 + 2 * (trace * extent) * (trace * extent) * inverse_c);
  return true;
}

// Returns an upper bound of both |z|/b(z) and |z|/2, b the lower bound of s: the former is at least
// the distance from v to the bisector along the edge to z, the latter is half the edge. |z| is
// known to within 2 rho of itself, C and the discriminant to within an ingredient, u . z to within
// its tolerance.
double star_gap::reach_along_edge(const neighbour& z) const {
  const double length = std::sqrt(dot(z.site.offset, z.site.offset));
  const double above_one =
      z.bend > 0
          ? length / std::sqrt(z.c)
          : z.inverse_root * (dot(u_, z.site.offset) - tolerance_ * (u_extent_ * z.site.extent));
  const double share = 1 / (1 + (1 - tolerance_) * above_one);
  return (1 + tolerance_) * length * greater(share, 0.5);
}

// Returns the reach R of lemma 4.3 (docs/math/certificate.md), in lengths of the frame: no site
// farther than R is accepted by the gap. Requires can_refuse_.
double star_gap::reach_in_frame() const {
  const double along_edges = greater(reach_along_edge(x_), reach_along_edge(y_));
  return greater(std::sqrt(u_squared_) / lowest_, along_edges);
}

double star_gap::reach() const {
  if (!can_refuse_) return std::numeric_limits<double>::infinity();
  return std::sqrt(frame_.scale()) * reach_in_frame() * (1 + 0x1p-40);
}

struct star_gap::candidate {
  framed_site site;
  displacement<double> dual;
  ray_equation<double> ray;
  double turn_y, turn_x;  // y x d and d x x, certainly positive
};

uncertain_bool star_gap::accepts(const site& w) const {
  if (!can_accept_) return {};
  const framed_site s = frame_.bring(w);
  if (!normal_frame::in_range(s)) return {};
  const auto& d = s.offset;
  const double rho = frame_.rho(), turn_y = cross(y_.site.offset, d),
               turn_x = cross(d, x_.site.offset), cross_error = cross_depth * rho * 2 * s.extent;
  if (!(turn_y > cross_error * y_.site.extent && turn_x > cross_error * x_.site.extent)) return {};
  if (!(dot(u_, d) > tolerance_ * (u_extent_ * s.extent))) return {};
  const auto dual = apply(s.metric, d);
  const candidate c{s, dual, {s.metric, d, dual, u_, u_squared_}, turn_y, turn_x};
  const double error = ray_depth * rho * ray_magnitude(highest_, s.extent, s.trace, u_extent_);
  if (c.ray.at(highest_) < -error) return witness(c);
  if (can_refuse_) {
    const double at_lowest = c.ray.at(lowest_) - error;
    if ((at_lowest > 0 && refuted(c, at_lowest)) || far_away(s)) return false;
  }
  return {};
}

// True if the first meeting of the ray along u with w's bisector is certainly a good point.
// Requires that the ray meets w's bisector before those of x and y.
uncertain_bool star_gap::witness(const candidate& w) const {
  const double discriminant = w.ray.discriminant();
  if (!(discriminant > 0)) return {};
  const double s = (w.ray.h + std::sqrt(discriminant)) / w.ray.c;
  const double low = s * (1 - enclosure_), high = s * (1 + enclosure_);
  const double error =
      ray_depth * frame_.rho() * ray_magnitude(high, w.site.extent, w.site.trace, u_extent_);
  if (!(low > 0 && w.ray.at(low) < -error && w.ray.at(high) > error)) return {};
  if (allows(x_, w.turn_x, w, s, 1) && allows(y_, w.turn_y, w, s, -1)) return true;
  return {};
}

// True if w certainly dominates p = v + u/s over z, and z is outside the triangle v, w, p. `turn`
// is the area of w and z, positive; `side` is 1 for x, -1 for y.
bool star_gap::allows(const neighbour& z, double turn, const candidate& w, double s,
                      double side) const {
  const double steep = steepness_towards(s, w.site.offset, z.c, z.a, z.dual, z.seen_u);
  const double magnitude =
      steepness_magnitude(s, w.site.extent, z.site.extent, z.site.trace, u_extent_);
  if (!(steep > tolerance_ * magnitude)) return false;
  const double beyond = side * cross(u_, z.site.offset), between = side * cross(w.site.offset, u_);
  const double reach = u_extent_ * z.site.extent;
  if (beyond > tolerance_ * 2 * reach) return true;
  const double apart = 2 * (w.site.extent * (s * z.site.extent + u_extent_) + reach);
  return s * turn - (beyond + between) > tolerance_ * apart;
}

// Convex upper bound S of s_w, the inverse of the parameter at which a ray first meets w's bisector
// (docs/math/certificate.md, section 4.2): s_w itself where it is convex, its tangent at u where it
// is concave.
struct star_gap::upper_bound {
  double convexity = 0, convexity_error = 0;
  bool concave = false;
  double inverse_root = 0;  // of the discriminant; for the tangent only
  // C S, with w's constant C, in the two directions at right angles to w: bulge + turned and bulge
  // - turned.
  double turned = 0, bulge = 0, magnitude = 0;
};

// Bounds w's parameter from above; empty if the bound's error is too large.
std::optional<star_gap::upper_bound> star_gap::bound_above(const candidate& w) const {
  const auto& d = w.site.offset;
  const double extent = w.site.extent, trace = w.site.trace, rho = frame_.rho();
  const double c_size = c_magnitude(extent, trace);
  if (!(c_depth * rho * c_size <= ingredient_ * w.ray.c)) return std::nullopt;
  upper_bound top;
  top.convexity = convexity(w.ray.c, w.site.determinant, d);
  const double convexity_size = convexity_magnitude(extent, trace);
  top.convexity_error = convexity_depth * rho * convexity_size;
  top.concave = top.convexity < -top.convexity_error;
  top.turned = dot(quarter_turn(d), w.dual);
  top.magnitude = c_size;
  if (!top.concave) {
    top.bulge = std::sqrt(dot(d, d) * (greater(top.convexity, 0) + top.convexity_error));
    top.magnitude += top.bulge;
    return top;
  }
  const double discriminant = w.ray.discriminant();
  if (!(discriminant_depth * rho * discriminant_magnitude(extent, trace, u_extent_) <=
        ingredient_ * discriminant))
    return std::nullopt;
  top.inverse_root = 1 / std::sqrt(discriminant);
  const double lean = u_extent_ * extent * top.inverse_root;
  top.turned -= cross(u_, d) * top.inverse_root * top.convexity;
  top.magnitude += 2 * lean * convexity_size;
  return top;
}

// True if w is out of reach by lemma 4.3 of docs/math/certificate.md: a site far enough away
// reaches nothing, whatever its metric. sigma^2 is the largest eigenvalue of N^-1, or 1, bounded by
// trace and determinant with room for the roundings of this function.
bool star_gap::far_away(const framed_site& w) const {
  const double rho = frame_.rho(), trace = (1 + 4 * rho) * w.trace;
  const double determinant = w.determinant - 4 * rho * (trace * trace);
  if (!(determinant > 0)) return false;
  const double half = 0.5 * trace;
  const double sigma_squared =
      (half + std::sqrt(greater(half * half - determinant, 0))) / determinant;
  const double sigma = std::sqrt(greater(sigma_squared, 1));
  const double length = (1 - tolerance_) * std::sqrt(dot(w.offset, w.offset));
  return length > (1 + sigma) * ((1 + 0x1p-40) * reach_in_frame());
}

// True if certainly no direction within a right angle of w holds a good point. `at_lowest` bounds
// the ray equation at lowest_ from below.
bool star_gap::refuted(const candidate& w, double at_lowest) const {
  const double extent = w.site.extent, trace = w.site.trace;
  const double beyond_top = w.ray.c * lowest_ - w.ray.h;
  if (!(beyond_top >
        tolerance_ * (c_magnitude(extent, trace) * lowest_ + 2 * trace * (extent * u_extent_))))
    return false;
  const auto top = bound_above(w);
  if (!top) return false;
  // Requires, unless S is the tangent, that the ray equation at lowest_ exceeds its change by a
  // replacement of det N with C / |d|^2, for which s_w is convex where it may not be so.
  if (!top->concave && !(at_lowest * w.ray.c > 4 * top->convexity_error * (u_extent_ * u_extent_)))
    return false;
  return closed_towards(x_, w, *top, w.turn_x, 1) && closed_towards(y_, w, *top, w.turn_y, -1);
}

// True if w certainly has no good point in any direction between u and n, where n is at a right
// angle to w on the side of z. Either the rays in all of these directions meet z's bisector before
// w's; or they do so up to z's ray or a direction beyond it, and in the directions from there to n
// the triangle of v, w and the point contains z. `turn` is the area spanned by w and z, positive;
// `side` is 1 for x, -1 for y.
bool star_gap::closed_towards(const neighbour& z, const candidate& w, const upper_bound& top,
                              double turn, double side) const {
  const auto& d = w.site.offset;
  const double extent = w.site.extent, c_size = c_magnitude(extent, w.site.trace);
  const double square = dot(d, d), along = dot(d, z.site.offset);
  const double at_end = side * top.turned + top.bulge;
  const double seen = square - z.bend * (along * along);
  const double reach = extent * z.site.extent, extent_squared = extent * extent;
  if (seen > tolerance_ * (2 * extent_squared + 4 * z.bend * (reach * reach))) {
    const double lower = side * (w.ray.c * dot(z.slope, quarter_turn(d)));
    const double magnitude = c_size * z.slope_magnitude * extent + top.magnitude;
    if (lower - at_end > tolerance_ * magnitude) return true;
  }
  const double magnitude = 2 * (top.magnitude * reach + c_size * (extent_squared + reach));
  // Bounds C (l - S) (d x z) at n from below; l is the linear function that is 1 at w and at z.
  const double room = w.ray.c * (square - along) - at_end * turn - tolerance_ * magnitude;
  if (!(along > tolerance_ * (2 * reach) && room > 0)) return false;
  const estimate at_z = top_at(z, w, top, turn, side);
  // Bounds C (S - l) at z from above.
  const double excess = at_z.value - w.ray.c + tolerance_ * (c_size + at_z.size);
  if (excess < 0) return true;
  const double turn_at_most = turn + cross_depth * frame_.rho() * (2 * reach);
  const double step = greater(least_step * (z.site.extent / extent),
                              (1 + tolerance_) * ((excess * turn_at_most) / room));
  if (!(step * extent <= most_step * z.site.extent)) return false;
  return met_first_at(z, w, {turn, side, step},
                      {at_z.value + step * at_end, at_z.size + step * top.magnitude});
}

// Bounds C S in the direction of z from above: it is less than `value` plus the tolerance times
// `size`.
star_gap::estimate star_gap::top_at(const neighbour& z, const candidate& w, const upper_bound& top,
                                    double turn, double side) const {
  const auto& d = w.site.offset;
  const double extent = w.site.extent, reach = extent * z.site.extent, trace = w.site.trace;
  const double c_size = c_magnitude(extent, trace);
  estimate at_z{dot(z.site.offset, w.dual), 4 * trace * reach};
  if (top.concave) {
    at_z.value += top.inverse_root * (w.ray.c * dot(u_, z.site.offset) +
                                      side * (w.site.determinant * turn) * cross(u_, d));
    at_z.size += top.inverse_root * u_extent_ *
                 (c_size * z.site.extent + 2 * (trace * trace) * (extent * reach));
    return at_z;
  }
  const double radicand = radicand_on_ray(w.ray.c, w.site.determinant, z.site.offset, turn);
  const double size = radicand_on_ray_magnitude(extent, trace, z.site.extent);
  const double unsure = 6 * top.convexity_error * (z.site.extent * z.site.extent);
  const double root = std::sqrt(greater(radicand + (tolerance_ * size + unsure), 0));
  return {at_z.value + root, at_z.size + root};
}

// True if z's lower bound, times C, is certainly more than `top` in the direction z + step n. It
// then exceeds C S from u up to that direction, as it is concave and S convex.
bool star_gap::met_first_at(const neighbour& z, const candidate& w, const direction_beyond& e,
                            const estimate& top) const {
  const auto& d = w.site.offset;
  const double extent = w.site.extent, own = z.site.extent;
  estimate lower{e.step * (e.side * dot(z.slope, quarter_turn(d))),
                 e.step * (z.slope_magnitude * extent)};
  if (z.bend > 0) {
    const double radicand = radicand_beyond(z.site.offset, d, e.turn, z.bend, e.step);
    const double size = radicand_beyond_magnitude(own, extent, z.bend, e.step);
    const double least = radicand - tolerance_ * size;
    if (!(least > 0)) return false;
    const double at_least = 1 + std::sqrt(least / z.c);
    lower.value += at_least;
    lower.size += at_least;
  } else {
    lower.value += dot(z.slope, z.site.offset);
    lower.size += z.slope_magnitude * own;
  }
  const double size = c_magnitude(extent, w.site.trace) * lower.size + top.size;
  return w.ray.c * lower.value - top.value > tolerance_ * size;
}

}  // namespace asterism::internal
