// SPDX-License-Identifier: MIT
//
// Certificates as text, and the verification of a mesh against one.
#include "asterism/mesh/audit/certificate.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include "asterism/mesh/audit/certificate_options.hpp"
#include "asterism/mesh/audit/verify.hpp"
#include "asterism/mesh/claims/measured_claims.hpp"
#include "asterism/mesh/io/certificate_json.hpp"
#include "asterism/mesh/io/certificate_writer.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "fixtures/audit_meshes.hpp"
#include "fixtures/temporary_directory.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::test;
using Catch::Contains;

namespace {

struct certified_patch {
  patch p = make_patch(5);
  certificate c;

  certified_patch() {
    p.m.sites[p.at(5, 2)].position.x = std::nextafter(p.m.sites[p.at(5, 2)].position.x, 9);
    audit_options options;
    options.angle_bound = 30;
    options.original = &p.d;
    c = make_certificate(p.m, options, audit(p.m, options));
    c.metric = "swirl:12";
    for (const std::string_view name : mesh_option_names) c.options[std::string(name)] = "none";
    c.options["refine"] = "voronoi";
    c.options["angle-bound"] = "30";
    c.options["certify"] = "stars";
    c.complete = true;
    c.reason = "every triangle agrees and meets the bound";
    c.mesher_counters.at(predicate::edge_test, tier::exact) = 12;
  }
};

}  // namespace

TEST_CASE("a certificate reads back as it was written") {
  const certified_patch made;
  const std::string text = certificate_text(made.c);
  const auto read = parse_certificate(text, "here");
  REQUIRE(read.ok());
  const certificate& c = read.value();
  CHECK(certificate_text(c) == text);
  CHECK(c.certified);
  CHECK(c.fingerprint == mesh_fingerprint(made.p.m));
  CHECK(c.largest_deviation == made.c.largest_deviation);
  CHECK(c.largest_deviation > 0);
  REQUIRE(c.original);
  CHECK(c.original->vertices == made.p.d.vertices);
  CHECK(c.original->segments.size() == 4);
  CHECK(c.original->segments[3].b == 0);
  CHECK(c.original->segments[3].marker == 13);
  CHECK(c.mesher_counters.at(predicate::edge_test, tier::exact) == 12);
  CHECK(c.options.at("refine") == "voronoi");
}

TEST_CASE("sides and regions of segments read back as they were written") {
  certified_patch made;
  made.p.d.segments.push_back({1, 3, 20, true, -4, 2147483647});
  made.p.d.segments[0].left_region = 0;
  made.c.original = made.p.d;
  const std::string text = certificate_text(made.c);
  const auto read = parse_certificate(text, "here");
  REQUIRE(read.ok());
  CHECK(certificate_text(read.value()) == text);
  const segment& last = read.value().original->segments.at(4);
  CHECK(last.internal);
  CHECK(last.left_region == -4);
  CHECK(last.right_region == 2147483647);
  CHECK(read.value().original->segments[0].left_region == 0);
  CHECK_FALSE(read.value().original->segments[1].internal);
  const auto without = [&](const std::string& old, const std::string& now) {
    const auto place = text.rfind(old);
    REQUIRE(place != std::string::npos);
    return parse_certificate(std::string(text).replace(place, old.size(), now), "c").ok();
  };
  CHECK_FALSE(without("2147483647", "0.5"));
  CHECK_FALSE(without("2147483647", "true"));
}

TEST_CASE("a certificate's text is that of its JSON, though long lists are written without it") {
  certified_patch made;
  domain& d = *made.c.original;
  d.vertices[1] = {-0.0, 1e-300};
  d.vertices[2] = {1e22, 0.1 + 0.2};
  d.segments[2].internal = true;
  d.segments[3].right_region = 7;
  made.c.metric = "\n \"domain\": {[]";
  const auto check = [&] { CHECK(certificate_text(made.c) == json_of(made.c).dump(1) + "\n"); };
  check();
  d.curves.emplace_back();
  check();
  d.segments.clear();
  check();
  d.vertices.clear();
  check();
  made.c.original.reset();
  check();
}

