// SPDX-License-Identifier: MIT
//
// Makes meshes to which the theorem on nets applies. Problems for which no such mesh can be made
// are refused by name beforehand, and a run that does not reach one says how far it came.
#include "asterism/mesh/pipeline/guaranteed_mesh.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "asterism/mesh/fill/segment_division.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/support/size_ladder.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/named_metric.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

domain polygon(const std::vector<point>& corners) {
  return testing::accepted(testing::polygon(corners));
}

std::unique_ptr<metric_field> field(const std::string& spec, const domain& d, double size) {
  return testing::named_metric(spec, d.box(), size);
}

std::string refusal(const domain& d, const std::string& spec, double size,
                    const mesh_options& options = {}) {
  const auto made = make_guaranteed_mesh(d, *field(spec, d, size), options);
  return made ? "" : made.failure().message;
}

}  // namespace

TEST_CASE("a guaranteed mesh has the metric asked for, and the theorem applies to it") {
  const domain d = polygon({{0, 0}, {2, 0}, {2.2, 1.5}, {0.5, 2}});
  for (const std::string spec : {"identity", "sink:3", "layer:0.3,1", "swirl:0.5"}) {
    CAPTURE(spec);
    const auto asked = field(spec, d, 0.4);
    const auto made = make_guaranteed_mesh(d, *asked, {});
    REQUIRE(made.ok());
    const certified_mesh& m = made.value();
    INFO(m.claim.reason);
    REQUIRE(m.claim.guarantee);
    CHECK(m.certified());
    CHECK(m.claim.theorem->applies);
    CHECK(m.claim.theorem->proved_angle >= 20);
    const guarantee_claim& kept = *m.claim.guarantee;
    CHECK(kept.eps * kept.size_factor <= guaranteed_covering);
    CHECK(kept.times_least.value_or(0) >= 1);
    const double steps = std::log(kept.size_factor) / std::log(1.3);
    CHECK(std::abs(steps - std::round(steps)) < 1e-12);
    for (const site& s : m.outcome.result.sites)
      CHECK(identical(s.metric, asked->at(s.position).value()));
  }
}

TEST_CASE("every step of the ladder of sizes is told from its factor, to the last bit") {
  for (int step = 0; step <= ladder_steps; ++step) {
    const double factor = ladder_factor(step);
    CHECK(ladder_step_below(factor) == step);
    CHECK(ladder_step_below(std::nextafter(factor, 0.0)) == std::max(0, step - 1));
    CHECK(std::abs(factor / std::pow(1.3, step) - 1) < 1e-13);
  }
  CHECK(ladder_factor(ladder_steps) > 0x1p60);
  CHECK(ladder_step_below(std::nan("")) == 0);
}

TEST_CASE("a metric that varies too fast at the size asked for gets shorter edges") {
  const domain d = square();
  const auto asked = field("swirl:3", d, 0.4);
  const auto plain = make_certified_mesh(d, *asked, {.limit_size = true});
  REQUIRE(plain.ok());
  CHECK_FALSE((plain.value().claim.theorem && plain.value().claim.theorem->applies));
  // In this metric the outer square's corners have 41 degrees, and the inner square's are not
  // sharp.
  const domain middle = polygon({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});
  const auto made = make_guaranteed_mesh(middle, *field("swirl:2", d, 0.4), {});
  REQUIRE(made.ok());
  INFO(made.value().claim.reason);
  REQUIRE(made.value().claim.guarantee);
  CHECK(made.value().claim.guarantee->size_factor > 1);
  CHECK(made.value().claim.guarantee->field_variation > 0.1);
  REQUIRE(made.value().claim.guarantee->field_variation_bound);
  CHECK(*made.value().claim.guarantee->field_variation_bound >=
        made.value().claim.guarantee->field_variation);
}

TEST_CASE("what a guarantee cannot be given for is refused by name") {
  const domain sharp = polygon({{0, 0}, {4, 0}, {4, 1}});
  CHECK(refusal(sharp, "identity", 0.2).find("corner at vertex 1 (0, 0) has 14.0") !=
        std::string::npos);
  // The exterior angle of the notch is 22.6 degrees.
  const domain notched = polygon({{0, 0}, {4, 0}, {4, 4}, {2.4, 4}, {2, 2}, {1.6, 4}, {0, 4}});
  CHECK(refusal(notched, "identity", 0.4).find("outer corner at vertex 5 (2, 2) has 22.6") !=
        std::string::npos);
  CHECK(refusal(square(), "swirl:5", 0.4).find("has 33.5") != std::string::npos);
  const std::string jump = refusal(square(), "expr:x<0.2?1:9;0;1", 0.2);
  CHECK(jump.find("no jump is allowed") != std::string::npos);
  CHECK(jump.find("factor of 3 ") != std::string::npos);
  CHECK(refusal(square(), "identity", 0.2, {.angle_bound = 25}).find("at most 20 degrees") !=
        std::string::npos);
}

