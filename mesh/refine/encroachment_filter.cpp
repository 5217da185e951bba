// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/encroachment_filter.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/mesh/numerics/constructions.hpp"

namespace asterism::internal {
namespace {

// Returns an upper bound on |d|_M^2, in doubles. With eps = 2^-52 and sum = m11 dx^2 + m22 dy^2 the
// absolute monomials add up to at most 2 sum (2 |m12 dx dy| <= sum), each carries at most 8 rounded
// factors: the error is below 32 eps sum, which no condition number of M enlarges.
double squared_length_above(const metric_tensor& m, const point& d) {
  return inner_product(m, d, d) + 0x1p-46 * (m.m11 * d.x * d.x + m.m22 * d.y * d.y);
}

// Returns a lower bound on |d|_M^2, by the error bound of squared_length_above; may be negative.
double squared_length_below(const metric_tensor& m, const point& d) {
  return inner_product(m, d, d) - 0x1p-46 * (m.m11 * d.x * d.x + m.m22 * d.y * d.y);
}

// Least squared length that is used: smaller ones may have lost more to underflow than the bounds
// allow.
constexpr double near_underflow = 0x1p-900;

// The squared distances of the points a + t (b - a) of a subsegment, as a, b and w measure them.
class subsegment_distances {
 public:
  subsegment_distances(const site& a, const site& b, const site& w)
      : a_(a.metric),
        b_(b.metric),
        w_(w.metric),
        d_{b.position.x - a.position.x, b.position.y - a.position.y},
        e_{w.position.x - a.position.x, w.position.y - a.position.y} {
    const double reach_x = std::abs(e_.x) + std::abs(d_.x),
                 reach_y = std::abs(e_.y) + std::abs(d_.y);
    magnitude_ = w_.m11 * reach_x * reach_x + w_.m22 * reach_y * reach_y;
  }

  // Returns a bound of the error of f_w at any point of the segment a b, the error of t included.
  double error() const { return 0x1p-44 * magnitude_; }

  // True if w certainly does not encroach. Nowhere on a b are both f_a and f_b above r^2, their
  // value at the bisector point, and r grows with either length; if f_w is above r^2 all along a b,
  // w does not encroach. With S the magnitude, a bound on the monomials of f_w on the segment is 2
  // S, so that evaluating f_w at t is off by less than 40 eps S. t itself is off by at most 64 eps
  // S / |d|_w^2, and by at most 1 as it is clamped, which raises f_w above its least value by less
  // than 192 eps S whichever is smaller: 256 eps = 2^-44 covers both. The few roundings of r are
  // relative. Near underflow these bounds do not hold, and nothing is decided.
  bool surely_stay_clear() const {
    const double from_a = std::sqrt(squared_length_above(a_, d_));
    const double from_b = std::sqrt(squared_length_above(b_, d_));
    const double r = from_a * from_b / (from_a + from_b);
    if (!(r * r > near_underflow)) return false;
    return squared_from_w(nearest_to_w()) - error() > (1 + 0x1p-47) * r * r;
  }

  // True if w certainly does not encroach, decided piece by piece: on the piece from t0 to t1 the
  // nearer of a and b is nowhere farther than the lesser of t1 |d|_a and (1 - t0) |d|_b. t0 and t1
  // are exact, and so are their squares; the bounds of a and b are rounded once more. f_w is least
  // at a t that is clamped to the piece, which makes the error of t no greater: error() holds as
  // above.
  bool surely_stay_clear_in_pieces() const {
    const double squared_a = squared_length_above(a_, d_), squared_b = squared_length_above(b_, d_);
    const double nearest = nearest_to_w(), off = error();
    for (int i = 0; i < pieces; ++i) {
      const double t0 = static_cast<double>(i) / pieces, t1 = static_cast<double>(i + 1) / pieces;
      const double farthest = std::min(t1 * t1 * squared_a, (1 - t0) * (1 - t0) * squared_b);
      if (!(farthest > near_underflow)) return false;
      if (!(squared_from_w(std::clamp(nearest, t0, t1)) - off > (1 + 0x1p-47) * farthest))
        return false;
    }
    return true;
  }

  // True if w certainly encroaches: if at some t it is nearer than a and b. t is chosen and exact.
  // f_a(t) is t^2 |d|_a^2, whose error squared_length_above bounds, and f_b(t) likewise with 1 - t,
  // rounded once; f_w is off by less than 40 eps S as above.
  bool surely_encroached() const {
    const double squared_a = squared_length_below(a_, d_), squared_b = squared_length_below(b_, d_);
    const double from_a = std::sqrt(squared_a), from_b = std::sqrt(squared_b);
    const auto is_nearer_at = [&](double t) {
      if (!(t > 0 && t < 1)) return false;
      const double nearer = std::min(t * t * squared_a, (1 - t) * (1 - t) * squared_b);
      return nearer > near_underflow && squared_from_w(t) + error() < (1 - 0x1p-47) * nearer;
    };
    if (is_nearer_at(from_b / (from_a + from_b)) || is_nearer_at(nearest_to_w())) return true;
    for (int i = 1; i < pieces; ++i)
      if (is_nearer_at(static_cast<double>(i) / pieces)) return true;
    return false;
  }

 private:
  // Makes the number of pieces a power of two, so that ends of pieces are exact.
  static constexpr int pieces = 32;

  double nearest_to_w() const {
    return std::clamp(inner_product(w_, d_, e_) / inner_product(w_, d_, d_), 0.0, 1.0);
  }
  double squared_from_w(double t) const {
    const point u{e_.x - t * d_.x, e_.y - t * d_.y};
    return inner_product(w_, u, u);
  }

  const metric_tensor &a_, &b_, &w_;
  point d_, e_;
  double magnitude_ = 0;
};

}  // namespace

// Decides for one metric of all three sites: w encroaches if it is in the disk that has a b for its
// diameter: if (w - a)^T M (w - b) < 0, with an error of less than 40 eps S as above.
uncertain_bool encroaches_quickly(const site& a, const site& b, const site& w) {
  const subsegment_distances along(a, b, w);
  if (identical(a.metric, w.metric) && identical(b.metric, w.metric)) {
    const point from_a{w.position.x - a.position.x, w.position.y - a.position.y},
        from_b{w.position.x - b.position.x, w.position.y - b.position.y};
    const double product = inner_product(w.metric, from_a, from_b);
    if (std::abs(product) > along.error() && along.error() > near_underflow)
      return uncertain_bool(product < 0);
  }
  if (along.surely_stay_clear()) return uncertain_bool(false);
  if (along.surely_stay_clear_in_pieces()) return uncertain_bool(false);
  if (along.surely_encroached()) return uncertain_bool(true);
  return uncertain_bool();
}

}  // namespace asterism::internal
