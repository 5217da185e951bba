// SPDX-License-Identifier: MIT
//
// Compares products beyond the range of doubles with 100 digits.
#include "asterism/mesh/support/wide_range.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "asterism/core/random.hpp"
#include "fixtures/audit_meshes.hpp"

using namespace asterism::internal;
using asterism::internal::splitmix64;
using number = boost::multiprecision::cpp_bin_float_100;

namespace {

double any_size(splitmix64& random) {
  const double mantissa = random.real(-2, 2);
  return std::ldexp(mantissa, static_cast<int>(random.real(-1000, 1000)));
}

}  // namespace

TEST_CASE("a determinant whose products leave the range of doubles, to the last place") {
  splitmix64 random(5);
  for (int k = 0; k < 20000; ++k) {
    const double a = any_size(random), b = any_size(random), c = any_size(random),
                 scale = any_size(random);
    const wide_range value = wide_range(a) * wide_range(c) - wide_range(b) * wide_range(b);
    const number exact = number(a) * c - number(b) * b;
    // Multiplied by another number they are in range again, as in an angle or a ratio.
    const auto shown = static_cast<double>(value / (wide_range(a) * wide_range(scale)));
    const number wanted = exact / (number(a) * scale);
    if (abs(wanted) > 1e300 || abs(wanted) < 1e-300) continue;
    CHECK(abs((shown - wanted) / wanted) < 1e-15);
  }
}

TEST_CASE("roots and pairs of numbers of any range") {
  splitmix64 random(6);
  for (int k = 0; k < 20000; ++k) {
    const double a = std::abs(any_size(random)), b = std::abs(any_size(random));
    const auto ratio = static_cast<double>(root(wide_range(a) * wide_range(b)) / wide_range(b));
    const number wanted = sqrt(number(a) * b) / b;
    if (wanted < 1e300 && wanted > 1e-300) CHECK(abs((ratio - wanted) / wanted) < 1e-15);
    const auto [first, second] = scaled(wide_range(a) * wide_range(a), wide_range(b));
    const number quotient = number(a) * a / b;
    CHECK(std::max(first, second) < 4);
    CHECK(std::max(first, second) >= 1);
    if (quotient < 1e300 && quotient > 1e-300 && first > 1e-300 && second > 1e-300)
      CHECK(abs((first / second - quotient) / quotient) < 1e-15);
  }
}

TEST_CASE("zero, cancellation and what is not finite") {
  CHECK(static_cast<double>(wide_range(0) * wide_range(1e300)) == 0);
  CHECK(static_cast<double>(wide_range(3) - wide_range(3)) == 0);
  CHECK(static_cast<double>(root(wide_range(-1))) == 0);
  CHECK(static_cast<double>(wide_range(0) + wide_range(2)) == 2);
  CHECK(std::isnan(static_cast<double>(wide_range(std::nan("")) * wide_range(1))));
  CHECK(std::isnan(static_cast<double>(root(wide_range(std::nan(""))))));
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_FALSE(std::isfinite(static_cast<double>(wide_range(infinity) + wide_range(1))));
  CHECK(static_cast<double>(wide_range(1e300) * wide_range(1e300)) == infinity);
}
