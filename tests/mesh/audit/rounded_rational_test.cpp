// SPDX-License-Identifier: MIT
//
// Compares rationals, roots and cotangents that are rounded in integers with MPFR's.
#include "asterism/mesh/audit/rounded_rational.hpp"

#include <mpfr.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "asterism/mesh/audit/roots.hpp"
#include "asterism/tests/property/random_source.hpp"

#ifndef ASTERISM_EXACT_CPP_INT  // MPFR reads GMP's rationals

namespace asterism {
using namespace internal;
using namespace internal::audit_detail;
namespace {

mpfr_rnd_t mode(direction to) { return to == direction::up ? MPFR_RNDU : MPFR_RNDD; }

class mpfr_number {
 public:
  explicit mpfr_number(mpfr_prec_t bits) { mpfr_init2(value_, bits); }
  mpfr_number(const mpfr_number&) = delete;
  mpfr_number& operator=(const mpfr_number&) = delete;
  ~mpfr_number() { mpfr_clear(value_); }

  mpfr_ptr get() { return value_; }
  rational exactly() const {
    rational r;
    mpfr_get_q(r.backend().data(), value_);
    return r;
  }

 private:
  mpfr_t value_;
};

rational draw(property::random_source& random) {
  const auto whole = [&] {
    whole_number n = random.integer(1, 1000000);
    for (int k = random.integer(0, 8); k > 0; --k) n = n * random.integer(1, 1000000) + 1;
    return n << static_cast<unsigned>(random.integer(0, 600) * random.integer(0, 1));
  };
  return random.chance(5) ? rational(whole()) : rational(whole(), whole());
}

TEST_CASE("rationals and their roots are rounded as MPFR rounds them", "[audit]") {
  property::random_source random(3);
  for (int i = 0; i < 4000; ++i) {
    const rational q = random.chance(4) ? draw(random) : draw(random) * draw(random);
    for (const unsigned bits : {53U, 200U, 256U})
      for (const direction to : {direction::down, direction::up}) {
        mpfr_number number(bits);
        mpfr_set_q(number.get(), q.backend().data(), mode(to));
        const binary_number found = rounded(q, bits, to);
        CHECK(as_rational(found) == number.exactly());
        CHECK(as_double(found, to) == mpfr_get_d(number.get(), mode(to)));
        mpfr_sqrt(number.get(), number.get(), mode(to));
        CHECK(as_rational(rounded_root(found, bits, to)) == number.exactly());
      }
  }
}

TEST_CASE("rounded rationals at the ends of the range of doubles", "[audit]") {
  const rational tiny = rational(1, whole_number(1) << 1080U), least = rational(0x1p-1074),
                 huge = rational(std::numeric_limits<double>::max());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(double_above(tiny) == 0x1p-1074);
  CHECK(double_above(-tiny) == 0);
  CHECK(double_above(least) == 0x1p-1074);
  CHECK(double_above(least * 3 / 2) == 0x1p-1073);
  CHECK(double_above(huge) == std::numeric_limits<double>::max());
  CHECK(double_above(huge + 1) == infinity);
  CHECK(double_above(-huge - 1) == -std::numeric_limits<double>::max());
  CHECK(double_above(0) == 0);
  CHECK(double_above(rational(-1, 3)) == -std::nextafter(1.0 / 3, 0.0) - 0x1p-54);
  CHECK(root_rounded_up(tiny * tiny) == 0x1p-1074);
  CHECK(root_rounded_up(huge * huge * 4) == infinity);
  CHECK(root_rounded_up(rational(9, 4)) == 1.5);
  CHECK(root_above(0) == 0);
}

// The enclosure may exceed the value by 2^-190 of it on either side, the bound that the auditor
// states.
TEST_CASE("cotangents are enclosed, closely", "[audit]") {
  property::random_source random(4);
  for (int i = 0; i < 400; ++i) {
    const double degrees = i < 100   ? std::ldexp(random.real(0.5, 1), -random.integer(0, 1070))
                           : i < 110 ? 90 - (i - 99) * 0x1p-46
                                     : random.real(0, 90);
    CAPTURE(degrees);
    mpfr_number angle(4096);
    mpfr_const_pi(angle.get(), MPFR_RNDN);
    mpfr_mul_d(angle.get(), angle.get(), degrees, MPFR_RNDN);
    mpfr_div_ui(angle.get(), angle.get(), 180, MPFR_RNDN);
    mpfr_cot(angle.get(), angle.get(), MPFR_RNDN);
    mpfr_sqr(angle.get(), angle.get(), MPFR_RNDN);
    const rational exact = angle.exactly(), spare = exact / rational(whole_number(1) << 190U);
    const cotangent_bounds found = squared_cotangent_of(degrees);
    CHECK(found.low < exact);
    CHECK(exact < found.high);
    CHECK(exact - found.low < spare);
    CHECK(found.high - exact < spare);
  }
}

}  // namespace
}  // namespace asterism

#endif
