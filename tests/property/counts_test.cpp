// SPDX-License-Identifier: MIT
//
// Compares numbers of Voronoi vertices and arc intersections of every kernel with the oracle's.
#include "agreement.hpp"
#include "asterism/tests/oracle/oracle.hpp"

namespace asterism::property {
namespace {

void expect_counts_agree(const four_sites& sites) {
  const site &v = sites[0], &w = sites[1], &x = sites[2];
  expect_agreement(
      oracle::voronoi_vertex_count(v, w, x),
      [&](const auto& kernel) { return kernel.voronoi_vertex_count(v, w, x); },
      record("voronoi_vertex_count", {sites.data(), 3}));
  expect_agreement(
      oracle::arc_intersection_count(v, w, x),
      [&](const auto& kernel) { return kernel.arc_intersection_count(v, w, x); },
      record("arc_intersection_count", {sites.data(), 3}));
}

TEST_CASE("counts of common points agree with the oracle", "[property]") {
  for_each_case(60, [](const four_sites& sites, random_source&) { expect_counts_agree(sites); });
}

TEST_CASE("counts of common points agree with the oracle, at length", "[.][long]") {
  for_each_case(240, [](const four_sites& sites, random_source&) { expect_counts_agree(sites); });
}

}  // namespace
}  // namespace asterism::property
