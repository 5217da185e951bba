// SPDX-License-Identifier: MIT
//
// The filtered kernel counts every call once, under the tier that decided it.
#include <array>
#include <cstdint>

#include "agreement.hpp"

namespace asterism::property {
namespace {

std::uint64_t calls(const tier_counters& counters, predicate p) {
  std::uint64_t sum = 0;
  for (std::size_t t = 0; t < tier_count; ++t) sum += counters.at(p, static_cast<tier>(t));
  return sum;
}

TEST_CASE("tier counters add up to the number of calls", "[property]") {
  tier_counters decided;
  const filtered_kernel kernel(decided);
  std::array<std::uint64_t, predicate_count> expected{};
  for_each_case(3, [&](const four_sites& sites, random_source& random) {
    const auto& [v, w, x, y] = sites;
    const point p = draw_point(sites, random);
    (void)kernel.orientation(v.position, w.position, p);
    (void)kernel.is_positive_definite(v.metric);
    (void)kernel.compare_distance(v, w, p);
    (void)kernel.in_wedge(v, w, p);
    (void)kernel.dominates(v, w, p);
    (void)kernel.voronoi_vertex_count(v, w, x);
    (void)kernel.arc_intersection_count(v, w, x);
    (void)kernel.encroaches(v, w, x);
    (void)kernel.insertion_test(v, w, x, y);
    (void)kernel.edge_test(v, w, x, y);
    (void)kernel.in_circle(v.metric, v.position, w.position, x.position, p);
    for (std::uint64_t& count : expected) ++count;
  });
  for (std::size_t i = 0; i < predicate_count; ++i) {
    INFO(predicate_names[i]);
    CHECK(calls(decided, static_cast<predicate>(i)) == expected[i]);
  }
  decided = {};
  for (std::size_t i = 0; i < predicate_count; ++i)
    CHECK(calls(decided, static_cast<predicate>(i)) == 0);
}

}  // namespace
}  // namespace asterism::property
