// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/real_roots.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asterism::internal {
namespace {

// Returns a root of p, which has a sign change in [low, high]: about one step a bit, from the
// Cauchy bound down. 200 steps leave 2^-200 of that, less than the last bit of any root that
// differs from zero noticeably.
double bisect(const std::vector<double>& p, double low, double high) {
  constexpr int most_steps = 200;
  const bool low_negative = evaluate(p, low) < 0;
  for (int step = 0; step < most_steps; ++step) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    ((evaluate(p, middle) < 0) == low_negative ? low : high) = middle;
  }
  return low;
}

std::vector<double> derivative(const std::vector<double>& p) {
  std::vector<double> d;
  for (std::size_t i = 1; i < p.size(); ++i) d.push_back(static_cast<double>(i) * p[i]);
  return d;
}

// True if p at its critical point is small relative to the terms of its sum: a double root may be
// there. A double root that rounding lifted off zero by a few 2^-52 of the terms passes this test
// by far. A place without a root costs a few steps of Newton's method, which refuses it.
bool nearly_zero(const std::vector<double>& p, double at) {
  constexpr double part = 1e-9;
  double magnitude = 0, power = 1;
  for (const double c : p) {
    magnitude += std::abs(c * power);
    power *= at;
  }
  return std::abs(evaluate(p, at)) <= part * magnitude;
}

}  // namespace

double evaluate(const std::vector<double>& p, double at) {
  double value = 0;
  for (std::size_t i = p.size(); i-- > 0;) value = value * at + p[i];
  return value;
}

std::vector<double> real_roots(std::vector<double> p) {
  double largest = 0;
  for (const double c : p) largest = std::max(largest, std::abs(c));
  if (!std::isfinite(largest) || largest == 0) return {};
  // Relative size, 45 roundings, below which a leading coefficient is taken as zero: rounding
  // leaves coefficients of this size where the leading terms of a resultant cancel and a root is at
  // infinity.
  constexpr double noise = 1e-14;
  while (std::abs(p.back()) <= noise * largest) p.pop_back();
  if (p.size() <= 1) return {};
  if (p.size() == 2) return {-p[0] / p[1]};

  double bound = 0;  // Cauchy: all roots lie within 1 + max |p_i / p_n|
  for (const double c : p) bound = std::max(bound, std::abs(c / p.back()));
  std::vector<double> cuts = real_roots(derivative(p)), roots;
  cuts.insert(cuts.begin(), -1 - bound);
  cuts.push_back(1 + bound);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (i > 0 && nearly_zero(p, cuts[i])) roots.push_back(cuts[i]);
    if ((evaluate(p, cuts[i]) < 0) != (evaluate(p, cuts[i + 1]) < 0))
      roots.push_back(bisect(p, cuts[i], cuts[i + 1]));
  }
  return roots;
}

std::vector<double> quadratic_roots(double a, double b, double c) {
  if (a == 0) return b == 0 ? std::vector<double>{} : std::vector<double>{-c / b};
  const double discriminant = b * b - 4 * a * c;
  if (!(discriminant >= 0)) return {};
  const double sum = -b - std::copysign(std::sqrt(discriminant), b);  // no cancellation
  if (sum == 0) return {0.0};
  std::vector<double> roots{sum / (2 * a), 2 * c / sum};
  if (roots[0] > roots[1]) std::swap(roots[0], roots[1]);
  if (roots[0] == roots[1]) roots.pop_back();
  return roots;
}

}  // namespace asterism::internal
