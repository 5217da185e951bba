// SPDX-License-Identifier: MIT
//
// Compares the insertion test and the edge test of every kernel with the oracle's.
#include <optional>

#include "agreement.hpp"
#include "asterism/tests/oracle/oracle.hpp"

namespace asterism::property {
namespace {

void expect_insertion_agrees(const four_sites& sites) {
  const site &v = sites[0], &w = sites[1], &x = sites[2], &y = sites[3];
  expect_agreement(
      oracle::insertion_test(v, w, x, y),
      [&](const auto& kernel) { return kernel.insertion_test(v, w, x, y); },
      record("insertion_test", sites));
}

// Returns whether the oracle had an answer.
bool expect_edge_agrees(const four_sites& sites) {
  const site &v = sites[0], &w = sites[1], &x = sites[2], &y = sites[3];
  const std::optional<bool> expected = oracle::edge_test(v, w, x, y);
  if (expected)
    expect_agreement(
        *expected, [&](const auto& kernel) { return kernel.edge_test(v, w, x, y); },
        record("edge_test", sites));
  return expected.has_value();
}

void expect_edges_agree(int per_kind) {
  int asked = 0, answered = 0;
  for_each_case(per_kind, [&](const four_sites& sites, random_source&) {
    ++asked;
    answered += expect_edge_agrees(sites) ? 1 : 0;
  });
  INFO(answered << " of " << asked << " ties and non-ties had an answer to compare with");
  CHECK(answered > asked * 9 / 10);
}

TEST_CASE("the insertion test agrees with the oracle", "[property]") {
  for_each_case(150,
                [](const four_sites& sites, random_source&) { expect_insertion_agrees(sites); });
}

TEST_CASE("the edge test agrees with the oracle", "[property]") { expect_edges_agree(60); }

TEST_CASE("the insertion test agrees with the oracle, at length", "[.][long]") {
  for_each_case(600,
                [](const four_sites& sites, random_source&) { expect_insertion_agrees(sites); });
}

TEST_CASE("the edge test agrees with the oracle, at length", "[.][long]") {
  expect_edges_agree(240);
}

}  // namespace
}  // namespace asterism::property
