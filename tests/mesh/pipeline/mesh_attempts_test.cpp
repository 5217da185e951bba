// SPDX-License-Identifier: MIT
//
// Leaves the last test of stars to the audit. The meshes are the same as with the mesher's own
// test, and certified.
#include "asterism/mesh/pipeline/mesh_attempts.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <numeric>
#include <string>
#include <vector>

#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/pipeline/attempt_rules.hpp"
#include "asterism/mesh/pipeline/star_refusal.hpp"

using namespace asterism;

namespace {

constexpr auto by_auditor = internal::star_confirmation::by_auditor;

// True if c is clearly on the left of the line from a to b.
bool is_left(const mesh& m, vertex_index a, vertex_index b, vertex_index c) {
  const point &p = m.sites[a].position, &q = m.sites[b].position, &r = m.sites[c].position;
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x) > 1e-6;
}

// Flips the i-th edge of t, if u has it too and their quadrilateral is strictly convex.
bool turn_edge(const mesh& m, triangle& t, triangle& u, std::size_t i) {
  const vertex_index a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
  for (std::size_t j = 0; j < 3; ++j) {
    const vertex_index e = u[(j + 2) % 3];
    if (u[j] != b || u[(j + 1) % 3] != a) continue;
    if (!is_left(m, a, e, c) || !is_left(m, e, b, c)) return false;
    t = {a, e, c};
    u = {e, b, c};
    return true;
  }
  return false;
}

bool turn_first_edge(mesh& m) {
  for (triangle& t : m.triangles)
    for (triangle& u : m.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        if (turn_edge(m, t, u, i)) return true;
  return false;
}

// Returns the table of the attempts, as docs/design/attempts.md must have it.
std::string table_of_attempts() {
  std::string table =
      "| Attempt | Metric | Work | Of stars | Made where |\n|---|---|---|---|---|\n";
  const auto percent = [](double part) {
    return std::to_string(static_cast<int>(std::lround(100 * part))) + " %";
  };
  for (const internal::attempt_rule& rule : internal::attempt_rules)
    table += "| " + std::string(rule.name) + " | " + std::string(rule.metric) + " | " +
             percent(rule.share_of_work) + " | " +
             (rule.share_of_stars > 0 ? percent(rule.share_of_stars) : "-") + " | " +
             std::string(rule.is_made) + " |\n";
  return table;
}

std::vector<mesh_attempt> tried_in(const mesh_outcome& made) {
  std::vector<mesh_attempt> all;
  for (const attempt_report& attempt : made.tried) all.push_back(attempt.what);
  return all;
}

}  // namespace

TEST_CASE("the page of attempts has the list that is gone through") {
  std::ifstream page(ASTERISM_DOCS "/design/attempts.md");
  REQUIRE(page);
  const std::string text((std::istreambuf_iterator<char>(page)), std::istreambuf_iterator<char>());
  const std::string table = table_of_attempts();
  INFO("docs/design/attempts.md is to have\n" << table);
  CHECK(text.find(table) != std::string::npos);
  for (std::size_t i = 0; i < internal::attempt_count; ++i)
    CHECK(static_cast<std::size_t>(internal::attempt_rules[i].what) == i);
}

TEST_CASE("an outcome says what was tried, in order, and what was chosen") {
  const domain d = square();
  mesh_options options;
  options.angle_bound = 20;
  options.limit_size = true;
  const auto smooth = make_metric_field("swirl:2", d.box(), 0.2);
  REQUIRE(smooth);
  const auto kept = make_mesh(d, *smooth.value(), options);
  REQUIRE(kept);
  CHECK(kept.value().complete);
  CHECK(kept.value().chosen == kept.value().tried.back().what);
  CHECK(kept.value().tried.back().how == ending::complete);
  // The metric rotates by a large angle along an edge, so that stars do not agree in it.
  const auto wild = make_metric_field("swirl:1000", d.box(), 0.2);
  REQUIRE(wild);
  const auto delivered = make_mesh(d, *wild.value(), options);
  REQUIRE(delivered);
  CHECK(delivered.value().tried.size() > 1);
  CHECK(tried_in(delivered.value()).front() == mesh_attempt::requested_briefly);
  CHECK(std::is_sorted(
      delivered.value().tried.begin(), delivered.value().tried.end(),
      [](const attempt_report& a, const attempt_report& b) { return a.what < b.what; }));
  CHECK(delivered.value().chosen == mesh_attempt::delivered);
  options.metric_tolerance = 0;
  const auto strict = make_mesh(d, *wild.value(), options);
  REQUIRE(strict);
  CHECK(tried_in(strict.value()).front() == mesh_attempt::requested);
  CHECK(strict.value().chosen == mesh_attempt::requested);
  CHECK_FALSE(strict.value().complete);
}

