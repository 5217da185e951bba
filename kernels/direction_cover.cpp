// SPDX-License-Identifier: MIT
#include "asterism/kernels/direction_cover.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <type_traits>

#include "asterism/core/plane_algebra.hpp"
#include "asterism/kernels/bounded.hpp"
#include "asterism/kernels/normal_frame.hpp"

namespace asterism::internal {

using namespace star_gap_detail;

namespace {

using vector = displacement<bounded>;

vector exactly(const displacement<double>& e) { return {bounded(e.x), bounded(e.y)}; }
double value_of(const bounded& x) { return x.value(); }
displacement<double> values_of(const vector& e) { return {e.x.value(), e.y.value()}; }

// The comparisons of bounded numbers, for plain doubles: without errors, true whenever that of the
// bounded numbers with these values is.
bool is_positive(double x) { return x > 0; }
bool is_positive(const bounded& x) { return x.certainly_positive(); }
bool is_less(double a, double b) { return a < b; }
bool is_less(const bounded& a, const bounded& b) { return certainly_less(a, b); }
double root(double x) { return x > 0 ? std::sqrt(x) : 0; }

// The function s_z(e) = e . covector + sqrt(|e|^2 - bend (e x offset)^2) inverse_length of a site
// z, in v's frame.
template <class Number>
struct seen_function {
  Number radicand(const displacement<Number>& e, const Number& bent) const {
    const Number turned = cross(e, offset);
    return dot(e, e) - bent * (turned * turned);
  }
  Number meeting(const displacement<Number>& e, const Number& radicand_there) const {
    return dot(e, covector) + root(radicand_there) * inverse_length;
  }

  // Returns the gradient at m of s, the inverse of the parameter at which the ray first meets the
  // bisector; nothing if s is not certainly real at m.
  std::optional<displacement<Number>> tangent(const displacement<Number>& m) const {
    const Number turned = cross(m, offset);
    const Number radicand_there = dot(m, m) - bend * (turned * turned);
    if (!is_positive(radicand_there)) return std::nullopt;
    const Number factor = inverse_length / root(radicand_there), leant = bend * turned;
    return covector + factor * displacement<Number>{m.x - leant * offset.y, m.y + leant * offset.x};
  }

  displacement<Number> offset, covector;
  Number inverse_length, bend;
};

// The function of a site as bounded numbers, and their values alone.
struct seen_site : seen_function<bounded> {
  seen_site(const framed_site& f, double rho) {
    const auto within = [&](double x, double size) { return bounded::within(x, rho * size); };
    offset = {within(f.offset.x, f.extent), within(f.offset.y, f.extent)};
    const basic_metric_tensor<bounded> n{within(f.metric.m11, f.trace),
                                         within(f.metric.m12, f.trace),
                                         within(f.metric.m22, f.trace)};
    const vector dual = apply(n, offset);
    const bounded length = dot(offset, dual), square = dot(offset, offset);
    usable =
        normal_frame::in_range(f) && length.certainly_positive() && square.certainly_positive();
    if (!usable) return;
    const bounded inverse = bounded(1) / length;
    covector = inverse * dual;
    inverse_length = root(inverse);
    bend = within(f.determinant, f.trace * f.trace) * inverse;
    const bounded round = bounded(1) / square;
    convex = certainly_less(bend, round);
    concave = certainly_less(round, bend);
    most_bend = greater(bend.upper(), round.upper());
    least_bend = greater(0, -greater(-bend.lower(), -round.lower()));
    plain = {values_of(offset), values_of(covector), value_of(inverse_length), value_of(bend)};
  }

  template <class Number>
  const seen_function<Number>& as() const {
    if constexpr (std::is_same_v<Number, double>)
      return plain;
    else
      return *this;
  }

  static double greater(double a, double b) { return a > b ? a : b; }

  seen_function<double> plain;
  double least_bend = 0, most_bend = 0;  // of bend and 1 / |offset|^2, from outside
  bool convex = false, concave = false;  // certainly
  bool usable = false;
};

// One end of a cone: a direction, which may be that of a neighbour.
struct direction {
  vector e;
  const seen_site* neighbour = nullptr;
};

// The ends of a cone and the direction between them, in numbers of one type, with upper bounds of
// s_w at the ends.
template <class Number>
struct measured_cone {
  displacement<Number> right, left, middle;
  Number w_right, w_left;
};

class direction_cover {
 public:
  direction_cover(const seen_site& w, const seen_site& x, const seen_site& y)
      : w_(w), beside_{{{&x, cross(w.offset, x.offset)}, {&y, cross(w.offset, y.offset)}}} {}