TEST_CASE("regions are part of the fingerprint") {
  mesh m = make_patch(2).m;
  const std::uint64_t without = mesh_fingerprint(m);
  m.regions.assign(m.triangles.size(), 1);
  CHECK(mesh_fingerprint(m) == without);
  m.regions[3] = 2;
  CHECK(mesh_fingerprint(m) != without);
}

TEST_CASE("through a file") {
  const certified_patch made;
  const tests::temporary_directory folder("certificate");
  const auto path = folder / "certificate.json";
  REQUIRE(write_certificate(path, made.c).ok());
  const auto read = read_certificate(path);
  REQUIRE(read.ok());
  CHECK(certificate_text(read.value()) == certificate_text(made.c));
  std::filesystem::remove(path);
  const auto missing = read_certificate(path);
  REQUIRE_FALSE(missing.ok());
  CHECK_THAT(missing.failure().message, Contains("certificate.json"));
  CHECK(missing.failure().code == error_code::unreadable_file);
  const auto endless = read_certificate("/dev/zero");
  REQUIRE_FALSE(endless.ok());
  CHECK_THAT(endless.failure().message, Contains("not a regular file"));
}

TEST_CASE("text that is no certificate") {
  const std::string text = certificate_text(certified_patch().c);
  const auto refused = [](const std::string& bad, const std::string& why) {
    const auto read = parse_certificate(bad, "c.json");
    REQUIRE_FALSE(read.ok());
    CHECK_THAT(read.failure().message, Contains("c.json:") && Contains(why));
    CHECK_THAT(read.failure().message, !Contains("json.exception"));
    CHECK(read.failure().code == error_code::malformed_file);
  };
  const auto with = [&](const std::string& old, const std::string& now) {
    const auto place = text.find(old);
    REQUIRE(place != std::string::npos);
    return std::string(text).replace(place, old.size(), now);
  };
  refused("", "this is not JSON");
  refused("[1, 2]", "this is not");
  refused(text.substr(0, text.size() / 2), "this is not JSON");
  refused(with("asterism certificate 2", "something else"), "this is not");
  refused(with("\"triangles\": 50", "\"triangles\": -50"), "\"triangles\" is not a count");
  refused(with("\"fingerprint\": \"", "\"fingerprint\": \"x"), "sixteen hexadecimal digits");
  refused(with("\"exempt_corners\": []", "\"exempt_corners\": [0]"), "counts nothing from 1");
  refused(with("\"certified\": true", "\"certified\": 1"), "\"certified\" is not what it should");
  refused(with("\"worst_angle\"", "\"worst\""), "\"worst_angle\" is missing");
  refused(with("\"not asked\"", "\"likely\""), "\"likely\", which is no verdict");
  refused(with("\"from 1\"", "\"from 0\""), "c.json:4: \"numbering\" is not what it should be");
  refused(with("\"certified\": true", "\"certified\": true, \"certified\": true"),
          "\"audit.certified\" is there twice");
  refused(with("\"certified\": true", "\"certified\": true, \"luck\": 1"),
          "\"audit.luck\" is no field of a certificate");
  refused(with("\"triangles\": 50", "\"triangles\": 1e999"), "beyond the range of doubles");
  refused(std::string(100000, '['), "this is no certificate");
  // Messages shorten names and values of any length.
  refused(with("\"certified\": true", "\"certified\": true, \"" + std::string(5000, 'a') + "\": 1"),
          "\"audit." + std::string(54, 'a') + "...\" is no field");
  refused(
      with("\"exempt_corners\": []", "\"exempt_corners\": [\"" + std::string(5000, 'b') + "\"]"),
      std::string(59, 'b') + "..., which counts nothing from 1");
  // The line named is that of the member itself, not of another member whose name ends alike.
  refused(with("\"outcome\": {\n", "\"outcome\": {\n\"mesh\": 1,\n"), "\"outcome.mesh\"");
}

