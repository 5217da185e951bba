// SPDX-License-Identifier: MIT
#include "asterism/kernels/direction_cover.hpp"

#include <array>
#include <cmath>
#include <optional>

#include "asterism/core/plane_algebra.hpp"
#include "asterism/kernels/bounded.hpp"
#include "asterism/kernels/normal_frame.hpp"

namespace asterism::internal {

using namespace star_gap_detail;

namespace {

using vector = displacement<bounded>;

vector exactly(const displacement<double>& e) { return {bounded(e.x), bounded(e.y)}; }
displacement<double> values_of(const vector& e) { return {e.x.value(), e.y.value()}; }

// The function s_z(e) = e . covector + sqrt(|e|^2 - bend (e x offset)^2) inverse_length of a site
// z, in v's frame.
struct seen_site {
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
  }

  bounded radicand(const vector& e, const bounded& bent) const {
    const bounded turned = cross(e, offset);
    return dot(e, e) - bent * (turned * turned);
  }
  bounded meeting(const vector& e, const bounded& radicand_there) const {
    return dot(e, covector) + root(radicand_there) * inverse_length;
  }

  // Returns the gradient at m of s, the inverse of the parameter at which the ray first meets the
  // bisector; nothing if s is not certainly real at m.
  std::optional<vector> tangent(const vector& m) const {
    const bounded turned = cross(m, offset);
    const bounded radicand_there = dot(m, m) - bend * (turned * turned);
    if (!radicand_there.certainly_positive()) return std::nullopt;
    const bounded factor = inverse_length / root(radicand_there), leant = bend * turned;
    return covector + factor * vector{m.x - leant * offset.y, m.y + leant * offset.x};
  }

  static double greater(double a, double b) { return a > b ? a : b; }

  vector offset, covector;
  bounded inverse_length, bend;
  double least_bend = 0, most_bend = 0;  // of bend and 1 / |offset|^2, from outside
  bool convex = false, concave = false;  // certainly
  bool usable = false;
};

// One end of a cone: a direction, which may be that of a neighbour.
struct direction {
  vector e;
  const seen_site* neighbour = nullptr;
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
    if (is_forbidden(right, left, exactly(m))) return true;
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

  // True if one reason forbids all directions of the cone. Compares a convex upper bound of s_w
  // with concave lower bounds of the neighbours' functions, at both ends of the cone.
  bool is_forbidden(const direction& right, const direction& left, const vector& m) const {
    bounded w_right, w_left;
    if (w_.concave && dot(m, w_.offset).certainly_positive()) {
      const auto tangent = w_.tangent(m);
      if (!tangent) return false;
      w_right = dot(right.e, *tangent);
      w_left = dot(left.e, *tangent);
    } else {
      const bounded bend(w_.least_bend);
      w_right = w_.meeting(right.e, w_.radicand(right.e, bend));
      w_left = w_.meeting(left.e, w_.radicand(left.e, bend));
    }
    for (const neighbour& side : beside_)
      if (comes_first(*side.z, right.e, left.e, m, w_right, w_left) ||
          is_enclosed(side, right, left, w_right, w_left))
        return true;
    return false;
  }

  // True if in each direction of the cone the ray meets z's bisector before it meets w's.
  static bool comes_first(const seen_site& z, const vector& right, const vector& left,
                          const vector& m, const bounded& w_right, const bounded& w_left) {
    if (!dot(right, z.offset).certainly_positive() || !dot(left, z.offset).certainly_positive())
      return false;
    if (z.convex) {
      const auto tangent = z.tangent(m);
      return tangent && certainly_less(w_right, dot(right, *tangent)) &&
             certainly_less(w_left, dot(left, *tangent));
    }
    const bounded bend(z.most_bend);
    const auto first_at = [&](const vector& e, const bounded& of_w) {
      const bounded radicand = z.radicand(e, bend);
      return radicand.certainly_positive() && certainly_less(of_w, z.meeting(e, radicand));
    };
    return first_at(right, w_right) && first_at(left, w_left);
  }

  // True if z's ray is between w's ray and the cone of directions, and in each direction of the
  // cone the triangle of v, w and the point on w's bisector contains z.
  bool is_enclosed(const neighbour& side, const direction& right, const direction& left,
                   const bounded& w_right, const bounded& w_left) const {
    const bool on_left = side.turn.certainly_positive();
    if (!on_left && !side.turn.certainly_negative()) return false;
    const auto nearer_at = [&](const direction& end, const bounded& of_w) {
      if (end.neighbour == side.z) return certainly_less(of_w, bounded(1));
      const bounded beyond = cross(side.z->offset, end.e);
      if (!(on_left ? beyond : -beyond).certainly_positive()) return false;
      // Computes turn times l(e), where l is the linear function that is 1 at w and at z.
      const bounded line = cross(end.e, side.z->offset) + cross(w_.offset, end.e);
      const bounded product = of_w * side.turn;
      return on_left ? certainly_less(product, line) : certainly_less(line, product);
    };
    return nearer_at(right, w_right) && nearer_at(left, w_left);
  }

  // True if no reason forbids direction m in plain doubles: the ray meets w's bisector before those
  // of the neighbours, and no triangle contains a neighbour.
  bool is_open(const displacement<double>& m) const {
    const vector e = exactly(m);
    if (is_beyond(e)) return false;
    const double s = seen_at(w_, e);
    if (!(s > 0)) return false;
    for (const neighbour& side : beside_) {
      const vector& d = side.z->offset;
      if (dot(e, d).value() > 0 && s < seen_at(*side.z, e)) return false;
      const double turn = side.turn.value(), beyond = cross(d, e).value();
      if (turn * beyond > 0 && s < (cross(w_.offset, e).value() - beyond) / turn) return false;
    }
    return true;
  }
  // Returns s_z(e), the inverse of the parameter at which the ray along e meets z's bisector; 0
  // where it never does.
  static double seen_at(const seen_site& z, const vector& e) {
    const bounded radicand = z.radicand(e, z.bend);
    return radicand.value() > 0 ? z.meeting(e, radicand).value() : 0;
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
