// SPDX-License-Identifier: MIT
//
// The search for a target with functions that grow, stay, jump, never meet it, or fail.
#include "asterism/mesh/numerics/target_search.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

using namespace asterism::internal;

namespace {

using quantity = std::function<double(double factor)>;

// Returns the number of measurements until the quantity is near its value at the factor 1; more
// than `most` if it never is.
int measurements(const quantity& q, double first_factor, double close, int most = 60,
                 double slowest = 0) {
  target_search search(slowest, std::log(first_factor));
  for (int count = 1; count <= most; ++count) {
    const double off = std::log(q(std::exp(search.at())) / q(1));
    if (std::abs(off) <= close) return count;
    search.take(off);
  }
  return most + 1;
}

}  // namespace

TEST_CASE("a quantity in proportion to the factor is met by the second measurement") {
  const quantity area = [](double f) { return 3 * f; };
  for (const double first : {1e-100, 1e-3, 1.1, 50.0, 1e100})
    CHECK(measurements(area, first, 1e-9) == 2);
  CHECK(measurements(area, 1, 1e-9) == 1);
}

TEST_CASE("quantities that grow otherwise are met in few measurements from afar") {
  for (const double first : {1e-5, 0.01, 0.3, 2.0, 100.0, 1e5}) {
    CAPTURE(first);
    CHECK(measurements([](double f) { return std::pow(f, 0.3); }, first, 0.005) <= 5);
    CHECK(measurements([](double f) { return f + 5 * std::sqrt(f); }, first, 0.005) <= 6);
    CHECK(measurements([](double f) { return f + f * std::sqrt(f); }, first, 0.005) <= 9);
    // A part that stays, of half and of nearly all at the target.
    CHECK(measurements([](double f) { return f + 1; }, first, 0.005) <= 10);
    CHECK(measurements([](double f) { return f + 50; }, first, 0.005) <= 11);
    // A bound that is nearly met at the target.
    CHECK(measurements([](double f) { return 1 / (0.95 + 0.05 / f); }, first, 0.005) <= 12);
  }
}

TEST_CASE("a target within a jump is enclosed, and the nearer side is known") {
  const double edge = 0.7;  // logarithm of the factor
  target_search search;
  double nearest = std::numeric_limits<double>::infinity();
  int count = 0;
  for (; search.width() > 1e-12 && count < 60; ++count) {
    const double off = search.at() < edge ? search.at() - edge - 0.1 : search.at() - edge + 0.4;
    const bool is_nearer = std::abs(off) < nearest;
    if (is_nearer) nearest = std::abs(off);
    CHECK(search.take(off) == is_nearer);
  }
  CHECK(count < 60);
  CHECK(search.at() == Approx(edge));
  CHECK(search.least_off() == nearest);
  CHECK(search.least_off() == Approx(0.1));
}

TEST_CASE("a quantity that stays short of its target is tried by factors of 16 and more") {
  for (const double off : {-0.5, 0.01}) {
    target_search search;
    double before = 0;
    int count = 0;
    for (; !search.is_saturated(); ++count) {
      REQUIRE(count < 60);
      before = search.at();
      search.take(off);
      CHECK((search.at() < before) == (off > 0));
      const double most = std::abs(off) + std::log(16) + 1e-12;
      CHECK(std::abs(search.at() - before) <= most);
      if (count > 0) CHECK(std::abs(search.at() - before) >= std::log(16));
    }
    CHECK(count == 7);
    CHECK(search.width() == std::numeric_limits<double>::infinity());
    CHECK(search.least_off() == std::abs(off));
  }
}

TEST_CASE("a limit that is approached and never met ends the search") {
  target_search search(0, 5);
  int count = 0;
  for (; !search.is_saturated() && count < 60; ++count)
    search.take(std::log(1.5 + std::exp(search.at())));
  CHECK(count < 25);
  CHECK(search.least_off() == Approx(std::log(1.5)));
}

TEST_CASE("slopes below the least one assumed lead no farther") {
  target_search search(0.25);
  search.take(0.1);
  CHECK(search.at() == -0.1);
  search.take(0.1);
  CHECK(search.at() == Approx(-0.5));
  // A quantity that decreased, as by chance, has the least slope too.
  search.take(0.2);
  CHECK(search.at() == Approx(-1.3));
}

TEST_CASE("a slope that is given takes the place of the line's") {
  // Newton's method for a convex function, from above.
  target_search search(0, 0.8);
  int count = 0;
  for (; count < 20; ++count) {
    const double at = search.at(), off = std::exp(at / 2) - 1;
    if (std::abs(off) < 1e-13) break;
    search.take(off, std::exp(at / 2) / 2);
    CHECK(search.at() == at - off / (std::exp(at / 2) / 2));
  }
  CHECK(count <= 6);
}

TEST_CASE("values without a number change nothing, and infinite ones give their side alone") {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  target_search search;
  CHECK_FALSE(search.take(nan));
  CHECK(search.at() == 0);
  CHECK(search.take(0.5));
  CHECK_FALSE(search.take(nan));
  CHECK(search.at() == -0.5);
  CHECK(search.least_off() == 0.5);

  target_search unbounded;
  CHECK_FALSE(unbounded.take(infinite));
  CHECK(unbounded.at() == Approx(-std::log(16)));
  unbounded.take(-1);
  CHECK(unbounded.width() == Approx(std::log(16)));
  CHECK((unbounded.at() > -std::log(16) && unbounded.at() < 0));
  CHECK(unbounded.least_off() == 1);
}
