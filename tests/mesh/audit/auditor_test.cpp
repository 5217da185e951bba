// SPDX-License-Identifier: MIT
//
// Audits meshes again after tensors were changed, and compares the outcome with that of an audit
// from the beginning.
#include "asterism/mesh/audit/auditor.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "asterism/mesh/audit/checked_triangulation.hpp"
#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::test;

namespace {

// Lists the findings in a fixed order.
std::multiset<std::vector<asterism::vertex_index>> stars_found(const audit_report& report) {
  std::multiset<std::vector<asterism::vertex_index>> all;
  for (const audit_finding& f : report.findings)
    if (!f.vertices.empty()) all.insert(f.vertices);
  return all;
}

void check_same_angles(const audit_report& again, const audit_report& whole) {
  CHECK(again.worst_ordinary.degrees == whole.worst_ordinary.degrees);
  CHECK(again.worst_ordinary.triangle == whole.worst_ordinary.triangle);
  CHECK(again.worst_collateral.degrees == whole.worst_collateral.degrees);
  CHECK(again.worst_exempt.degrees == whole.worst_exempt.degrees);
  CHECK(again.low_triangles == whole.low_triangles);
  CHECK(again.collateral_triangles == whole.collateral_triangles);
  CHECK(again.exempt_triangles == whole.exempt_triangles);
  CHECK(again.exempt_corners == whole.exempt_corners);
}

// Flips an edge of the triangle if both new triangles are counter-clockwise. Returns the triangle
// on its other side.
std::optional<std::size_t> flip_some_edge(mesh& m, std::size_t t) {
  const auto area = [&m](asterism::vertex_index a, asterism::vertex_index b,
                         asterism::vertex_index c) {
    const point &p = m.sites[a].position, &q = m.sites[b].position, &r = m.sites[c].position;
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  for (std::size_t s = 0; s < m.triangles.size(); ++s)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        asterism::triangle &f = m.triangles[t], &g = m.triangles[s];
        const auto a = f[i], b = f[(i + 1) % 3], c = f[(i + 2) % 3], d = g[(k + 2) % 3];
        if (g[k] != b || g[(k + 1) % 3] != a || area(c, a, d) < 0.1 || area(d, b, c) < 0.1)
          continue;
        f = {c, a, d};
        g = {d, b, c};
        return s;
      }
  return std::nullopt;
}

// A patch whose metrics are long in random directions.
patch make_turned_patch(splitmix64& random) {
  patch p = make_patch(8);
  for (site& s : p.m.sites) {
    const double turn = random.real(0, 3), c = std::cos(turn), d = std::sin(turn);
    s.metric = {c * c + 40 * d * d, -39 * c * d, d * d + 40 * c * c};
  }
  return p;
}

std::size_t count_open_gaps(const std::vector<open_question>& open) {
  return static_cast<std::size_t>(
      std::count_if(open.begin(), open.end(),
                    [](const open_question& q) { return q.what == open_question::about::gap; }));
}

constexpr audit_effort quickly = {hard_questions::left_open};

}  // namespace

TEST_CASE("an audit of what was changed finds what a whole audit finds") {
  splitmix64 random{7};
  patch p = make_patch(12);
  audit_options asked;
  asked.findings_kept = std::numeric_limits<std::size_t>::max();
  asked.angle_bound = 30;
  asked.find_exempt_corners = true;
  auditor judge(p.m, asked);
  audit_report before = judge.run();
  REQUIRE(before.certified);
  std::size_t findings = 0, exempt = 0;
  for (int round = 0; round < 20; ++round) {
    std::set<asterism::vertex_index> changed;
    for (const audit_finding& f : before.findings)
      changed.insert(f.vertices.begin(), f.vertices.end());
    const std::vector<metric_tensor> choices = {{1, 0, 1}, {4, 1, 2}, {30, 0, 1}, {10, -9, 10}};
    for (std::size_t i = 0; i < 5; ++i) {
      const auto v = i == 0 ? p.at(0, 0)
                            : static_cast<asterism::vertex_index>(
                                  random.real(0, static_cast<double>(p.m.sites.size())));
      p.m.sites[v].metric = choices[static_cast<std::size_t>(random.real(0, 4))];
      changed.insert(v);
    }
    const audit_report again = judge.recheck({changed.begin(), changed.end()});
    const audit_report whole = audit(p.m, asked);
    CHECK(again.certified == whole.certified);
    CHECK(again.found == whole.found);
    CHECK(stars_found(again) == stars_found(whole));
    CHECK(again.star_pairs >= before.star_pairs);
    check_same_angles(again, whole);
    findings += whole.total_found();
    exempt += whole.exempt_corners.size();
    before = again;
  }
  CHECK(findings > 100);
  CHECK(exempt > 3);
}