  // True if the cones cover all directions in which v and w may see a common point.
  bool is_complete() {
    const displacement<double> d = values_of(w_.offset), n{-d.y, d.x};
    if (w_.concave) {
      const double least = ((w_.bend * dot(w_.offset, w_.offset)) - bounded(1)).lower();
      const double side = (1 + outward) / std::sqrt(least);
      const direction left{exactly({d.x + side * n.x, d.y + side * n.y})},
          right{exactly({d.x - side * n.x, d.y - side * n.y})};
      if (least > 0 && side < 64 && is_beyond(left.e) && is_beyond(right.e))
        return covers(right, left);
    }
    const direction left{exactly({n.x - outward * d.x, n.y - outward * d.y})},
        right{exactly({-n.x - outward * d.x, -n.y - outward * d.y})}, ahead{exactly(d)};
    return is_beyond(left.e) && is_beyond(right.e) && covers(right, ahead) && covers(ahead, left);
  }

 private:
  static constexpr double outward = 0x1p-12;

  struct neighbour {
    const seen_site* z;
    bounded turn;  // offset of w x offset of z
  };

  // True if w certainly allows no point in direction e, nor in directions farther from that of w:
  // the ray never meets w's bisector, or makes an obtuse angle with the direction of w.
  bool is_beyond(const vector& e) const {
    return w_.radicand(e, w_.bend).certainly_negative() || dot(e, w_.offset).certainly_negative();
  }

  bool covers(const direction& right, const direction& left) {
    if (--cones_left_ < 0) return false;
    const displacement<double> m = between_directions(right.e, left.e);
    if (is_forbidden(right, left, m)) return true;
    if (is_open(m)) return false;
    const direction split = splitting(right, left, m);
    return covers(right, split) && covers(split, left);
  }

  static displacement<double> between_directions(const vector& a, const vector& b) {
    const displacement<double> u = values_of(a), w = values_of(b);
    const double long_u = std::sqrt(dot(u, u)), long_w = std::sqrt(dot(w, w));
    return {u.x / long_u + w.x / long_w, u.y / long_u + w.y / long_w};
  }

  // Returns the direction that splits the cone: a neighbour's ray inside it, else its middle.
  direction splitting(const direction& right, const direction& left,
                      const displacement<double>& m) const {
    for (const neighbour& side : beside_) {
      if (side.z == right.neighbour || side.z == left.neighbour) continue;
      const vector& d = side.z->offset;
      if (cross(right.e, d).value() > 0 && cross(d, left.e).value() > 0) return {d, side.z};
    }
    return {exactly(m)};
  }

  // True if one reason forbids all directions of the cone. Tries each reason in plain doubles
  // first.
  bool is_forbidden(const direction& right, const direction& left,
                    const displacement<double>& m) const {
    const auto plain = measured<double>({values_of(right.e), values_of(left.e), m, 0, 0});
    if (!plain) return false;
    std::optional<measured_cone<bounded>> proven;
    const auto is_proven = [&](const auto& reason) {
      if (!proven) proven = measured<bounded>({right.e, left.e, exactly(m), 0, 0});
      return proven && reason(*proven);
    };
    return std::any_of(beside_.begin(), beside_.end(), [&](const neighbour& side) {
      const auto first = [&](const auto& cone) { return comes_first(*side.z, cone); };
      const auto enclosed = [&](const auto& cone) { return is_enclosed(side, right, left, cone); };
      return (first(*plain) && is_proven(first)) || (enclosed(*plain) && is_proven(enclosed));
    });
  }

  // Adds a convex upper bound of s_w at both ends of the cone; nothing if none is known.
  template <class Number>
  std::optional<measured_cone<Number>> measured(measured_cone<Number> cone) const {
    const seen_function<Number>& w = w_.as<Number>();
    if (w_.concave && is_positive(dot(cone.middle, w.offset))) {
      const auto tangent = w.tangent(cone.middle);
      if (!tangent) return std::nullopt;
      cone.w_right = dot(cone.right, *tangent);
      cone.w_left = dot(cone.left, *tangent);
      return cone;
    }
    const Number bend(w_.least_bend);
    cone.w_right = w.meeting(cone.right, w.radicand(cone.right, bend));
    cone.w_left = w.meeting(cone.left, w.radicand(cone.left, bend));
    return cone;
  }