TEST_CASE("a corner between 36 and 55 degrees gets a guarantee, inside and outside") {
  // A corner of 41.2 degrees, a notch of 43.6 degrees, and a corner of 38.7 degrees in a constant
  // stretched metric.
  const domain sharp = polygon({{0, 0}, {4, 0}, {4, 3.5}});
  const domain notched = polygon({{0, 0}, {4, 0}, {4, 4}, {2.8, 4}, {2, 2}, {1.2, 4}, {0, 4}});
  const domain flat = polygon({{0, 0}, {4, 0}, {4, 1.6}});
  for (const auto& [d, spec] : {std::pair(&sharp, "identity"), std::pair(&notched, "identity"),
                                std::pair(&sharp, "sink:0.2"), std::pair(&flat, "expr:1;0;4")}) {
    CAPTURE(spec, d->vertices.size());
    const auto made = make_guaranteed_mesh(*d, *field(spec, *d, 0.5), {});
    REQUIRE(made.ok());
    INFO(made.value().claim.reason);
    REQUIRE(made.value().claim.guarantee);
    CHECK(made.value().claim.theorem->proved_angle >= 20);
  }
}

TEST_CASE("a run that does not reach its guarantee says how far it came") {
  const domain d = polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  const auto asked = field("sink:12", d, 0.4);
  const auto made = make_guaranteed_mesh(d, *asked, {.max_sites = 300});
  REQUIRE(made.ok());
  CHECK_FALSE(made.value().certified());
  CHECK_FALSE(made.value().claim.guarantee);
  CHECK(made.value().claim.reason.find("no guarantee: with edges ") == 0);
  CHECK(made.value().outcome.sites <= 300);
}

TEST_CASE("what a certificate says of a guarantee is proved again") {
  const domain d = square();
  const auto made = make_guaranteed_mesh(d, *field("sink:1", d, 0.4), {});
  REQUIRE(made.ok());
  REQUIRE(made.value().claim.guarantee);
  const mesh& m = made.value().outcome.result;
  const auto contradictions = [&](auto change) {
    certificate claim = made.value().claim;
    change(*claim.guarantee);
    return verify(m, claim, {}).contradictions;
  };
  CHECK(contradictions([](guarantee_claim&) {}).empty());
  CHECK_FALSE(contradictions([](guarantee_claim& g) { g.sigma *= 0.5; }).empty());
  CHECK_FALSE(contradictions([](guarantee_claim& g) { g.eps *= 0.5; }).empty());
  CHECK_FALSE(contradictions([](guarantee_claim& g) { g.size_factor *= 2; }).empty());
  CHECK_FALSE(contradictions([](guarantee_claim& g) { g.times_least.reset(); }).empty());
  CHECK_FALSE(contradictions([](guarantee_claim& g) {
                g.size_factor = std::nextafter(g.size_factor, 9);
              }).empty());
  // Verifies with other bounds: the guarantee is that of the mesh and the bound in its certificate.
  for (const double bound : {10.0, 24.0}) {
    certificate claim = made.value().claim;
    audit_options asked;
    asked.angle_bound = bound;
    CHECK(verify(m, claim, asked).verified);
    claim.guarantee->eps *= 0.5;
    CHECK_FALSE(verify(m, claim, asked).verified);
  }
  const auto read = parse_certificate(certificate_text(made.value().claim), "again");
  REQUIRE(read.ok());
  REQUIRE(read.value().guarantee);
  CHECK(read.value().guarantee->eps == made.value().claim.guarantee->eps);

  // Makes a mesh to which the theorem does not apply: its certificate claims no guarantee.
  const auto plain = make_certified_mesh(d, *field("swirl:3", d, 0.4), {.limit_size = true});
  REQUIRE(plain.ok());
  certificate claim = plain.value().claim;
  claim.guarantee = guarantee_claim{};
  CHECK_FALSE(verify(plain.value().outcome.result, claim, {}).verified);
}

TEST_CASE("segments are divided by metric length, all parts between 1 and 1.2 times the shortest") {
  const domain d = polygon({{0, 0}, {7, 0.3}, {6, 9.1}, {-1.5, 4}});
  const auto metric = field("expr:1+x*x/20;0;1", d, 1);
  const auto divided = internal::divide_segments_evenly(d, *metric, 0.75, 0.9, 1000);
  REQUIRE(divided.ok());
  const double shift = 1.0 / 64 + 1e-3;  // with the error of an integral of length
  for (const internal::division& one : divided.value().of_each) {
    REQUIRE(one.points.size() >= 6);
    for (std::size_t i = 0; i + 1 < one.lengths.size(); ++i) {
      const double length = one.lengths[i + 1] - one.lengths[i];
      CHECK(length >= 0.75 * (1 - shift));
      CHECK(length <= 0.9 * (1 + shift));
    }
  }
}
