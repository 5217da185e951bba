// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/covectors.hpp"

#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal::audit_detail {

using roundings::step;
using roundings::up;

// The roundings of both products and of their difference, and underflow in the range that is
// checked, are less than 2^-50 of the sum of the products.
double determinant_below(const metric_tensor& m) {
  const double product = m.m11 * m.m22, square = m.m12 * m.m12;
  const double below = product - square - 0x1p-50 * (product + square);
  return below > 0x1p-900 && product < 0x1p1000 ? below : 0;
}

double inverse_determinant_above(const metric_tensor& m) {
  const double below = determinant_below(m);
  return below > 0x1p-200 ? 1 / below * up : infinity;
}

// |g|^2 in M is the adjugate's value times the inverse determinant. The three monomials of the
// adjugate's value pass two roundings each. Underflow loses less than the number that is added,
// which makes squares infinite, too, where the inverse determinant is.
by_covector squared_lengths(const metric_tensor& m, double inverse_determinant) {
  const double sum = m.m11 + m.m22, mixed = 2 * m.m12;
  const two_doubles lost = both(step * sum + 0x1p-300), factor = both(inverse_determinant);
  return {(pair(m.m22, m.m11) + lost) * factor, (pair(sum - mixed, sum + mixed) + lost) * factor};
}

// Adds what keeps a square from underflow.
by_covector roots_above(const by_covector& squares) {
  const auto root = [](double square) { return std::sqrt(square + 0x1p-900) * (up * up); };
  const auto& [a, d] = squares;
  return {pair(root(a[0]), root(a[1])), pair(root(d[0]), root(d[1]))};
}

}  // namespace asterism::internal::audit_detail
