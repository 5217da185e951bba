// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/metric_algebra.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/quick_logarithm.hpp"
#include "asterism/mesh/numerics/scaled_tensor.hpp"

namespace asterism::internal {

namespace {

int exponent_of(const metric_tensor& m) { return std::ilogb(std::max(m.m11, m.m22)); }

// True if products of two entries of the tensor neither overflow nor vanish.
bool moderate(const metric_tensor& m) {
  return std::max(m.m11, m.m22) < 0x1p400 && std::min(m.m11, m.m22) > 0x1p-400;
}

// Returns ab - cd with an error of two units in the last place of the result (Kahan): the weak
// eigenvalue of a thin tensor is its determinant over the strong one, and cancels.
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

double determinant(const metric_tensor& m) {
  return difference_of_products(m.m11, m.m22, m.m12, m.m12);
}

// Eigenvalues and directions of a symmetric matrix: high n n^T + low t t^T, with n = (c, s) and t
// at right angles.
struct decomposition {
  double high, low, c, s;
};

decomposition decompose(double m11, double m12, double m22) {
  const double half = (m11 - m22) / 2, radius = std::sqrt(half * half + m12 * m12),
               mean = (m11 + m22) / 2;
  // Takes the longer column of M - low I, which is (high - low) n n^T.
  double c = half >= 0 ? half + radius : m12, s = half >= 0 ? m12 : radius - half;
  const double length = std::sqrt(c * c + s * s);
  if (length > 0) {
    c /= length;
    s /= length;
  } else {
    c = 1;
    s = 0;
  }
  return {mean + radius, mean - radius, c, s};
}

template <class Exp>
metric_tensor exponential_by(const Exp& exp, const tensor_logarithm& l) {
  // Raises a weak eigenvalue that may come out negative: entries have errors of three roundings, so
  // that of the determinant is at most 2^-51 of the square of the strong eigenvalue.
  constexpr double thinnest = 0x1p-48;
  const decomposition d = decompose(l.l11, l.l12, l.l22);
  const double high = exp(d.high), low = std::max(exp(d.low), high * thinnest);
  return {high * (d.c * d.c) + low * (d.s * d.s), (high - low) * (d.c * d.s),
          high * (d.s * d.s) + low * (d.c * d.c)};
}

}  // namespace

tensor_logarithm logarithm(const metric_tensor& m) {
  const int exponent = exponent_of(m);
  const metric_tensor unit = times_power_of_two(m, -exponent);
  const decomposition d = decompose(unit.m11, unit.m12, unit.m22);
  // Replaces a determinant that rounding made vanish by the least one that a double can hold here.
  const double low = std::max(determinant(unit) / d.high, std::numeric_limits<double>::min());
  const double shift = exponent * std::numbers::ln2;
  const double high_log = elementary::log(d.high) + shift, low_log = elementary::log(low) + shift;
  const double step = high_log - low_log;
  return {low_log + step * (d.c * d.c), step * (d.c * d.s), low_log + step * (d.s * d.s)};
}

metric_tensor exponential(const tensor_logarithm& l) { return exponential_by(elementary::exp, l); }

metric_tensor quick_exponential(const tensor_logarithm& l) { return exponential_by(quick_exp, l); }

double difference(const tensor_logarithm& a, const tensor_logarithm& b) {
  const decomposition d = decompose(a.l11 - b.l11, a.l12 - b.l12, a.l22 - b.l22);
  return std::max(std::abs(d.high), std::abs(d.low));
}

bool exceeds(const metric_tensor& b, const metric_tensor& a, double slack) {
  if (!moderate(a) || !moderate(b)) {
    const int exponent = -std::max(exponent_of(a), exponent_of(b));
    const metric_tensor s = times_power_of_two(a, exponent), t = times_power_of_two(b, exponent);
    if (moderate(s) && moderate(t)) return exceeds(t, s, slack);
  }
  const double f = 1 + slack;
  const metric_tensor d{f * a.m11 - b.m11, f * a.m12 - b.m12, f * a.m22 - b.m22};
  return d.m11 < 0 || d.m22 < 0 || determinant(d) < 0;
}

metric_tensor intersection(const metric_tensor& a, const metric_tensor& b) {
  const int exponent = std::max(exponent_of(a), exponent_of(b));
  const metric_tensor s = times_power_of_two(a, -exponent), t = times_power_of_two(b, -exponent);
  const decomposition da = decompose(s.m11, s.m12, s.m22), db = decompose(t.m11, t.m12, t.m22);
  const bool first = da.high >= db.high;
  const metric_tensor &strong = first ? s : t, &weak = first ? t : s;
  const decomposition& d = first ? da : db;
  // Computes the least x for which `strong` covers `weak`, written in the eigenvectors of `strong`.
  // Adding x to the weak eigenvalue of `strong` is enough if the difference is then positive
  // semidefinite: (high - nn) (low + x - tt) >= nt^2.
  const double nn = d.c * d.c * weak.m11 + 2 * d.c * d.s * weak.m12 + d.s * d.s * weak.m22;
  const double tt = d.s * d.s * weak.m11 - 2 * d.c * d.s * weak.m12 + d.c * d.c * weak.m22;
  const double nt = d.c * d.s * (weak.m22 - weak.m11) + (d.c * d.c - d.s * d.s) * weak.m12;
  const double gap = d.high - nn;
  const double enough = gap > 0 ? tt + nt * (nt / gap) : nt == 0 ? tt : d.high;
  const double more = std::min(enough, d.high) - determinant(strong) / d.high;
  if (!(more > 0)) return first ? a : b;
  return times_power_of_two({strong.m11 + more * (d.s * d.s), strong.m12 - more * (d.c * d.s),
                             strong.m22 + more * (d.c * d.c)},
                            exponent);
}

metric_tensor turned(const metric_tensor& t, double cosine, double sine) {
  const double c = cosine, s = sine;
  return {c * c * t.m11 - 2 * (c * s) * t.m12 + s * s * t.m22,
          c * s * (t.m11 - t.m22) + (c * c - s * s) * t.m12,
          s * s * t.m11 + 2 * (c * s) * t.m12 + c * c * t.m22};
}

double density_ratio(const metric_tensor& b, const metric_tensor& a) {
  const int p = exponent_of(b), q = exponent_of(a);
  const double ratio =
      std::sqrt(determinant(times_power_of_two(b, -p)) / determinant(times_power_of_two(a, -q)));
  return std::ldexp(ratio, p - q);
}

unit_displacements unit_circle(const metric_tensor& m) {
  const int exponent = exponent_of(m);
  // Makes the exponent even, so that half of it scales lengths.
  const int even = exponent - exponent % 2;
  const metric_tensor s = times_power_of_two(m, -even);
  const double x = 1 / std::sqrt(s.m11);
  const double least = std::numeric_limits<double>::min();
  const double y = 1 / std::sqrt(std::max(determinant(s) / s.m11, least));
  const double back = std::ldexp(1.0, -even / 2);
  return {{back * x, 0}, {back * (-(s.m12 / s.m11) * y), back * y}};
}

}  // namespace asterism::internal
