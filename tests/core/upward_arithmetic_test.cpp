// SPDX-License-Identifier: MIT
//
// Compares upward rounding by arithmetic that rounds to nearest with the processor's own upward
// rounding: the same double for all pairs of special numbers, and for random numbers of all sizes.
#include "asterism/core/upward_arithmetic.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/core/two_lanes.hpp"
#include "asterism/tests/property/random_source.hpp"

static_assert(ASTERISM_DIRECTED_ROUNDING, "compares with the processor's rounding upward");

namespace asterism {
using namespace internal;
namespace {

using property::random_source;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();
constexpr double least_normal = std::numeric_limits<double>::min();

struct results {
  double sum, product, quotient, root;
};

[[gnu::noinline]] results of_processor(double a, double b) {
  const floating_point_scope scope(rounding::upward);
  return {rounded_sum(a, b), rounded_product(a, b), rounded_quotient(a, b), rounded_root(a)};
}

[[gnu::noinline]] results of_nearest(double a, double b) {
  const floating_point_scope scope(rounding::nearest);
  return {upward::sum(a, b), upward::product(a, b), upward::quotient(a, b), upward::root(a)};
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// Returns 1, the number of pairs compared: a check of the test framework for each pair would take
// most of the time.
std::size_t check(double a, double b) {
  const results expected = of_processor(a, b), found = of_nearest(a, b);
  const bool alike = same(expected.sum, found.sum) && same(expected.product, found.product) &&
                     same(expected.quotient, found.quotient) && same(expected.root, found.root);
  if (alike) return 1;
  CAPTURE(a, b, expected.sum, found.sum, expected.product, found.product, expected.quotient,
          found.quotient, expected.root, found.root);
  CHECK(alike);
  return 1;
}

std::vector<double> special_numbers() {
  std::vector<double> found = {infinity, std::numeric_limits<double>::quiet_NaN()};
  for (const double x :
       {0.0,      1.0,      0.1,       3.0,          1.5,     0x1p-537,    0x1p-538,
        0x1p-511, 0x1p-512, 0x1p511,   0x1p512,      0x1p53,  0x1p54,      0x1p-53,
        0x1p-54,  least,    3 * least, least_normal, largest, 0x1.8p-1040, 0x1p-969,
        0x1p-970, 0x1p-971, 0x1p-1021, 0x1p970,      0x1p971, 0x1p1023})
    for (const double y : {std::nextafter(x, -1.0), x, std::nextafter(x, infinity)})
      found.push_back(y);
  const std::size_t count = found.size();
  for (std::size_t k = 0; k < count; ++k) found.push_back(-found[k]);
  return found;
}

TEST_CASE("rounding upward by arithmetic to nearest: special numbers", "[upward]") {
  const std::vector<double> numbers = special_numbers();
  std::size_t compared = 0;
  for (const double a : numbers)
    for (const double b : numbers) compared += check(a, b);
  CHECK(compared == numbers.size() * numbers.size());
}

// Draws numbers of every kind: uniform bit patterns, mantissas of few bits (exact results and ties
// of rounding), and exponents near each other (sums whose operands overlap).
TEST_CASE("rounding upward by arithmetic to nearest: random numbers", "[upward]") {
  random_source random(45);
  const auto any = [&] {
    const auto half = [&] { return static_cast<std::uint64_t>(random.integer(0, 0x7FFFFFFF)); };
    const std::uint64_t bits = (half() << 33) ^ (half() << 16) ^ half();
    return __builtin_bit_cast(double, bits);
  };
  const auto short_one = [&] {
    return std::ldexp(random.integer(-4096, 4096), random.integer(-600, 600));
  };
  const auto near_one = [&] { return std::ldexp(random.real(-1, 1), random.integer(-60, 60)); };
  std::size_t compared = 0;
  for (int i = 0; i < 200000; ++i) {
    compared += check(any(), any());
    compared += check(short_one(), short_one());
    compared += check(near_one(), near_one());
    const double whole = random.integer(-100000, 100000);
    compared += check(whole * whole, whole);
    // Adds products in the range of subnormal numbers, and products that overflow.
    compared += check(std::ldexp(near_one(), -520), std::ldexp(near_one(), -520));
    compared += check(std::ldexp(near_one(), 500), std::ldexp(near_one(), 500));
  }
  CHECK(compared == 1200000);
}

}  // namespace
}  // namespace asterism