TEST_CASE("the verdict on the Voronoi diagram is written, read, and checked when it is claimed") {
  certified_patch made;
  made.c.voronoi = voronoi_verdict::proved;
  made.c.options["certify"] = "voronoi";
  const std::string text = certificate_text(made.c);
  const auto read = parse_certificate(text, "c.json");
  REQUIRE(read.ok());
  CHECK(read.value().voronoi == voronoi_verdict::proved);
  const verify_report report = verify(made.p.m, read.value(), {});
  CHECK(report.verified);
  CHECK(report.audit.voronoi == voronoi_verdict::proved);
  // Without a verdict on the Voronoi diagram, none was asked for.
  const std::string line = "  \"voronoi\": \"proved\",\n";
  std::string old = text;
  REQUIRE(old.find(line) != std::string::npos);
  old.erase(old.find(line), line.size());
  CHECK_FALSE(parse_certificate(old, "c.json").ok());
}

TEST_CASE("a mesh is verified against its certificate") {
  const certified_patch made;
  const verify_report report = verify(made.p.m, made.c, {});
  INFO(kinds(report.audit));
  CHECK(report.verified);
  CHECK(report.audit.domain_checked);
  CHECK(report.audit.angles_checked);
}

TEST_CASE("an altered mesh is refused, and so is the certificate of another") {
  const certified_patch made;
  mesh m = made.p.m;
  SECTION("vertex moved") {
    m.sites[made.p.at(2, 2)].position.x += 0.01;
    const verify_report report = verify(m, made.c, {});
    CHECK(report.audit.certified);  // a good mesh, but not the certificate's
    CHECK_FALSE(report.verified);
    REQUIRE(report.contradictions.size() == 1);
    CHECK_THAT(report.contradictions[0], Contains("fingerprints differ"));
  }
  SECTION("triangle removed") {
    m.triangles.pop_back();
    const verify_report report = verify(m, made.c, {});
    CHECK_FALSE(report.verified);
    CHECK_FALSE(report.audit.certified);
    CHECK_THAT(report.contradictions[0], Contains("a mesh with 50 triangles, this one has 49"));
  }
  SECTION("the domain in the certificate altered") {
    certificate forged = made.c;
    forged.original->vertices[2].y += 1;
    const verify_report report = verify(m, forged, {});
    CHECK_FALSE(report.verified);
    CHECK(found(report.audit, finding_kind::given_changed));
  }
  SECTION("an incomplete mesh's certificate") {
    certificate honest = made.c;
    honest.complete = false;
    honest.reason = "stuck";
    CHECK_THAT(verify(m, honest, {}).contradictions[0], Contains("not completed: stuck"));
  }
}

TEST_CASE("without a certificate exempt corners are looked for") {
  const mesh narrow = make_mesh_of({{0, 0}, {1, 0}, {1, 0.2}}, {{0, 1, 2}});
  audit_options options;
  options.angle_bound = 20;
  const verify_report report = verify(narrow, std::nullopt, options);
  CHECK(report.verified);
  CHECK(report.audit.exempt_corners == std::vector<vertex_index>{0});
  options.angle_bound = 80;  // the corner of 90 degrees stays above
  CHECK(verify(narrow, std::nullopt, options).audit.exempt_corners.size() == 2);
}

TEST_CASE("witnesses count from the number asked for, and those of certificates from 1") {
  mesh m = make_mesh_of({{0, 0}, {8, 0}, {4, 1}, {4, 9}}, {{0, 1, 2}, {1, 3, 2}, {3, 0, 2}});
  audit_options options;
  options.angle_bound = 1;
  options.check_voronoi = true;
  certificate c = make_certificate(m, options, audit(m, options));
  REQUIRE(c.certified);
  REQUIRE_FALSE(c.witnesses.empty());
  CHECK_THAT(c.witnesses[0], Contains("vertex 1 (0, 0)"));
  c.complete = true;
  c.voronoi = voronoi_verdict::refused;
  options.first_number = 0;
  const verify_report report = verify(m, c, options);
  CHECK(report.contradictions.empty());
  CHECK_THAT(report.audit.findings.at(0).witness,
             Contains("vertex 0 (0, 0)") && !Contains("vertex 4 "));
  std::swap(m.triangles[0][1], m.triangles[0][2]);
  m.boundary.push_back({0, 9, 0, 0, false});
  const audit_report damaged = audit(m, options);
  CHECK_THAT(witnesses(damaged, finding_kind::orientation),
             Contains("triangle 0 of vertex 0 (0, 0)"));
  CHECK_THAT(witnesses(damaged, finding_kind::index_out_of_range),
             Contains("boundary edge 3 names vertex 9 of 4"));
}

