// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/roots.hpp"

#include <mpfr.h>

#include <algorithm>
#include <cmath>

namespace asterism::internal::audit_detail {
namespace {

constexpr mpfr_prec_t bits_of_roots = 200;

rational root_towards(const rational& square, mpfr_rnd_t direction) {
  mpfr_t value;
  mpfr_init2(value, bits_of_roots);
  mpfr_set_q(value, square.backend().data(), direction);
  mpfr_sqrt(value, value, direction);
  rational root;
  mpfr_get_q(root.backend().data(), value);
  mpfr_clear(value);
  return root;
}

}  // namespace

rational root_above(const rational& square) { return root_towards(square, MPFR_RNDU); }
rational root_below(const rational& square) { return root_towards(square, MPFR_RNDD); }

double double_above(const rational& number) {
  mpfr_t value;
  mpfr_init2(value, 53);
  mpfr_set_q(value, number.backend().data(), MPFR_RNDU);
  const double result = mpfr_get_d(value, MPFR_RNDU);
  mpfr_clear(value);
  return result;
}

double root_rounded_up(const rational& square) {
  mpfr_t value;
  mpfr_init2(value, 53);
  mpfr_set_q(value, square.backend().data(), MPFR_RNDU);
  mpfr_sqrt(value, value, MPFR_RNDU);
  const double result = mpfr_get_d(value, MPFR_RNDU);
  mpfr_clear(value);
  return result;
}

double unit_in_last_place(double size) {
  constexpr int least = -1074;
  return size > 0 ? std::ldexp(1.0, std::max(std::ilogb(size) - 52, least)) : 0x1p-1074;
}

}  // namespace asterism::internal::audit_detail
