// SPDX-License-Identifier: MIT
//
// The project's elementary functions against MPFR, and some of their bits, which are the same on
// every machine.
#include "asterism/core/elementary.hpp"

#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace asterism::internal {
namespace {

// Draws numbers by the generator splitmix64.
class generator {
 public:
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
  }
  // Returns a number of any size between 2^low and 2^high, of either sign.
  double of_any_size(double low, double high) {
    const double mantissa = between(1, 2);  // drawn first: arguments have no order
    const double size = std::ldexp(mantissa, static_cast<int>(between(low, high)));
    return next() % 2 == 0 ? size : -size;
  }

 private:
  std::uint64_t state_ = 42;
};

using exact_function = std::function<void(mpfr_ptr, mpfr_srcptr, mpfr_srcptr)>;

// Returns the distance of `value` from the exact result, in units in the last place.
double units_off(double value, double x, double y, const exact_function& exact) {
  mpfr_t a, b, r;
  mpfr_inits2(400, a, b, r, static_cast<mpfr_ptr>(nullptr));
  mpfr_set_d(a, x, MPFR_RNDN);
  mpfr_set_d(b, y, MPFR_RNDN);
  exact(r, a, b);
  const double nearest = mpfr_get_d(r, MPFR_RNDN);
  double off = std::numeric_limits<double>::infinity();
  if (std::isnan(nearest) || std::isinf(nearest)) {
    if (std::isnan(nearest) ? std::isnan(value) : value == nearest) off = 0;
  } else if (std::isfinite(value)) {
    const int exponent = nearest == 0 ? -1074 : std::max(std::ilogb(nearest) - 52, -1074);
    mpfr_sub_d(r, r, value, MPFR_RNDN);
    mpfr_mul_2si(r, r, -exponent, MPFR_RNDN);
    off = std::abs(mpfr_get_d(r, MPFR_RNDN));
  }
  mpfr_clears(a, b, r, static_cast<mpfr_ptr>(nullptr));
  return off;
}

struct worst_case {
  double off = 0, x = 0, y = 0;
  void take(double value, double at_x, double at_y, const exact_function& exact) {
    const double units = units_off(value, at_x, at_y, exact);
    if (units > off) *this = {units, at_x, at_y};
  }
};

#define ASTERISM_EXACT(function) \
  [](mpfr_ptr r, mpfr_srcptr a, mpfr_srcptr) { function(r, a, MPFR_RNDN); }

void expect_within(const worst_case& worst, double most, const std::string& name) {
  INFO(name << " at " << worst.x << ", " << worst.y << " is off by " << worst.off << " units");
  CHECK(worst.off <= most);
}

constexpr int cases = 20000;

}  // namespace

TEST_CASE("logarithms and exponentials are within their bounds") {
  generator random;
  worst_case log, log2, log10, exp, exp2, tanh;
  for (int k = 0; k < cases; ++k) {
    const double any = std::abs(random.of_any_size(-1074, 1024));
    const double near_one = random.between(0.5, 2);
    for (const double x : {any, near_one, 1 + random.of_any_size(-52, -4)}) {
      log.take(elementary::log(x), x, 0, ASTERISM_EXACT(mpfr_log));
      log2.take(elementary::log2(x), x, 0, ASTERISM_EXACT(mpfr_log2));
      log10.take(elementary::log10(x), x, 0, ASTERISM_EXACT(mpfr_log10));
    }
    for (const double x :
         {random.between(-708, 709), random.between(-1, 1), random.of_any_size(-60, 8)}) {
      exp.take(elementary::exp(x), x, 0, ASTERISM_EXACT(mpfr_exp));
      exp2.take(elementary::exp2(x), x, 0, ASTERISM_EXACT(mpfr_exp2));
    }
    const double t = random.of_any_size(-40, 5);
    tanh.take(elementary::tanh(t), t, 0, ASTERISM_EXACT(mpfr_tanh));
  }
  expect_within(log, 0.6, "log");
  expect_within(log2, 1, "log2");
  expect_within(log10, 0.6, "log10");
  expect_within(exp, 0.65, "exp");
  expect_within(exp2, 0.65, "exp2");
  expect_within(tanh, 6, "tanh");
  worst_case subnormal;
  for (int k = 0; k < 4000; ++k) {
    const double x = random.between(-745.2, -708);
    subnormal.take(elementary::exp(x), x, 0, ASTERISM_EXACT(mpfr_exp));
  }
  expect_within(subnormal, 1.6, "exp, subnormal");
}