TEST_CASE("an audit of triangles and places that were changed finds what a whole audit finds") {
  splitmix64 random{9};
  patch p = make_patch(12);
  audit_options asked;
  asked.findings_kept = std::numeric_limits<std::size_t>::max();
  asked.angle_bound = 10;
  auditor judge(p.m, asked);
  audit_report before = judge.run(quickly);
  REQUIRE(before.certified);
  std::size_t findings = 0, flipped = 0;
  const auto any_of = [&](std::size_t count) {
    return static_cast<std::size_t>(random.real(0, static_cast<double>(count)));
  };
  for (int round = 0; round < 40; ++round) {
    std::set<asterism::vertex_index> changed;
    for (const audit_finding& f : before.findings)
      changed.insert(f.vertices.begin(), f.vertices.end());
    for (const open_question& q : judge.open()) changed.insert(q.sites.begin(), q.sites.end());
    // Changes tensors alone in every third round: the triangulation is then passed on.
    const bool moves = round % 3 > 0;
    for (int k = 0; k < 2 && moves; ++k) {
      const std::size_t t = any_of(p.m.triangles.size());
      if (const auto s = flip_some_edge(p.m, t)) {
        for (const std::size_t each : {t, *s})
          changed.insert(p.m.triangles[each].begin(), p.m.triangles[each].end());
        ++flipped;
      }
    }
    const int i = 1 + static_cast<int>(any_of(10)), j = 1 + static_cast<int>(any_of(10));
    site& moved = p.m.sites[p.at(i, j)];
    if (moves) moved.position.x += random.real(-0.02, 0.02);
    moved.metric = {random.real(1, 3), random.real(-0.3, 0.3), random.real(1, 3)};
    changed.insert(p.at(i, j));
    const audit_report again = judge.recheck({changed.begin(), changed.end()});
    const audit_report whole = audit(p.m, asked);
    CHECK(again.certified == whole.certified);
    CHECK(again.found == whole.found);
    CHECK(stars_found(again) == stars_found(whole));
    check_same_angles(again, whole);
    findings += whole.total_found();
    before = again;
  }
  CHECK(findings > 100);
  CHECK(flipped > 20);
}

TEST_CASE("an audit of changes that damage a triangulation says what a whole audit says") {
  const std::uint64_t seed = 12;
  CAPTURE(seed);
  splitmix64 random(seed);
  std::array<std::size_t, 7> refused{};
  for (std::size_t round = 0; round < 210; ++round) {
    CAPTURE(round);
    patch p = make_patch(12);
    mesh& m = p.m;
    auditor judge(m, {});
    REQUIRE(judge.run(quickly).certified);
    const std::vector<asterism::triangle> before = m.triangles;
    const std::size_t t = random.bits() % m.triangles.size(), i = random.bits() % 3;
    const std::size_t s = random.bits() % m.triangles.size();
    const auto v = static_cast<asterism::vertex_index>(random.bits() % m.sites.size());
    const std::size_t damage = round % refused.size();
    switch (damage) {
      case 0:
        m.triangles[t][i] = v;
        break;
      case 1:
        m.triangles[t][i] = static_cast<asterism::vertex_index>(m.sites.size() + i);
        break;
      case 2:
        std::swap(m.triangles[t][0], m.triangles[t][i]);
        break;
      case 3:
        m.triangles[t] = m.triangles[s];
        break;
      case 4:
        m.sites[v].position.x += random.real(0, 3);
        break;
      case 5:
        m.sites[v].position.y = std::numeric_limits<double>::quiet_NaN();
        break;
      default:
        std::swap(m.triangles[t][i], m.triangles[s][i]);
    }
    std::set<asterism::vertex_index> changed = {v};
    for (std::size_t k = 0; k < before.size(); ++k)
      if (before[k] != m.triangles[k])
        for (const asterism::vertex_index w : m.triangles[k])
          if (w < m.sites.size()) changed.insert(w);
    const audit_report again = judge.recheck({changed.begin(), changed.end()});
    const audit_report whole = audit(m, {});
    CHECK(again.certified == whole.certified);
    CHECK(again.found == whole.found);
    REQUIRE(again.findings.size() == whole.findings.size());
    for (std::size_t k = 0; k < whole.findings.size() && whole.findings[k].vertices.empty(); ++k)
      CHECK(again.findings[k].witness == whole.findings[k].witness);
    refused[damage] += whole.certified ? 0 : 1;
  }
  for (const std::size_t of_kind : refused) CHECK(of_kind > 5);
}

