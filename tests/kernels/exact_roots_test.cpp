// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <vector>

#include "asterism/kernels/root_line.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::exact;

namespace {

dense_polynomial make(std::vector<int> coefficients) {
  std::vector<dyadic> c(coefficients.begin(), coefficients.end());
  return dense_polynomial(std::move(c));
}

}  // namespace

TEST_CASE("distinct real roots are isolated whatever their multiplicity", "[roots]") {
  CHECK(isolate_real_roots(make({1, 0, 1})).empty());             // x^2 + 1
  CHECK(isolate_real_roots(make({-2, 0, 1})).size() == 2);        // x^2 - 2
  CHECK(isolate_real_roots(make({0, 0, 0, 0, 1})).size() == 1);   // x^4
  CHECK(isolate_real_roots(make({1, 0, -2, 0, 1})).size() == 2);  // (x^2 - 1)^2
  CHECK(isolate_real_roots(make({24, -50, 35, -10, 1})).size() == 4);
  CHECK(isolate_real_roots(make({7})).empty());
}

TEST_CASE("roots that differ by 2^-200 are told apart, equal ones are not", "[roots]") {
  // (x - 1)^2 - 2^-400 has roots 1 +- 2^-200.
  const dense_polynomial close({dyadic(1) - dyadic(1).scaled(-400), dyadic(-2), dyadic(1)});
  auto roots = isolate_real_roots(close);
  REQUIRE(roots.size() == 2);
  CHECK(compare(roots[0], roots[1]) == sign::negative);
  auto one = isolate_real_roots(make({-1, 1}));
  CHECK(compare(roots[0], one[0]) == sign::negative);
  CHECK(compare(roots[1], one[0]) == sign::positive);
  // sqrt 2 as a root of x^2 - 2 and of (x^2 - 2)(x - 1)
  auto a = isolate_real_roots(make({-2, 0, 1})), b = isolate_real_roots(make({2, -2, -1, 1}));
  REQUIRE(b.size() == 3);
  CHECK(compare(a[1], b[2]) == sign::zero);
  CHECK(compare(a[1], b[1]) == sign::positive);
}

// Roots so near to each other that bisection alone would take thousands of halvings.
TEST_CASE("roots are isolated and refined fast however close, small or large they are", "[roots]") {
  const dyadic tiny = dyadic(1).scaled(-9000), huge = dyadic(3).scaled(4000);
  // (x - 3)^2 - 2 * 2^-18000, (x - tiny)(x - huge) and (x + tiny)(x - tiny)
  const dense_polynomial close({dyadic(9) - dyadic(2).scaled(-18000), dyadic(-6), dyadic(1)}),
      apart({tiny * huge, dyadic(0) - tiny - huge, dyadic(1)}),
      small({dyadic(0) - tiny * tiny, dyadic(0), dyadic(1)});
  auto near = isolate_real_roots(close), far = isolate_real_roots(apart),
       both = isolate_real_roots(small);
  REQUIRE(near.size() == 2);
  REQUIRE(far.size() == 2);
  REQUIRE(both.size() == 2);
  CHECK(compare(near[0], near[1]) == sign::negative);
  CHECK(compare(far[0], both[1]) == sign::zero);
  CHECK(compare(far[0], both[0]) == sign::positive);
  CHECK(compare(far[0], near[0]) == sign::negative);
  CHECK(compare(far[1], near[1]) == sign::positive);
  CHECK(near[0].sign_of_value(make({-3, 1})) == sign::negative);
  CHECK(near[1].sign_of_value(make({-3, 1})) == sign::positive);
  for (int step = 0; step < 40; ++step) near[1].refine();
  CHECK((near[1].high() - near[1].low()).magnitude() < -10000);
  CHECK(near[1].sign_of_value(close) == sign::zero);
}

TEST_CASE("the sign of a polynomial at an algebraic number is exact", "[roots]") {
  auto roots = isolate_real_roots(make({-2, 0, 1}));
  CHECK(roots[1].sign_of_value(make({-2, 0, 1})) == sign::zero);
  CHECK(roots[1].sign_of_value(make({-1393, 985})) == sign::positive);
  CHECK(roots[0].sign_of_value(make({-1393, 985})) == sign::negative);
  CHECK(roots[1].sign_of_value(make({-4, 0, 0, 0, 1})) == sign::zero);
  CHECK(roots[1].sign_of_value(make({5})) == sign::positive);
}

TEST_CASE("a root line merges common roots and samples every open section", "[roots]") {
  root_line line;
  line.add(make({-2, 0, 1}), 0);      // +- sqrt 2
  line.add(make({2, -2, -1, 1}), 1);  // +- sqrt 2, 1
  line.add(make({0, 1}), 2);          // 0
  line.add(dense_polynomial(), 3);    // the zero polynomial cuts nowhere
  REQUIRE(line.cuts().size() == 4);
  CHECK(line.cuts()[0].vanishing == 3);
  CHECK(line.cuts()[1].vanishing == 4);
  CHECK(line.cuts()[2].vanishing == 2);
  const auto samples = line.samples();
  REQUIRE(samples.size() == 5);
  const dense_polynomial all = make({0, 2, -2, -1, 1});
  std::vector<sign> signs;
  for (const dyadic& x : samples) signs.push_back(all.sign_at(x));
  CHECK(signs == std::vector<sign>{sign::positive, sign::negative, sign::positive, sign::negative,
                                   sign::positive});
}