TEST_CASE("powers are within their bounds") {
  generator random;
  const exact_function exact = [](mpfr_ptr r, mpfr_srcptr a, mpfr_srcptr b) {
    mpfr_pow(r, a, b, MPFR_RNDN);
  };
  worst_case usual, any, whole, subnormal;
  for (int k = 0; k < cases; ++k) {
    const double x = std::abs(random.of_any_size(-20, 20)), log = std::abs(std::log2(x));
    const double y = random.between(-64, 64) / std::max(log, 1e-3);
    usual.take(elementary::pow(x, y), x, y, exact);
    const double wide = random.between(-1022, 1023) / std::max(log, 1e-3);
    any.take(elementary::pow(x, wide), x, wide, exact);
    const double n = std::round(random.between(-12, 12)), base = random.between(-30, 30);
    whole.take(elementary::pow(base, n), base, n, exact);
    const double low = random.between(-1075, -1022) / std::log2(2 + x);
    subnormal.take(elementary::pow(2 + x, low), 2 + x, low, exact);
  }
  expect_within(usual, 1.5, "pow");
  expect_within(any, 20, "pow, far");
  expect_within(whole, 0.6, "pow, of whole numbers");
  expect_within(subnormal, 21, "pow, subnormal");
}

TEST_CASE("powers that are doubles are exact") {
  for (int k = -1074; k < 1024; ++k) CHECK(elementary::pow(2, k) == std::ldexp(1.0, k));
  CHECK(elementary::pow(0.5, 1074) == 0x1p-1074);
  CHECK(elementary::pow(-2, 1023) == -0x1p1023);
  CHECK(elementary::pow(10, 22) == 1e22);
  CHECK(elementary::pow(3, 33) == 5559060566555523.0);
  CHECK(elementary::pow(2.25, 0.5) == 1.5);
  CHECK(elementary::pow(-1.5, 3) == -3.375);
}

TEST_CASE("special powers are those of the C library") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> some = {0.0, 0.3, 0.5,   1.0,       2.0,      3.0, 4.0,    5.0,
                                    6.5, 1e9, 1e300, 0x1p-1074, infinity, nan, 0x1p52, 0x1p53};
  for (const double a : some)
    for (const double b : some)
      for (const double x : {a, -a})
        for (const double y : {b, -b}) {
          const double wanted = std::pow(x, y), got = elementary::pow(x, y);
          INFO(x << " ^ " << y << ": " << wanted << " " << got);
          if (std::isnan(wanted)) {
            CHECK(std::isnan(got));
          } else if (std::isinf(wanted) || wanted == 0) {
            CHECK((got == wanted && std::signbit(got) == std::signbit(wanted)));
          } else {
            CHECK(std::abs(got - wanted) <= 1e-14 * std::abs(wanted));
          }
        }
}

TEST_CASE("circular functions are within their bounds, however large the argument") {
  generator random;
  worst_case sin, cos, tan, atan2, hypot;
  for (int k = 0; k < cases; ++k) {
    // Next to multiples of pi / 2 the reduction of the argument cancels most digits.
    const double multiple = std::round(random.between(-3e5, 3e5)) * 1.5707963267948966;
    for (const double x : {random.between(-7, 7), random.of_any_size(-30, 20), multiple,
                           random.of_any_size(19, 1023)}) {
      sin.take(elementary::sin(x), x, 0, ASTERISM_EXACT(mpfr_sin));
      cos.take(elementary::cos(x), x, 0, ASTERISM_EXACT(mpfr_cos));
      tan.take(elementary::tan(x), x, 0, ASTERISM_EXACT(mpfr_tan));
    }
    const double size = random.of_any_size(-1000, 1000), share = random.of_any_size(-40, 20);
    for (const auto& [y, x] : {std::pair{size, size * random.between(-2, 2)},
                               {size, size * share},
                               {random.between(-1, 1), random.between(-1, 1)}}) {
      if (!std::isfinite(x) || (x == 0 && y == 0)) continue;
      atan2.take(elementary::atan2(y, x), y, x,
                 [](mpfr_ptr r, mpfr_srcptr a, mpfr_srcptr b) { mpfr_atan2(r, a, b, MPFR_RNDN); });
      hypot.take(elementary::hypot(y, x), y, x,
                 [](mpfr_ptr r, mpfr_srcptr a, mpfr_srcptr b) { mpfr_hypot(r, a, b, MPFR_RNDN); });
    }
  }
  expect_within(sin, 0.85, "sin");
  expect_within(cos, 0.85, "cos");
  expect_within(tan, 1.6, "tan");
  expect_within(atan2, 0.6, "atan2");
  expect_within(hypot, 0.6, "hypot");
}

