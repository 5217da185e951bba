// SPDX-License-Identifier: MIT
//
// Tests the bounds by which sites are excluded from a gap of a star.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/kernels/star_gap.hpp"
#include "asterism/mesh/audit/distant_site.hpp"
#include "asterism/mesh/audit/gap_reach.hpp"
#include "asterism/mesh/audit/star_filter.hpp"
#include "asterism/mesh/audit/star_outline.hpp"
#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::audit_detail;
using namespace asterism::test;

TEST_CASE("a middle direction along which a neighbour is never met bounds no reach") {
  const site v{{0.021824585749476474, -0.048365284798181613},
               {0.30445532595024566, -0.011046073896418625, 0.32305103897580789}};
  const site w{{2.8253168640733044, 4.4693916536858662},
               {3.531625813788239, -0.82149189262108435, 5.5989245846161833}};
  const site x{{0.60795990606248984, 0.17983712758803594},
               {4.9200461877662161, -2.8997255021004347, 2.0344296834466702}};
  const site y{{-0.88837472957907049, 0.64296693826375129},
               {6.2945098004754723, -2.3268538241074355, 1.049069106753779}};
  REQUIRE(filtered_kernel().edge_test(v, w, x, y));
  CHECK_FALSE(is_too_far(v, star_gap_filter(v, x, y).reach(), w));
}

namespace {

// Returns the bound of a gap towards its vertex, or if that is not known, balanced.
gap_bound bound_of(const quick_reaches& reaches, const measured_ray& x, const measured_ray& y) {
  const gap_bound bound = reaches.between(x, y);
  return std::isfinite(bound.reach) ? bound : reaches.balanced(x, y);
}

// True if w is certainly outside of the kite of the gap from x to y.
bool is_outside_gap(const site& v, const site& x, const site& y, const site& w) {
  const quick_reaches reaches(v);
  const measured_ray to_x = reaches.ray_to(x), to_y = reaches.ray_to(y);
  const gap_bound bound = bound_of(reaches, to_x, to_y);
  if (!std::isfinite(bound.reach)) return false;
  const std::array<kite_side, 2> sides{kite_side{to_x.way, to_x.on_bisector()},
                                       kite_side{to_y.way, to_y.on_bisector()}};
  const point d{w.position.x - v.position.x, w.position.y - v.position.y};
  return is_outside_kite(d, w.metric, bound.vertex, sides);
}

}  // namespace

TEST_CASE("the quick exclusions, one by one and by distance, are never wrong") {
  const std::uint64_t seed = 20;
  CAPTURE(seed);
  splitmix64 random(seed);
  const filtered_kernel kernel;
  const auto random_site = [&](double reach, double strength) {
    const metric_tensor metric = random_metric(random, strength);
    return site{{random.real(-reach, reach), random.real(-reach, reach)}, metric};
  };
  int cases = 0, excluded = 0, distant = 0, outlined = 0, accepted = 0;
  for (int i = 0; i < 15000; ++i) {
    const double strength = i % 4 == 0 ? 0 : random.real(0, 3);
    site v = random_site(0.1, strength), x = random_site(1, strength), y = random_site(1, strength);
    const site w = random_site(i % 2 == 0 ? 1.5 : 6, strength);
    if (kernel.orientation(v.position, x.position, y.position) == sign::negative) std::swap(x, y);
    if (kernel.orientation(v.position, x.position, w.position) != sign::positive ||
        kernel.orientation(v.position, w.position, y.position) != sign::positive)
      continue;
    ++cases;
    const bool accepts = kernel.edge_test(v, w, x, y);
    const star_gap_filter filter(v, x, y);
    const bool excludes = filter.excludes(w);
    const bool far = is_too_far(v, filter.reach(), w),
               quickly_far = is_too_far(v, quick_reach(v, x, y), w),
               beyond = is_too_far(v, star_gap(v, x, y).reach(), w);
    CAPTURE(i);
    REQUIRE_FALSE((accepts && beyond));
    REQUIRE_FALSE((accepts && excludes));
    REQUIRE_FALSE((accepts && far));
    REQUIRE_FALSE((accepts && quickly_far));
    const bool outside = is_outside_gap(v, x, y, w);
    INFO("edge_test " << sites_text({v, w, x, y}));
    REQUIRE_FALSE((accepts && outside));
    outlined += outside;
    excluded += excludes;
    distant += far && beyond && quickly_far;
    accepted += accepts;
  }
  CAPTURE(cases, excluded, distant, outlined, accepted);
  CHECK(cases > 2000);
  CHECK(outlined > distant);
  CHECK(accepted > 200);
  CHECK(excluded > 300);
  CHECK(distant > 100);
}

TEST_CASE("the quick reach of a gap is about that of the prepared one where metrics vary little") {
  splitmix64 random(21);
  int known = 0, asked = 0;
  for (int i = 0; i < 2000; ++i) {
    const metric_tensor base = random_metric(random, 2);
    const double scale = std::exp2(random.real(-60, 60));
    const auto at = [&](double px, double py) {
      const double factor = random.real(0.97, 1.03);
      return site{{scale * px, scale * py}, {factor * base.m11, base.m12, base.m22}};
    };
    const site v = at(0, 0), x = at(1, random.real(-0.2, 0.2)),
               y = at(random.real(0.2, 0.8), random.real(0.7, 1.1));
    const double wanted = star_gap(v, x, y).reach(), quick = quick_reach(v, x, y);
    CAPTURE(i);
    if (!std::isfinite(wanted)) continue;
    ++asked;
    if (!std::isfinite(quick)) continue;
    const auto half = [&](const site& z) {
      return 0.4999 * std::sqrt(squared_length(v.metric, between(v.position, z.position)));
    };
    CHECK(quick >= std::max(half(x), half(y)));
    known += quick <= 1.25 * wanted;
  }
  CAPTURE(asked, known);
  CHECK(asked > 500);
  CHECK(known > 0.8 * asked);
}

TEST_CASE("no quick reach is known of a gap that doubles cannot tell") {
  const metric_tensor round{1, 0, 1};
  const site v{{0, 0}, round}, x{{1, 0}, round}, y{{0.5, 0.8}, round};
  REQUIRE(std::isfinite(quick_reach(v, x, y)));
  const auto in = [](site s, const metric_tensor& m) { return site{s.position, m}; };
  const metric_tensor thin{1, 1 - 0x1p-40, 1}, large{0x1p320, 0, 0x1p320}, small{0x1p-320, 0, 1};
  for (const metric_tensor& m : {thin, large, small})
    CHECK(std::isinf(quick_reach(in(v, m), in(x, m), in(y, m))));
  const site across{{-1, 0}, round};  // half a turn, and more
  CHECK(std::isinf(quick_reach(v, x, across)));
  CHECK(std::isinf(quick_reach(v, x, {{-0.5, -0.8}, round})));
}
