// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/quick_logarithm.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "asterism/core/elementary.hpp"

namespace {

using namespace asterism::internal;

TEST_CASE("Quick logarithms and exponentials are off by no more than they say") {
  double worst_log = 0, worst_exp = 0;
  constexpr int steps = 20'000;
  for (int i = 0; i <= steps; ++i) {
    const double power = -300.0 + 600.0 * i / steps;
    const double x = elementary::exp(power);
    worst_log = std::max(worst_log, std::abs(quick_log(x) - elementary::log(x)) /
                                        std::max(1.0, std::abs(elementary::log(x))));
    worst_exp = std::max(worst_exp, std::abs(quick_exp(power) / x - 1));
    // Values near 1 have a small logarithm.
    const double near = 0.5 + 1.5 * i / steps;
    worst_log = std::max(worst_log, std::abs(quick_log(near) - elementary::log(near)));
  }
  CHECK(worst_log < 1e-13);
  CHECK(worst_exp < 1e-13);
}

TEST_CASE("The terms that quick series leave out are below what is said") {
  const double s = (std::numbers::sqrt2 - 1) / (std::numbers::sqrt2 + 1);
  CHECK(s < 0.1716);
  CHECK(2 * std::pow(s, 17) / 16 < 1.3e-14);
  const double r = std::numbers::ln2 / 2;
  CHECK(r < 0.347);
  double factorial = 1;
  for (int i = 2; i <= 12; ++i) factorial *= i;
  CHECK(2 * std::pow(0.347, 12) / factorial < 1.3e-14);
}

TEST_CASE("Quick logarithms answer special arguments as the others do") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(quick_log(0) == -infinity);
  CHECK(quick_log(infinity) == infinity);
  CHECK(std::isnan(quick_log(-1)));
  CHECK(quick_log(0x1p-1060) == elementary::log(0x1p-1060));
  CHECK(quick_exp(infinity) == infinity);
  CHECK(quick_exp(-infinity) == 0);
  CHECK(std::isnan(quick_exp(std::nan(""))));
  CHECK(quick_exp(0) == 1);
  CHECK(quick_log(1) == 0);
}

}  // namespace
