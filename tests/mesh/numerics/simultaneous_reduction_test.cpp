// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/simultaneous_reduction.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using asterism::metric_tensor;
using namespace asterism::internal;

TEST_CASE("squares of tensors 2^600 apart overflowed when they were reduced") {
  const metric_tensor small{std::ldexp(1.0, -300), 0, std::ldexp(1.0, -300)};
  const metric_tensor large{std::ldexp(5.0, 300), std::ldexp(1.0, 300), std::ldexp(2.0, 300)};
  const simultaneous_reduction far = reduce(small, large), near = reduce({1, 0, 1}, {5, 1, 2});
  CHECK(far.high == Approx(std::ldexp(near.high, 600)));
  CHECK(far.low == Approx(std::ldexp(near.low, 600)));
  CHECK(far.c == Approx(near.c));
  CHECK(far.s == Approx(near.s));
}
