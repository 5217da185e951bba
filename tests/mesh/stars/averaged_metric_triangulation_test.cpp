// SPDX-License-Identifier: MIT
//
// Compares neighbours guessed from one triangulation with stars made one by one.
#include "asterism/mesh/stars/averaged_metric_triangulation.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "asterism/kernels/work_units.hpp"
#include "asterism/mesh/stars/star_construction.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/star_fixture.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;
using asterism::vertex_index;

namespace {

// Counts the interior sites whose guessed neighbours equal their star. The star is made by
// searching near sites, without the guess.
std::size_t right_guesses(const site_oracle& oracle, const neighbour_lists& guesses) {
  std::size_t right = 0;
  for (vertex_index v = 0; v < oracle.size(); ++v) {
    const constructed_star built = construct_star(oracle, v, star_search::thorough);
    const auto guess = guesses[v];
    const sector& only = built.content.sectors.front();
    right += only.closed &&
             std::equal(guess.begin(), guess.end(), only.neighbours.begin(), only.neighbours.end());
  }
  return right;
}

}  // namespace

TEST_CASE("neighbours of random sites are guessed right but for a few where the metric varies") {
  const domain d = accepted(add_random_points(square(), 2000, 7).value());
  const std::size_t least[] = {1990, 1800};
  const formula_field fields[] = {identity_field(), swirl_field(12)};
  for (int i : {0, 1}) {
    const indexed_setting now(d, fields[i]);
    const neighbour_lists guesses = guess_neighbours(now.oracle(), {});
    REQUIRE(guesses.size() == now.sites.size());
    CHECK(work_units(now.decided) < 0.1);
    const std::size_t right = right_guesses(now.oracle(), guesses);
    INFO(right << " of " << now.sites.size());
    CHECK(right > least[i]);
  }
}

TEST_CASE("nothing is guessed where there is no triangulation to read it from") {
  domain d = square();
  d.vertices.push_back({0, -1});  // vertices on a segment
  const indexed_setting now(d, identity_field());
  CHECK(guess_neighbours(now.oracle(), {}).size() == 0);
}
