// SPDX-License-Identifier: MIT
//
// Stars whose last look is left to the audit: the same meshes, which the audit certifies.
#include "asterism/mesh/pipeline/unconfirmed_mesh.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"

using namespace asterism;

TEST_CASE("leaving the last look at stars to the audit changes no mesh") {
  const domain shapes[] = {square(), airfoil().value(), add_random_points(square(), 50, 1).value()};
  for (const domain& d : shapes)
    for (const char* metric : {"swirl:12", "sink:12", "swirl:24"})
      for (const double size : {0.4, 0.2, 0.1}) {
        CAPTURE(metric, size, d.vertices.size());
        const auto field = make_metric_field(metric, d.box(), size);
        REQUIRE(field);
        mesh_options options;
        options.angle_bound = 20;
        options.limit_size = true;
        options.strategy = refinement_strategy::fill;
        const auto confirmed = make_mesh(d, *field.value(), options),
                   trusted = internal::make_unconfirmed_mesh(d, *field.value(), options, {});
        REQUIRE(confirmed);
        REQUIRE(trusted);
        CHECK(trusted.value().complete == confirmed.value().complete);
        const mesh &a = confirmed.value().result, &b = trusted.value().result;
        CHECK(a.triangles == b.triangles);
        CHECK(std::equal(a.sites.begin(), a.sites.end(), b.sites.begin(), b.sites.end()));
        CHECK(judge_outcome(trusted.value(), d, options).certified() == trusted.value().complete);
      }
}

TEST_CASE("a run that is improved is confirmed before") {
  const domain d = square();
  const auto field = make_metric_field("swirl:12", d.box(), 0.3);
  REQUIRE(field);
  mesh_options options;
  options.angle_bound = 20;
  options.limit_size = true;
  options.strategy = refinement_strategy::fill;
  options.improve_passes = 1;
  const auto confirmed = make_mesh(d, *field.value(), options),
             made = internal::make_unconfirmed_mesh(d, *field.value(), options, {});
  REQUIRE(confirmed);
  REQUIRE(made);
  CHECK(made.value().counters.decided == confirmed.value().counters.decided);
  CHECK(made.value().result.triangles == confirmed.value().result.triangles);
}