TEST_CASE("the double nearest to a multiple of pi / 2 of all keeps its digits") {
  const double x = 0x1.6ac5b262ca1ffp+849;  // 6381956970095103 2^797
  CHECK(units_off(elementary::cos(x), x, 0, ASTERISM_EXACT(mpfr_cos)) <= 0.85);
  CHECK(std::abs(elementary::cos(x)) < 1e-18);
}

TEST_CASE("special arguments are answered as by the C library") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(elementary::log(0) == -infinity);
  CHECK(elementary::log(1) == 0);
  CHECK(elementary::log(infinity) == infinity);
  CHECK(std::isnan(elementary::log(-1)));
  CHECK(std::isnan(elementary::log2(nan)));
  CHECK(elementary::exp(0) == 1);
  CHECK(elementary::exp(infinity) == infinity);
  CHECK(elementary::exp(-infinity) == 0);
  CHECK(elementary::exp(709.79) == infinity);
  CHECK(elementary::exp(-746) == 0);
  CHECK(std::isnan(elementary::exp(nan)));
  CHECK(elementary::exp2(-1074) == 0x1p-1074);
  CHECK(elementary::exp2(1023) == 0x1p1023);
  CHECK(elementary::exp2(1024) == infinity);
  CHECK(elementary::log10(1000) == 3);
  CHECK(elementary::log10(1e22) == 22);
  for (int k = -1074; k < 1024; ++k) {
    CHECK(elementary::log2(std::ldexp(1.0, k)) == k);
    CHECK(elementary::exp2(k) == std::ldexp(1.0, k));
  }
  CHECK(std::isnan(elementary::sin(infinity)));
  CHECK(std::signbit(elementary::sin(-0.0)));
  CHECK(std::signbit(elementary::tan(-0.0)));
  CHECK(elementary::cos(0) == 1);
  CHECK(elementary::tanh(1000) == 1);
  CHECK(elementary::tanh(-1000) == -1);
  for (const double y : {0.0, -0.0, 1.0, -1.0, infinity, -infinity})
    for (const double x : {0.0, -0.0, 1.0, -1.0, infinity, -infinity}) {
      INFO(y << " " << x);
      CHECK(elementary::atan2(y, x) == std::atan2(y, x));
      CHECK(std::signbit(elementary::atan2(y, x)) == std::signbit(std::atan2(y, x)));
      CHECK(elementary::hypot(y, x) == std::hypot(y, x));
    }
  CHECK(elementary::atan2(0x1p-1074, 1) == 0x1p-1074);
  CHECK(elementary::hypot(3, 4) == 5);
  CHECK(elementary::hypot(0x1p1023, 0x1p1023) == 0x1.6a09e667f3bcdp1023);
  CHECK(elementary::hypot(3 * 0x1p-1074, 4 * 0x1p-1074) == 5 * 0x1p-1074);
}

TEST_CASE("elementary functions return the same bits everywhere") {
  // Computes one number from many results, which must be the same on every machine.
  generator random;
  std::uint64_t all = 0;
  const auto add = [&](double value) {
    all = all * 0x100000001b3U + std::bit_cast<std::uint64_t>(value);
  };
  for (int k = 0; k < 20000; ++k) {
    const double x = random.of_any_size(-20, 9), y = random.of_any_size(-20, 9);
    add(elementary::log(std::abs(x)));
    add(elementary::log2(std::abs(x)));
    add(elementary::exp(x));
    add(elementary::exp2(x));
    add(elementary::sin(x));
    add(elementary::cos(x));
    add(elementary::tan(x));
    add(elementary::tanh(x));
    add(elementary::atan2(y, x));
    add(elementary::hypot(x, y));
    add(elementary::sin(random.of_any_size(20, 1000)));
    add(elementary::pow(std::abs(x), y / 9));
  }
  CHECK(all == 0xe644244458b51fc);
}

}  // namespace asterism::internal
