// SPDX-License-Identifier: MIT
//
// Sites added for low angles before there are stars.
#include "asterism/mesh/refine/plain_refinement.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <utility>
#include <vector>

#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/star_fixture.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;

namespace {

domain scattered(std::size_t count) {
  return accepted(add_random_points(square(), count, 5).value());
}

refine_state started(const domain& d, const metric_field& field, const star_predicates& kernel,
                     std::size_t most_sites) {
  filled_domain nothing;
  nothing.divisions.resize(d.segments.size());
  refine_state state =
      std::move(refine_state::start(d, field, kernel, most_sites, nothing)).value();
  state.clear_encroachments(0);
  return state;
}

// Counts the guesses that are the star of their site, of all sites inside the domain.
std::size_t confirmed(refine_state& state, const neighbour_lists& likely) {
  state.construct_stars(likely, star_confirmation::by_mesher);
  std::size_t same = 0;
  for (vertex_index v = 0; v < state.sites().size(); ++v) {
    const auto& ring = state.stars()[v].sectors.front();
    same += ring.closed && std::equal(likely[v].begin(), likely[v].end(), ring.neighbours.begin(),
                                      ring.neighbours.end());
  }
  return same;
}

}  // namespace

TEST_CASE("sites added without stars keep their distance, and their neighbours are guessed right") {
  tier_counters decided;
  const star_predicates_on<filtered_kernel> kernel(decided);
  const domain d = scattered(1500);
  const formula_field field = swirl_field(3);
  refine_state state = started(d, field, kernel, 100000);
  const std::size_t before = state.sites().size();
  constexpr double tolerance = 1e-3;
  const neighbour_lists likely =
      refine_plainly(state, angle_requirement(20), tolerance, cancellation());
  const std::vector<site>& sites = state.sites();
  CHECK(sites.size() > before + 500);
  REQUIRE(likely.size() == sites.size());
  std::size_t too_near = 0;
  for (std::size_t w = before; w < sites.size(); ++w)
    for (std::size_t v = 0; v < w; ++v)
      too_near += std::min(squared_distance(sites[v], sites[w].position),
                           squared_distance(sites[w], sites[v].position)) < tolerance * tolerance;
  CHECK(too_near == 0);
  CHECK(confirmed(state, likely) > sites.size() * 9 / 10);
}

TEST_CASE("there are no more sites without stars than there may be") {
  tier_counters decided;
  const star_predicates_on<filtered_kernel> kernel(decided);
  const domain d = scattered(1500);
  const formula_field field = swirl_field(3);
  refine_state state = started(d, field, kernel, 1600);
  const std::size_t before = state.sites().size();
  refine_plainly(state, angle_requirement(20), 1e-3, cancellation());
  CHECK(state.sites().size() == std::max<std::size_t>(before, 1600));
  refine_plainly(state, angle_requirement(20), 1e-3,
                 [] { return std::optional<std::string>("x"); });
  CHECK(state.sites().size() == std::max<std::size_t>(before, 1600));
}

TEST_CASE("many sites with internal segments and sharp corners meet an angle bound") {
  domain d = scattered(1500);
  const auto first = static_cast<vertex_index>(d.vertices.size());
  d.vertices.insert(d.vertices.end(), {{0.1, 0.2}, {0.7, 0.25}, {0.7, 0.6}, {-0.5, -0.5}});
  d.segments.push_back({first, first + 1, 5});
  d.segments.push_back({first, first + 2, 6});
  d.segments.push_back({first + 3, 1, 7});
  const domain shape = accepted(std::move(d));
  const formula_field field = swirl_field(3);
  mesh_options options;
  options.angle_bound = 20;
  const certified_mesh made = make_certified_mesh(shape, field, options).value();
  CHECK(made.outcome.complete);
  CHECK(made.certified());
  // Random points of another seed took 3170 sites, put in by stars one by one.
  INFO(made.outcome.sites);
  CHECK(made.outcome.sites < 3300);
}
