// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <vector>

#include "asterism/mesh/delivery/constant_metric_fallback.hpp"
#include "fixtures/domain_kinds.hpp"

using namespace asterism;
using namespace asterism::testing;

namespace {

// A strip of width 1 with a vertex at each unit of its length, on both sides.
domain strip(int length) {
  std::vector<point> ring;
  for (int i = 0; i <= length; ++i) ring.push_back({static_cast<double>(i), 0});
  for (int i = length; i >= 0; --i) ring.push_back({static_cast<double>(i), 1});
  return accepted(polygon(ring));
}

}  // namespace

TEST_CASE("a narrow domain, whose sites come in steps, missed the number of vertices by more",
          "[adapt]") {
  const domain d = strip(150);
  // Leaves out counts that no mesh has: subsegments of equal length are all divided at once, so
  // that the mesh nearest to 1,000 sites has 902. A search that stops too early makes 12.75 % too
  // many sites for 800.
  for (const std::size_t count : {600u, 800u, 1200u, 2000u}) {
    const double density = static_cast<double>(count) * std::sqrt(3.0) / 2 / 150;
    const auto made = internal::mesh_in_one_metric(d, {density, 0, density}, {}, count);
    REQUIRE(made);
    const double off =
        static_cast<double>(made->made.sites.size()) / static_cast<double>(count) - 1;
    INFO(count << " wanted, " << made->made.sites.size() << " made");
    CHECK(std::abs(off) <= 0.06);
  }
}