TEST_CASE("a mesh that is not certified as claimed is audited once") {
  certified_patch made;
  made.c.angle_bound = 70;
  const auto spent = [&made](int first_number) {
    audit_options options;
    options.first_number = first_number;
    options.stop = cancellation().with_work(1e9);
    const verify_report report = verify(made.p.m, made.c, options);
    CHECK_FALSE(report.verified);
    CHECK_FALSE(report.audit.findings.empty());
    return 1e9 - options.stop.units_left();
  };
  CHECK(spent(0) > 0);
  CHECK(spent(0) == spent(1));
}

TEST_CASE("a refusing audit is written down") {
  patch p = make_patch(3);
  p.m.triangles.pop_back();
  const audit_options options;
  const certificate c = make_certificate(p.m, options, audit(p.m, options));
  const std::string text = certificate_text(c);
  CHECK_THAT(text, Contains("\"certified\": false") && Contains("\"unmatched_edge\": 1"));
  const auto read = parse_certificate(text, "c");
  REQUIRE(read.ok());
  CHECK(read.value().witnesses == c.witnesses);
  CHECK_FALSE(read.value().original);
}

TEST_CASE("altered numbers of a certificate passed") {
  certified_patch made;
  made.c.measured = by_name(measure(made.p.m));
  REQUIRE(verify(made.p.m, made.c, {}).verified);
  const auto refused_for = [&](const std::string& field, const auto& alter) {
    certificate altered = made.c;
    alter(altered);
    const verify_report report = verify(made.p.m, altered, {});
    INFO(field);
    CHECK_FALSE(report.verified);
    REQUIRE(report.contradictions.size() == 1);
    CHECK_THAT(report.contradictions[0], Contains("\"" + field + "\""));
  };
  const auto measured_otherwise = [&](const std::string& name, double value) {
    certificate altered = made.c;
    altered.measured[name] = value;
    const auto found = contradictions_in_measured(made.p.m, altered);
    INFO(name);
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0], Contains("\"measured." + name + "\""));
  };
  CHECK(contradictions_in_measured(made.p.m, made.c).empty());
  for (const auto& [name, value] : made.c.measured)
    measured_otherwise(name, std::nextafter(value, 1e300));
  measured_otherwise("luck", 1);
  refused_for("audit.worst_angle",
              [](certificate& c) { c.worst_angle = std::nextafter(c.worst_angle, 60); });
  refused_for("audit.largest_boundary_deviation", [](certificate& c) { c.largest_deviation = 0; });
  refused_for("audit.exempt_triangles", [](certificate& c) { c.exempt_triangles = {3}; });
  refused_for("audit.low_triangles", [](certificate& c) { c.low_triangles = {3}; });
  refused_for("audit.domain_checked", [](certificate& c) { c.domain_checked = false; });
  refused_for("audit.angles_checked", [](certificate& c) { c.angles_checked = false; });
  refused_for("audit.stars_checked", [](certificate& c) { c.stars_checked = false; });
  refused_for("audit.findings", [](certificate& c) { c.found["orientation"] = 1; });
  refused_for("audit.witnesses", [](certificate& c) { c.witnesses = {"orientation: none"}; });
  refused_for("asked.angle_bound", [](certificate& c) { c.options["angle-bound"] = "31"; });
  refused_for("theorem", [](certificate& c) { c.theorem.reset(); });
  refused_for("theorem.theorem_applies",
              [](certificate& c) { c.theorem->applies = !c.theorem->applies; });
  refused_for("theorem.reason", [](certificate& c) { c.theorem->reason += "."; });
  using hypotheses = theorem_hypotheses;
  for (const auto& [name, number] : {std::pair{"sigma_eps", &hypotheses::sigma_eps},
                                     {"proved_angle", &hypotheses::proved_angle},
                                     {"covering_radius", &hypotheses::covering_radius},
                                     {"spacing", &hypotheses::spacing},
                                     {"longest_subsegment", &hypotheses::longest_subsegment},
                                     {"distortion", &hypotheses::distortion},
                                     {"variation", &hypotheses::variation}})
    refused_for(std::string("theorem.") + name, [number = number](certificate& c) {
      double& value = (*c.theorem).*number;
      value = std::nextafter(value, 1e300);
    });
  // With another angle bound the audit may give another answer.
  audit_options lower;
  lower.angle_bound = 10;
  CHECK(verify(made.p.m, made.c, lower).verified);
}