TEST_CASE("how far stars reach was remembered in units that the next audit did not have") {
  // All metrics are divided by a power of two that depends on the largest entry.
  const double large = std::ldexp(1, 70);
  patch p = make_patch(10, 0.05, {large, 0, large});
  site& largest = p.m.sites[p.at(0, 0)];
  largest.metric = {std::ldexp(1, 82), 0, std::ldexp(1, 82)};
  audit_options asked;
  asked.findings_kept = std::numeric_limits<std::size_t>::max();
  auditor judge(p.m, asked);
  const audit_report before = judge.run(quickly);
  std::set<asterism::vertex_index> changed = {p.at(0, 0), p.at(5, 5)};
  for (const audit_finding& f : before.findings)
    changed.insert(f.vertices.begin(), f.vertices.end());
  for (const open_question& q : judge.open()) changed.insert(q.sites.begin(), q.sites.end());
  largest.metric = {large, 0, large};
  // With a smaller tensor this site is nearer than others to the sites around its neighbours.
  p.m.sites[p.at(5, 5)].metric = {large / 8, 0, large / 8};
  const audit_report again = judge.recheck({changed.begin(), changed.end()});
  const audit_report whole = audit(p.m, asked);
  CHECK(whole.total_found() > 10);
  CHECK(stars_found(again) == stars_found(whole));
}

TEST_CASE("a mesh is not certified while a question that only exact numbers answer is open") {
  // All four sites are equally far from the middle of their circle: a tie, of which one diagonal is
  // right.
  int certified = 0;
  for (const bool other : {false, true}) {
    using triangles = std::vector<asterism::triangle>;
    mesh m =
        make_mesh_of({{0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}, {0.5, -0.5}},
                     other ? triangles{{0, 1, 3}, {1, 2, 3}} : triangles{{0, 1, 2}, {0, 2, 3}});
    for (site& s : m.sites) {
      const double x = s.position.x, y = s.position.y;
      s.metric = {1 + 12 * x * x, 12 * x * y, 1 + 12 * y * y};
    }
    const audit_report whole = audit(m, {});
    auditor judge(m, {});
    const audit_report quick = judge.run(quickly);
    CHECK(quick.total_found() == 0);
    CHECK_FALSE(quick.certified);
    CHECK_FALSE(judge.open().empty());
    CHECK(quick.counters.at(predicate::edge_test, tier::exact) == 0);
    CHECK(whole.counters.at(predicate::edge_test, tier::exact) > 0);
    const std::vector<asterism::vertex_index> all = {0, 1, 2, 3};
    CHECK_FALSE(judge.recheck(all, quickly).certified);
    CHECK_FALSE(judge.open().empty());
    const audit_report asked = judge.recheck(all);
    CHECK(asked.certified == whole.certified);
    CHECK(asked.found == whole.found);
    certified += asked.certified ? 1 : 0;
  }
  CHECK(certified == 1);
}

TEST_CASE("what an audit leaves open and what it finds is what a whole audit finds, and more") {
  splitmix64 random{8};
  std::size_t gaps = 0;
  for (int round = 0; round < 20; ++round) {
    const patch p = make_turned_patch(random);
    audit_options asked;
    asked.findings_kept = std::numeric_limits<std::size_t>::max();
    auditor judge(p.m, asked);
    const audit_report whole = audit(p.m, asked), quick = judge.run(quickly);
    const auto found_by_whole = stars_found(whole), found_quickly = stars_found(quick);
    CHECK(std::includes(found_by_whole.begin(), found_by_whole.end(), found_quickly.begin(),
                        found_quickly.end()));
    gaps += count_open_gaps(judge.open());
    std::vector<asterism::vertex_index> all(p.m.sites.size());
    std::iota(all.begin(), all.end(), asterism::vertex_index{0});
    const audit_report again = judge.recheck(all);
    CHECK(stars_found(again) == found_by_whole);
    CHECK(judge.open().empty());
  }
  CHECK(gaps > 20);
}

TEST_CASE("a gap of which no reach is known is left open where there are many sites alone") {
  splitmix64 random{8};
  std::size_t with_many = 0, with_few = 0, found = 0;
  for (int round = 0; round < 5; ++round) {
    const patch p = make_turned_patch(random);
    audit_options asked;
    asked.findings_kept = std::numeric_limits<std::size_t>::max();
    auditor many(p.m, asked), few(p.m, asked);
    const audit_report left_open = many.run({hard_questions::left_open, p.m.sites.size()});
    const audit_report held = few.run({hard_questions::left_open, p.m.sites.size() + 1});
    with_many += count_open_gaps(many.open());
    with_few += count_open_gaps(few.open());
    const auto of_all = stars_found(audit(p.m, asked)), of_held = stars_found(held);
    CHECK(std::includes(of_all.begin(), of_all.end(), of_held.begin(), of_held.end()));
    if (of_held.size() > stars_found(left_open).size()) ++found;
  }
  CHECK(with_many > 0);
  CHECK(with_few == 0);
  CHECK(found > 0);
}

