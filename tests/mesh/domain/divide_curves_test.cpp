// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/divide_curves.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/metric/constant_field.hpp"

using namespace asterism;

namespace {

// A triangle of two straight sides and, over a segment of length 1, a cubic that leaves the segment
// at this slope and returns to it.
domain bent_triangle(double slope) {
  domain d;
  d.vertices = {{0, 0}, {1, 0}, {0.5, 1}};
  d.segments = {{0, 1, 1, false}, {1, 2, 1, false}, {2, 0, 1, false}};
  domain_curve cubic;
  cubic.kind = curve_kind::cubic;
  cubic.control = {{{1.0 / 3, -slope / 3}, {2.0 / 3, -slope / 3}}};
  cubic.vertices = {0, 1};
  cubic.parameters = {0, 1};
  cubic.segment = 0;
  d.curves = {cubic};
  return check_domain(d).value();
}

std::size_t chords(const domain& d, double size, bool is_even) {
  const auto field = internal::same_everywhere({1 / (size * size), 0, 1 / (size * size)});
  curve_division wanted;
  wanted.field = field.get();
  wanted.is_even = is_even;
  const auto divided = divide_curves_anew(d, wanted);
  REQUIRE(divided.ok());
  return divided.value().segments.size() - 2;
}

}  // namespace

// Cubics guessed through a ragged boundary must not be divided where they turn by a fiftieth of
// their chord: in an adaptation loop whose solver moves the boundary, edges become a hundred
// thousand times shorter than wanted.
TEST_CASE("a guessed cubic that is shorter than the metric wants is not divided") {
  const domain d = bent_triangle(0.3);  // height 0.075
  CHECK(chords(d, 2, true) > 1);
  CHECK(chords(d, 2, false) == 1);
  CHECK(chords(d, 1.3, false) == 1);
  CHECK(chords(d, 1, false) == 2);
}