TEST_CASE(
    "meshes whose last look at stars is left to the audit are certified, and mostly the same") {
  // A star that the mesher's own test refuses might have been correct after a later site. The
  // meshes may then differ.
  constexpr int most_others = 1;
  int others = 0;
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
                   trusted = internal::make_by_attempts(d, *field.value(), options, {}, by_auditor);
        REQUIRE(confirmed);
        REQUIRE(trusted);
        CHECK(trusted.value().complete == confirmed.value().complete);
        const mesh &a = confirmed.value().result, &b = trusted.value().result;
        const bool is_same =
            a.triangles == b.triangles &&
            std::equal(a.sites.begin(), a.sites.end(), b.sites.begin(), b.sites.end());
        others += is_same ? 0 : 1;
        CHECK(judge_outcome(trusted.value(), d, options).certified() == trusted.value().complete);
      }
  CHECK(others <= most_others);
}

TEST_CASE("whether neighbours plainly stand is asked by the audit alone, and most are plain") {
  const domain d = square();
  const auto field = make_metric_field("swirl:12", d.box(), 0.1);
  REQUIRE(field);
  mesh_options options;
  options.angle_bound = 20;
  options.limit_size = true;
  options.strategy = refinement_strategy::fill;
  const auto trusted = internal::make_by_attempts(d, *field.value(), options, {}, by_auditor),
             confirmed = make_mesh(d, *field.value(), options);
  REQUIRE(trusted);
  REQUIRE(confirmed);
  const auto edge_tests = [](const mesh_outcome& made) {
    const auto& decided = made.counters.decided[static_cast<std::size_t>(predicate::edge_test)];
    return std::accumulate(decided.begin(), decided.end(), std::uint64_t{0});
  };
  const std::size_t edges = 3 * trusted.value().result.triangles.size() / 2;
  CHECK(edge_tests(trusted.value()) < edges / 3);
  CHECK(edge_tests(confirmed.value()) > edges / 2);
}

TEST_CASE("sites that are given have their last look by the audit too, and the same mesh") {
  const domain d = add_random_points(square(), 1000, 1).value();
  const auto field = make_metric_field("swirl:12", d.box());
  REQUIRE(field);
  for (const double bound : {0.0, 20.0}) {
    CAPTURE(bound);
    mesh_options options;
    options.angle_bound = bound;
    options.max_sites = 10'000;
    options.strategy = refinement_strategy::fill;
    const auto confirmed = make_mesh(d, *field.value(), options),
               trusted = internal::make_by_attempts(d, *field.value(), options, {}, by_auditor);
    REQUIRE(confirmed);
    REQUIRE(trusted);
    const mesh &a = confirmed.value().result, &b = trusted.value().result;
    CHECK(a.triangles == b.triangles);
    CHECK(std::equal(a.sites.begin(), a.sites.end(), b.sites.begin(), b.sites.end()));
    CHECK(judge_outcome(trusted.value(), d, options).certified());
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
             made = internal::make_by_attempts(d, *field.value(), options, {}, by_auditor);
  REQUIRE(confirmed);
  REQUIRE(made);
  CHECK(made.value().counters.decided == confirmed.value().counters.decided);
  CHECK(made.value().result.triangles == confirmed.value().result.triangles);
}

TEST_CASE("a mesh that the audit refuses for a star is to be made once more, and no other") {
  const domain d = square();
  const auto field = make_metric_field("swirl:6", d.box(), 0.3);
  REQUIRE(field);
  mesh_options options;
  options.angle_bound = 0;
  options.limit_size = true;
  const auto made = internal::make_by_attempts(d, *field.value(), options, {}, by_auditor);
  REQUIRE(made);
  const auto is_refused = [&](const mesh_outcome& outcome) {
    const certified_mesh judged = judge_outcome(outcome, d, options);
    return internal::is_refused_for_a_star(judged.outcome, judged.report, options);
  };
  CHECK_FALSE(is_refused(made.value()));

  mesh_outcome turned = made.value();
  REQUIRE(turn_first_edge(turned.result));
  CHECK(is_refused(turned));
  turned.complete = false;
  CHECK_FALSE(is_refused(turned));
  turned.complete = true;
  options.improve_passes = 1;
  CHECK_FALSE(is_refused(turned));
}