TEST_CASE("a gap with many open questions is left open itself") {
  splitmix64 random{8};
  constexpr std::size_t most = 2;
  std::size_t gaps = 0, fewer = 0;
  for (int round = 0; round < 20; ++round) {
    const patch p = make_turned_patch(random);
    audit_options asked;
    asked.findings_kept = std::numeric_limits<std::size_t>::max();
    const std::size_t of_few = p.m.sites.size() + 1;
    auditor all(p.m, asked), some(p.m, asked);
    all.run({hard_questions::left_open, of_few});
    some.run({hard_questions::left_open, of_few, most});
    std::map<std::array<asterism::vertex_index, 3>, std::size_t> questions, kept;
    const auto count = [](const std::vector<open_question>& open, auto& by_gap) {
      for (const open_question& q : open)
        if (q.what == open_question::about::other_site)
          ++by_gap[{q.sites[0], q.sites[2], q.sites[3]}];
    };
    count(all.open(), questions);
    count(some.open(), kept);
    std::size_t many = 0;
    for (const auto& [gap, number] : questions) {
      CHECK(kept[gap] == std::min(number, most));
      many += number >= most;
      fewer += number - kept[gap];
    }
    CHECK(count_open_gaps(some.open()) == many);
    gaps += many;
    std::vector<asterism::vertex_index> every(p.m.sites.size());
    std::iota(every.begin(), every.end(), asterism::vertex_index{0});
    CHECK(stars_found(some.recheck(every)) == stars_found(audit(p.m, asked)));
  }
  CHECK(gaps > 5);
  CHECK(fewer > 5);
}

TEST_CASE("parts of an audit find what the whole of it finds") {
  const std::uint64_t seed = 11;
  CAPTURE(seed);
  splitmix64 random(seed);
  std::size_t low = 0, refused = 0;
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    patch p = make_turned_patch(random);
    const auto some = [&](std::size_t count) {
      return static_cast<std::size_t>(random.real(0, static_cast<double>(count)));
    };
    if (round % 4 == 1) p.m.triangles.erase(p.m.triangles.begin() + some(p.m.triangles.size()));
    if (round % 4 == 2) std::swap(p.m.triangles[some(p.m.triangles.size())][0], p.m.boundary[0].a);
    if (round % 4 == 3) p.m.sites[some(p.m.sites.size())].position.x += 2;
    audit_options asked;
    asked.check_stars = false;
    asked.findings_kept = std::numeric_limits<std::size_t>::max();
    const audit_report without_angles = audit(p.m, asked);
    const audit_report covering = auditor(p.m, asked).check_triangulation();
    CHECK(covering.certified == without_angles.certified);
    CHECK(covering.found == without_angles.found);
    asked.angle_bound = 20;
    asked.find_exempt_corners = true;
    const audit_report whole = audit(p.m, asked);
    const audit_report angles = auditor(p.m, asked).check_angles();
    CHECK(angles.worst().degrees == whole.worst().degrees);
    CHECK(angles.refused_triangles() == whole.refused_triangles());
    CHECK(angles.exempt_corners == whole.exempt_corners);
    low += whole.refused_triangles().size();
    refused += !covering.certified;
  }
  CHECK(low > 1000);
  CHECK(refused >= 30);
}

TEST_CASE("angles of a mesh audited before are those that are found without that audit") {
  splitmix64 random{5};
  patch p = make_patch(12);
  audit_options asked;
  asked.angle_bound = 30;
  asked.find_exempt_corners = true;
  auditor judge(p.m, asked);
  judge.run({hard_questions::left_open});
  const past_audit before{judge.report(), judge.memory()};
  REQUIRE(before.memory.triangulation != nullptr);
  std::size_t low = 0;
  for (int round = 0; round < 10; ++round) {
    mesh other = p.m;
    for (site& s : other.sites) s.metric.m11 *= random.real(1, 30);
    CHECK(before.memory.triangulation->has_lists_of(other));
    // Moves a vertex in half of the rounds: the lists are then made anew.
    if (round % 2 == 1) {
      other.sites[p.at(5, 5)].position.x += 0.1;
      CHECK_FALSE(before.memory.triangulation->has_lists_of(other));
    }
    const audit_report again = auditor(other, asked, before).check_angles();
    const audit_report anew = auditor(other, asked).check_angles();
    check_same_angles(again, anew);
    low += anew.refused_triangles().size();
  }
  CHECK(low > 100);
}
