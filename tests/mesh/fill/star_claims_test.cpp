// SPDX-License-Identifier: MIT
#include "asterism/mesh/fill/star_claims.hpp"

#include <catch2/catch.hpp>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "asterism/core/random.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

using claim = std::pair<vertex_index, vertex_index>;  // star, and the site that claims it

claim_list listed(const std::vector<claim>& claims) {
  claim_list list;
  for (const auto& [star, by] : claims) list.add(star, by);
  return list;
}

std::vector<claim> all_of(const claim_list& list) {
  std::vector<claim> all;
  list.for_each([&](vertex_index star, vertex_index by) { all.emplace_back(star, by); });
  return all;
}

std::vector<claim> random_claims(splitmix64& random, std::size_t count, std::size_t stars) {
  const auto below = [&random](std::size_t n) {
    return static_cast<vertex_index>(random.real() * static_cast<double>(n));
  };
  std::vector<claim> claims;
  vertex_index by = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (random.real() < 0.5) by = below(1000);
    claims.emplace_back(below(stars), by);
  }
  return claims;
}

// Compares with a map of the claims, inserted in the same order as the claims.
void check_sorted(const std::vector<claim>& claims, std::size_t first, std::size_t last) {
  std::map<vertex_index, std::vector<vertex_index>> expected;
  for (const auto& [star, by] : claims)
    if (star >= first && star < last) expected[star].push_back(by);
  const claims_by_star sorted = sort_by_star(listed(claims), first, last);
  REQUIRE(sorted.stars.size() == expected.size());
  REQUIRE(sorted.starts.size() == expected.size() + 1);
  std::size_t nth = 0;
  for (const auto& [star, by] : expected) {
    CHECK(sorted.stars[nth] == star);
    const auto found = sorted.of(nth++);
    CHECK(std::vector<vertex_index>(found.begin(), found.end()) == by);
  }
  CHECK(sorted.starts.back() == sorted.by.size());
}

}  // namespace

TEST_CASE("Claims are listed in the order in which they are laid", "[fill]") {
  const std::vector<claim> claims = {{5, 0}, {0, 0}, {0, 0}, {7, 3}, {5, 0}};
  const claim_list list = listed(claims);
  CHECK(all_of(list) == claims);
  CHECK(list.size() == 5);
  CHECK(list.entries() == 8);
}

TEST_CASE("The greatest numbers of sites and stars are not taken for marks", "[fill]") {
  constexpr auto most = static_cast<vertex_index>(claim_list::most_sites - 1);
  const std::vector<claim> claims = {{most, most}, {0, most}, {most, 0}};
  CHECK(all_of(listed(claims)) == claims);
}

TEST_CASE("A site's claims stay its own when lists are joined", "[fill]") {
  const std::vector<claim> before = {{1, 9}, {2, 9}}, after = {{3, 9}, {4, 8}};
  claim_list list = listed(before);
  list.append(claim_list{});
  list.append(listed(after));
  list.add(5, 8);
  CHECK(all_of(list) == std::vector<claim>{{1, 9}, {2, 9}, {3, 9}, {4, 8}, {5, 8}});
  CHECK(list.size() == 5);
}

TEST_CASE("Claims are sorted by stars, few and many alike, whole and in parts", "[fill]") {
  splitmix64 random{20261124};
  for (const std::size_t count : {0, 1, 12, 13, 300, 5000}) {
    const std::vector<claim> claims = random_claims(random, count, 200);
    CAPTURE(count);
    check_sorted(claims, 0, 200);
    check_sorted(claims, 0, 1);
    check_sorted(claims, 50, 50);
    check_sorted(claims, 67, 133);
  }
}
