// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/distant_site.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/mesh/audit/covectors.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal::audit_detail {
namespace {

using roundings::step;
using roundings::up;

// Separates w from v by one covector g = M_v h.
struct separation {
  double least = 0;          // at most g . (w - v); not positive: nothing is known
  double own_squared = 0;    // at least |h|^2 in M_v
  double other_squared = 0;  // at least |g|_w^2
  bool is_beyond(double reach) const;
};

// The inverse metric of w is at most `factor` times this tensor.
struct inverse_bound {
  metric_tensor tensor;
  double factor;
};

// Returns an upper bound of the trace of b m. For g = m h the trace is at least the quotient of
// |g|^2 in b by |h|^2 in m. Loses fewer digits than a bound from eigenvalues where both metrics are
// much stretched.
double trace_above(const metric_tensor& b, const metric_tensor& m) {
  const double diagonal = b.m11 * m.m11 + b.m22 * m.m22, mixed = 2 * (b.m12 * m.m12);
  return (diagonal + mixed + step * (diagonal + std::abs(mixed)) + 0x1p-300) * up;
}

// Tries the covector g = M h. The computed g has an error of at most `step` times its magnitudes;
// h, a pair of doubles, need not be exact. Where w is too near even for equal metrics, the rest is
// not computed.
separation separation_along(const point& h, const point& d, const metric_tensor& m, double reach,
                            const inverse_bound& inverse) {
  const metric_tensor& b = inverse.tensor;
  const point g{m.m11 * h.x + m.m12 * h.y, m.m12 * h.x + m.m22 * h.y};
  const point size{m.m11 * std::abs(h.x) + std::abs(m.m12 * h.y),
                   std::abs(m.m12 * h.x) + m.m22 * std::abs(h.y)};
  const double least =
      g.x * d.x + g.y * d.y - step * (size.x * std::abs(d.x) + size.y * std::abs(d.y));
  const double own = g.x * h.x + g.y * h.y,
               own_size = size.x * std::abs(h.x) + size.y * std::abs(h.y);
  const double own_squared = (own + step * own_size + 0x1p-300) * up;
  if (!(least > 0x1p-300 && least * least > 4 * (reach * reach) * own_squared)) return {};
  const bool in_range = size.x + size.y < 0x1p200 && b.m11 + b.m22 < 0x1p200 &&
                        std::abs(h.x) + std::abs(h.y) < 0x1p200 && inverse.factor < 0x1p200;
  if (!in_range) return {};
  const double other = b.m11 * g.x * g.x + b.m22 * g.y * g.y + 2 * (b.m12 * g.x * g.y),
               other_size = b.m11 * size.x * size.x + b.m22 * size.y * size.y +
                            2 * (std::abs(b.m12) * size.x * size.y);
  const double other_squared = (other + step * other_size + 0x1p-300) * inverse.factor * up;
  const double turned = trace_above(b, m) * inverse.factor * up * own_squared * up;
  return {least, own_squared, std::min(other_squared, turned)};
}

// Takes roots only where the bounds 4 a^2 and 2 a^2 + 2 b^2 of (a + b)^2 do not decide: a^2 is
// own_squared, and b^2 the greater of own_squared and other_squared.
bool separation::is_beyond(double reach) const {
  if (!(least > 0 && reach < 0x1p200)) return false;
  constexpr double smallest_reach = 0x1p-200;
  const double r = std::max(reach, smallest_reach), square = least * least / up;
  const double other = std::max(own_squared, other_squared);
  if (!(square > 4 * (r * r) * own_squared)) return false;
  if (square > 2 * (r * r) * (own_squared + other) * up) return true;
  return least > r * (std::sqrt(own_squared) + std::sqrt(other)) * up;
}

// Returns h for the covector M h along which both ellipses together are farthest from w: with P and
// Q the inverses of the metrics, (P + Q)^-1 d, which is M h for h = (1 + Q M)^-1 d.
point between_both(const point& d, const metric_tensor& m, const inverse_bound& inverse) {
  const metric_tensor& b = inverse.tensor;
  const double factor = inverse.factor;
  const double a11 = 1 + factor * (b.m11 * m.m11 + b.m12 * m.m12),
               a12 = factor * (b.m11 * m.m12 + b.m12 * m.m22),
               a21 = factor * (b.m12 * m.m11 + b.m22 * m.m12),
               a22 = 1 + factor * (b.m12 * m.m12 + b.m22 * m.m22);
  const double scale = 1 / (a11 + a22);
  return {scale * (a22 * d.x - a12 * d.y), scale * (a11 * d.y - a21 * d.x)};
}

}  // namespace

bool is_too_far(const site& v, double reach, const site& w) {
  const point d{w.position.x - v.position.x, w.position.y - v.position.y};
  const metric_tensor& m = w.metric;
  const inverse_bound inverse{{m.m22, -m.m12, m.m11}, inverse_determinant_above(m)};
  if (!(reach < infinity)) return false;
  const separation plain = separation_along(d, d, v.metric, reach, inverse);
  return plain.least > 0 &&
         (plain.is_beyond(reach) ||
          separation_along(between_both(d, v.metric, inverse), d, v.metric, reach, inverse)
              .is_beyond(reach));
}

}  // namespace asterism::internal::audit_detail