  // True if in each direction of the cone the ray meets z's bisector before it meets w's. Compares
  // with a concave lower bound of s_z.
  template <class Number>
  static bool comes_first(const seen_site& site, const measured_cone<Number>& cone) {
    const seen_function<Number>& z = site.as<Number>();
    if (!is_positive(dot(cone.right, z.offset)) || !is_positive(dot(cone.left, z.offset)))
      return false;
    if (site.convex) {
      const auto tangent = z.tangent(cone.middle);
      return tangent && is_less(cone.w_right, dot(cone.right, *tangent)) &&
             is_less(cone.w_left, dot(cone.left, *tangent));
    }
    const Number bend(site.most_bend);
    const auto first_at = [&](const displacement<Number>& e, const Number& of_w) {
      const Number radicand = z.radicand(e, bend);
      return is_positive(radicand) && is_less(of_w, z.meeting(e, radicand));
    };
    return first_at(cone.right, cone.w_right) && first_at(cone.left, cone.w_left);
  }

  // True if z's ray is between w's ray and the cone of directions, and in each direction of the
  // cone the triangle of v, w and the point on w's bisector contains z.
  template <class Number>
  bool is_enclosed(const neighbour& side, const direction& right, const direction& left,
                   const measured_cone<Number>& cone) const {
    const bool on_left = side.turn.certainly_positive();
    if (!on_left && !side.turn.certainly_negative()) return false;
    const displacement<Number>& z = side.z->as<Number>().offset;
    const Number turn = cross(w_.as<Number>().offset, z);
    const auto nearer_at = [&](const direction& end, const displacement<Number>& e,
                               const Number& of_w) {
      if (end.neighbour == side.z) return is_less(of_w, Number(1));
      const Number beyond = cross(z, e);
      if (!is_positive(on_left ? beyond : -beyond)) return false;
      // Computes turn times l(e), where l is the linear function that is 1 at w and at z.
      const Number line = cross(e, z) + cross(w_.as<Number>().offset, e);
      const Number product = of_w * turn;
      return on_left ? is_less(product, line) : is_less(line, product);
    };
    return nearer_at(right, cone.right, cone.w_right) && nearer_at(left, cone.left, cone.w_left);
  }

  // True if no reason forbids direction m in plain doubles: the ray meets w's bisector before those
  // of the neighbours, and no triangle contains a neighbour.
  bool is_open(const displacement<double>& m) const {
    if (is_beyond(exactly(m))) return false;
    const double s = seen_at(w_.plain, m);
    if (!(s > 0)) return false;
    for (const neighbour& side : beside_) {
      const displacement<double>& d = side.z->plain.offset;
      if (dot(m, d) > 0 && s < seen_at(side.z->plain, m)) return false;
      const double turn = side.turn.value(), beyond = cross(d, m);
      if (turn * beyond > 0 && s < (cross(w_.plain.offset, m) - beyond) / turn) return false;
    }
    return true;
  }
  // Returns s_z(e), the inverse of the parameter at which the ray along e meets z's bisector; 0
  // where it never does.
  static double seen_at(const seen_function<double>& z, const displacement<double>& e) {
    const double radicand = z.radicand(e, z.bend);
    return radicand > 0 ? z.meeting(e, radicand) : 0;
  }

  const seen_site& w_;
  std::array<neighbour, 2> beside_;
  int cones_left_ = 24;
};

}  // namespace

bool no_direction_is_left(const site& v, const site& w, const site& x, const site& y) {
  const normal_frame frame(v);
  if (!frame.usable()) return false;
  const auto seen = [&](const site& z) { return seen_site(frame.bring(z), frame.rho()); };
  const seen_site w_seen = seen(w), x_seen = seen(x), y_seen = seen(y);
  if (!w_seen.usable || !x_seen.usable || !y_seen.usable) return false;
  return direction_cover(w_seen, x_seen, y_seen).is_complete();
}

}  // namespace asterism::internal
