// SPDX-License-Identifier: MIT
//
// Tests the oracle: compares its two ways to one answer, and known answers.
#include "oracle.hpp"

#include <catch2/catch.hpp>

#include "exact_numbers.hpp"
#include "unit_interval_roots.hpp"

namespace asterism::oracle {
namespace {

TEST_CASE("counting roots by signs agrees with isolating them", "[oracle]") {
  const algebraic_number zero(0), one(1);
  for (int c0 = -6; c0 <= 6; ++c0)
    for (int c1 = -9; c1 <= 9; ++c1)
      for (int c2 = -9; c2 <= 9; ++c2) {
        if (c0 == 0) continue;
        int isolated = 0;
        for (const algebraic_number& root :
             distinct_real_roots({rational(c0), rational(c1), rational(c2)}))
          if (!(root < zero) && !(one < root)) ++isolated;
        if (isolated != roots_in_closed_unit_interval(rational(c0), rational(c1), rational(c2)))
          FAIL_CHECK(c0 << " + " << c1 << " t + " << c2 << " t^2");
      }
}

TEST_CASE("the oracle on the unit square", "[oracle]") {
  const metric_tensor m = {1, 0, 1};
  const site a = {{0, 0}, m}, b = {{1, 0}, m}, c = {{1, 1}, m}, d = {{0, 1}, m};
  CHECK_FALSE(insertion_test(a, c, b, d));
  CHECK_FALSE(insertion_test(b, d, c, a));
  CHECK(edge_test(a, c, b, d) == false);
  CHECK(edge_test(b, d, c, a) == true);
  CHECK(voronoi_vertex_count(a, b, c) == 1);
  CHECK(arc_intersection_count(a, b, c) == 1);
  CHECK_FALSE(encroaches(a, c, b));
  CHECK(insertion_test(a, b, c, d));
}

TEST_CASE("the oracle counts common points of sites of one abscissa", "[oracle]") {
  const site a = {{4, 4}, {51, -12, 3}}, b = {{4, -2}, {7, 2, 1}};
  const site c = {{4, 3}, {30, -9, 0x1.7ffffffffffffp+1}};
  CHECK(voronoi_vertex_count(a, b, c) == 2);
  CHECK(arc_intersection_count(a, b, c) == 0);
}

}  // namespace
}  // namespace asterism::oracle
