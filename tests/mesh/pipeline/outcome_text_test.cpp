// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/outcome_text.hpp"

#include <catch2/catch.hpp>
#include <string>

using namespace asterism;

namespace {

refinement_ending ended(ending how) {
  refinement_ending e;
  e.how = how;
  e.max_sites = 500;
  e.sites = 40;
  e.bad_triangles = 3;
  e.tolerance = 0.25;
  return e;
}

std::string text_of(ending how) { return ending_text(ended(how)); }

const std::string agree = "all stars agree and every triangle meets the bound";

}  // namespace

TEST_CASE("outcome text: each way a refinement ends has its sentence") {
  CHECK(text_of(ending::complete) == agree);
  CHECK(text_of(ending::site_limit) == "the limit of 500 sites was reached");
  CHECK(text_of(ending::stuck) ==
        "stuck: 3 bad triangles are left, and no candidates on Voronoi arcs farther than the "
        "tolerance 0.25 from every site can be inserted");
  CHECK(text_of(ending::overworked) ==
        "given up: 3 bad triangles are left after the most work that is done for so many sites");
  refinement_ending e = ended(ending::too_steep);
  e.sites_since = 17;
  CHECK(ending_text(e) ==
        "given up: 3 bad triangles are left after 17 sites more than there were when the first "
        "could not be mended");
  e = ended(ending::stopped);
  e.stopped_because = "interrupted";
  CHECK(ending_text(e) == "stopped: interrupted");
  e = ended(ending::crowded);
  e.crowded = crowded_site{{0.5, -2}, 30, 90};
  CHECK(ending_text(e) ==
        "the metric varies too fast for sites to be spread: of 90 proposed, the one at (0.5, -2) "
        "has 30 neighbours (a gradation of it might do); only the given vertices are meshed");
  e.crowded->has_one_metric = true;
  CHECK(ending_text(e) ==
        "the metric, the same everywhere, wants triangles too thin for sites to be spread in this "
        "domain: 90 were proposed (a bound on their aspect might do); only the given vertices are "
        "meshed");
}

TEST_CASE("outcome text: places are named where they are known") {
  refinement_ending e = ended(ending::stuck);
  e.strategy = refinement_strategy::poisson_darts;
  e.steep = steep_place{2, {1, 1e-7}, 0.001};
  e.sharpest = sharp_corner{4, {0, 0}, 14};
  CHECK(ending_text(e) ==
        "stuck: 3 bad triangles are left, and no darts farther than the tolerance 0.25 from every "
        "site can be inserted; at 2 of them, one at (1, 1e-07), the metric varies faster than "
        "sites 0.001 apart can resolve (a gradation of it might do); the sharpest corner beside "
        "them is vertex 5 at (0, 0), 14 degrees");
  CHECK(ending_text(e, 0).find("them is vertex 4 at (0, 0), 14 degrees") != std::string::npos);
}

TEST_CASE("outcome text: what came before and what is missing stand around the ending") {
  refinement_ending e = ended(ending::complete);
  e.nothing_added = true;
  CHECK(ending_text(e) == "nothing to add: " + agree);
  e.length_factor = 2;
  CHECK(ending_text(e) ==
        "the limit of 500 sites was reached; with edges 2 times as long, nothing to add: " + agree);
  e.sites_wanted = 1234;
  e.nothing_added = false;
  e.stars_missing = 7;
  CHECK(ending_text(e) ==
        "the limit of 500 sites was reached: the size wanted takes about 1.23e+03; with edges 2 "
        "times as long, " +
            agree + "; the stars of 7 of 40 sites were never made");
}

TEST_CASE("outcome text: vertices a rounding apart are named where a run did not end well") {
  mesh_outcome made;
  made.ended = ended(ending::stuck);
  const metric_tensor unit{1, 0, 1};
  made.result.sites = {
      {{0, 0}, unit}, {{4, 0}, unit}, {{4, 0x1p-40}, unit}, {{0, 3}, unit}, {{0, 0x1p-50}, unit}};
  made.result.given = 4;  // the last site is no given vertex
  made.result.boundary = {{0, 1, 0}, {1, 2, 1}, {2, 3, 2}, {3, 4, 3}, {4, 0, 3}};
  CHECK(ending_text(made) == text_of(ending::stuck) +
                                 "; vertices 2 and 3 at (4, 0) are 9.09495e-13 apart, which leaves "
                                 "no room for triangles");
  CHECK(ending_text(made, 0).find("; vertices 1 and 2 at (4, 0) are") != std::string::npos);
  made.result.sites[2].position.y = 0x1p-37;
  CHECK(ending_text(made) == text_of(ending::stuck));
}

TEST_CASE("outcome text: a run is told by what it delivers") {
  mesh_outcome made;
  made.ended = ended(ending::stuck);
  CHECK(made.how() == ending::stuck);
  CHECK(ending_text(made) == ending_text(made.ended));
  SECTION("stopped while one metric for all was meshed") {
    made.stopped = true;
    made.stopped_in_one_metric = ended(ending::stopped);
    made.stopped_in_one_metric->stopped_because = "enough";
    CHECK(made.how() == ending::stopped);
    CHECK(ending_text(made) ==
          "stopped: enough, in one metric for all; before that, in the metric given, " +
              text_of(ending::stuck));
  }
  SECTION("longer edges than wanted are the doing of the limit, whatever came of them") {
    made.ended = ended(ending::complete);
    made.ended.length_factor = 4;
    CHECK(made.how() == ending::site_limit);
  }
  SECTION("one metric for all") {
    made.ended = ended(ending::complete);
    made.sites = 9;
    made.one_metric = {ended(ending::stuck), std::nullopt, true, false, 20};
    made.delivered.emplace();
    made.delivered->changed = 4;
    made.delivered->greatest = std::log(3);
    made.delivered->median = std::log(1.5);
    made.delivered->low_wanted = {1, 2};
    made.delivered->worst_angle_wanted = 12.344;
    CHECK(made.how() == ending::one_metric);
    CHECK(
        ending_text(made) ==
        "stars cannot agree in the metric given (" + text_of(ending::stuck) +
            "); they agree in one metric for all, which "
            "differs from it at 4 of 9 sites, with lengths up to 3 times as long or as short, and "
            "1.5 at half of them: " +
            agree +
            "; as the metric given measures them 2 triangles are below 20 degrees, the worst "
            "12.34");
    made.intolerable = {most_median_distance, 3, intolerable_distance::measure::median, 4};
    CHECK(ending_text(made).find("half of them, so that it is another one altogether: ") !=
          std::string::npos);
  }
  SECTION("without demands, the metric not being to blame, the shortest edge is named") {
    made.ended = ended(ending::complete);
    made.result.sites = {{{0, 0}, {4, 0, 4}}, {{1, 0}, {1, 0, 1}}, {{0, 3}, {1, 0, 1}}};
    made.result.triangles = {{0, 1, 2}};
    made.one_metric = {ended(ending::site_limit), close_vertices{3, 4, {5, 6}, 1e-17}, false, true,
                       20};
    CHECK(ending_text(made) ==
          "no mesh was found that meets the demands (" + text_of(ending::site_limit) +
              "; vertices 4 and 5 at (5, 6) are 1e-17 apart, which leaves no room for triangles), "
              "though the metric is the same everywhere; the one delivered is made with no demands "
              "on angles "
              "and sizes, and its shortest edge, 2 long, is at (0, 0): " +
              agree);
  }
}
