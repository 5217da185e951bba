// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/check_tolerance.hpp"

#include <algorithm>
#include <string>

#include "asterism/mesh/proof/number.hpp"
#include "asterism/mesh/proof/proof_words.hpp"

namespace asterism::internal {
namespace {

using namespace proof_detail;
using integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

// Returns a fraction that is at most exp(x), and less by at most 2^-100 of exp(x) for x up to 2000:
// the sum of the series of positive terms, each rounded down to a multiple of 2^-192.
rational exponential_below(const rational& x) {
  const integer top = numerator(x), bottom = denominator(x), one = integer(1) << 192;
  integer total = one, term = one;
  for (unsigned k = 1; term > 0; ++k) {
    term = term * top / (bottom * k);
    total += term;
  }
  return rational(total, one);
}

// True if no length in `b` exceeds the root of `factor` times the length in `a`: the tensor factor
// a - b is positive semidefinite.
bool is_within(const tensor<rational>& a, const tensor<rational>& b, const rational& factor) {
  const rational m11 = factor * a.m11 - b.m11, m12 = factor * a.m12 - b.m12,
                 m22 = factor * a.m22 - b.m22;
  return m11 >= 0 && m22 >= 0 && m11 * m22 >= m12 * m12;
}

}  // namespace

std::optional<error> check_tolerance(const mesh& delivered, const mesh& wanted, double tolerance) {
  if (delivered.sites.size() != wanted.sites.size())
    return not_shown("the metric asked for is of another number of vertices");
  // No two tensors of doubles differ by more than a factor of exp(2000).
  const rational factor = exponential_below(rational(2 * std::min(tolerance, 1000.0)));
  for (std::size_t v = 0; v < delivered.sites.size(); ++v) {
    const metric_tensor &own = delivered.sites[v].metric, &asked = wanted.sites[v].metric;
    if (own == asked) continue;
    const tensor<rational> a(own), b(asked);
    if (!is_within(a, b, factor) || !is_within(b, a, factor))
      return not_shown("the metric of " + vertex_number(v) +
                       " is farther than the tolerance from the one asked for");
  }
  return std::nullopt;
}

}  // namespace asterism::internal