TEST_CASE("numbers were not compared where the domain of the certificate was named") {
  const certified_patch made;
  audit_options named;
  named.original = &made.p.d;
  CHECK(verify(made.p.m, made.c, named).verified);
  certificate altered = made.c;
  altered.worst_angle = std::nextafter(altered.worst_angle, 60);
  const verify_report report = verify(made.p.m, altered, named);
  CHECK_FALSE(report.verified);
  REQUIRE(report.contradictions.size() == 1);
  CHECK_THAT(report.contradictions[0], Contains("\"audit.worst_angle\""));
}

TEST_CASE("a certificate without options passed for completed, whatever was delivered") {
  certified_patch made;
  made.c.options.clear();
  const auto first_of = [&] { return verify(made.p.m, made.c, {}).contradictions.at(0); };
  CHECK_THAT(first_of(), Contains("\"asked.options.angle-bound\" is missing"));
  made.c.metric.clear();
  CHECK(verify(made.p.m, made.c, {}).verified);
  made.c.delivered = delivered_report{};
  made.c.delivered->complexity_wanted = made.c.delivered->complexity_delivered = 1;
  CHECK(verify(made.p.m, made.c, {}).verified);
  made.c.delivered->median = made.c.delivered->greatest = 2.4;  // the distance exceeds ln 10
  CHECK_THAT(first_of(), Contains("of half of the sites"));
  made.c.options["metric-tolerance"] = "2.4";
  CHECK(verify(made.p.m, made.c, {}).verified);
  made.c.options["metric-tolerance"] = "2.3";
  CHECK_THAT(first_of(), Contains("where 2.3 is tolerated"));
  made.c.options["metric-tolerance"] = "soon";
  CHECK_THAT(first_of(), Contains("is no number of at least 0"));
  made.c.delivered.reset();
  made.c.options = {{"size", "1"}};
  CHECK_THAT(first_of(), Contains("\"asked.metric\" names no metric"));
}

TEST_CASE("what is measured of the theorem on nets is written and read, or null") {
  certified_patch made;
  REQUIRE(made.c.theorem);
  made.c.theorem->spacing = std::numeric_limits<double>::infinity();  // the mesh has one triangle
  const std::string text = certificate_text(made.c);
  CHECK_THAT(text, Contains("\"spacing\": null") && Contains("\"theorem_applies\""));
  const auto read = parse_certificate(text, "c.json");
  REQUIRE(read.ok());
  CHECK(certificate_text(read.value()) == text);
  CHECK(read.value().theorem->sigma_eps == made.c.theorem->sigma_eps);
  CHECK(read.value().theorem->reason == made.c.theorem->reason);
  patch refused = make_patch(3);
  refused.m.triangles.pop_back();
  audit_options options;
  options.angle_bound = 20;
  const certificate other = make_certificate(refused.m, options, audit(refused.m, options));
  CHECK_FALSE(other.theorem);
  CHECK_THAT(certificate_text(other), Contains("\"theorem\": null"));
}

TEST_CASE("where no angle is to judge a certificate said 180 degrees") {
  certified_patch made;
  made.c.worst_angle = 180;
  const std::string text = certificate_text(made.c);
  CHECK_THAT(text, Contains("\"worst_angle\": null"));
  const auto read = parse_certificate(text, "c.json");
  REQUIRE(read.ok());
  CHECK(read.value().worst_angle == 180);
}
