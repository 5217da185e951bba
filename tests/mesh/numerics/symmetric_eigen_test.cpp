// SPDX-License-Identifier: MIT
//
// Tests eigenvalues of symmetric matrices: they are the same at every scale that doubles have.
#include "asterism/mesh/numerics/symmetric_eigen.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace asterism;
using namespace asterism::internal;

TEST_CASE("eigenvalues of a matrix times a power of two are the same, times that power") {
  const metric_tensor matrices[] = {{1, 0, 1}, {3, 1, 2}, {1, -0.5, 0.25}, {-4, 3, 7}, {0, 1, 0}};
  for (const metric_tensor& m : matrices) {
    const symmetric_eigen plain = eigen_of(m);
    for (const int exponent : {-1000, -600, -300, -100, 100, 300, 600, 1000}) {
      CAPTURE(m.m11, m.m12, m.m22, exponent);
      const symmetric_eigen scaled = eigen_of(times_power_of_two(m, exponent));
      CHECK(scaled.first == std::scalbn(plain.first, exponent));
      CHECK(scaled.second == std::scalbn(plain.second, exponent));
      CHECK(scaled.c == plain.c);
      CHECK(scaled.s == plain.s);
    }
  }
}
