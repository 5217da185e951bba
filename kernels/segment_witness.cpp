// SPDX-License-Identifier: MIT
//
// Bounds. `size` of a value is at least the sum of its absolute monomials, each of which passes at
// most twelve operations: the value is off by less than 2^-48 of `size` in any rounding mode, and
// by underflows that smallest_decided covers in the required range. The edge crosses the bisector
// at the part t = W / (V + W) of its length from v, with V and W the lengths of the edge in the
// metrics of v and w; where the sizes of their squares are at most 2^24 times these squares, t is
// off by at most 2^-25.
#include "asterism/kernels/segment_witness.hpp"

#include <cmath>

#include "asterism/core/plane_algebra.hpp"
#include "asterism/kernels/semi_static_filter.hpp"

namespace asterism::internal {
namespace {

struct sized {
  double value, size;
};

sized length_squared(const metric_tensor& m, const displacement<double>& u) {
  const double unmixed = m.m11 * (u.x * u.x) + m.m22 * (u.y * u.y), mixed = m.m12 * (u.x * u.y);
  return {unmixed + (mixed + mixed), 2 * unmixed};
}

bool is_well_known(const sized& length) {
  return length.value > 0x1p-24 * length.size && length.value > 0x1p-180;
}

// Part of a segment from one end to the crossing with the bisector, in that end's metric.
struct way {
  displacement<double> along;  // from this end to the other one
  sized own;                   // |along|^2 in this end's metric
  double share;                // of `along` up to the crossing
};

// True if a site of metric m, at e from the start of the way, is certainly farther than the start
// from each point t d of the way: |e - t d|_m^2 - t^2 |d|^2 = c - 2 b t + a t^2 is positive up to t
// = share. It is positive at t = 0, and tested at t = share; it is positive in between if it is
// concave or monotonic. It changes by at most 3 (c + |d|_m^2 + |d|^2) times the error of t; |b| is
// at most half a sum of squares, as are its monomials.
bool stays_farther(const metric_tensor& m, const displacement<double>& e, const sized& seen,
                   const way& to) {
  const sized c = length_squared(m, e);
  const double a = seen.value - to.own.value, b = dot(e, apply(m, to.along)), t = to.share;
  const double margin = 0x1p-22 * ((c.value + seen.value) + to.own.value) +
                        0x1p-44 * ((c.size + seen.size) + to.own.size) +
                        semi_static::smallest_decided;
  if (!(c.value - t * (2 * b - a * t) > margin)) return false;
  return a * t + 3 * margin < b || a < -margin || b < -margin;
}

}  // namespace

bool segment_shows_edge(const site& v, const site& w, const site& x, const site& y) {
  const auto d = between(v.position, w.position);
  const sized by_v = length_squared(v.metric, d), by_w = length_squared(w.metric, d);
  const double root_v = std::sqrt(by_v.value), root_w = std::sqrt(by_w.value);
  const double inverse = 1 / (root_v + root_w);
  const way from_v{d, by_v, root_w * inverse}, from_w{-d, by_w, root_v * inverse};
  const auto shows = [&](const site& z) {
    const auto to_z = between(v.position, z.position);
    const double extents = (z.metric.m11 + z.metric.m22) + (to_z.x * to_z.x + to_z.y * to_z.y);
    const sized seen = length_squared(z.metric, d);
    return extents <= semi_static::largest_operand && stays_farther(z.metric, to_z, seen, from_v) &&
           stays_farther(z.metric, between(w.position, z.position), seen, from_w);
  };
  const double extents =
      ((v.metric.m11 + v.metric.m22) + (w.metric.m11 + w.metric.m22)) + (d.x * d.x + d.y * d.y);
  return extents <= semi_static::largest_operand && is_well_known(by_v) && is_well_known(by_w) &&
         shows(x) && shows(y);
}

}  // namespace asterism::internal
