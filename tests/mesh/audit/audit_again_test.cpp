// SPDX-License-Identifier: MIT
//
// Meshes audited again after tensors were changed, beside a whole audit.
#include "asterism/mesh/audit/audit_again.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>

#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::test;

namespace {

// Lists what was found, in an order of its own.
std::multiset<std::vector<asterism::vertex_index>> stars_found(const audit_report& report) {
  std::multiset<std::vector<asterism::vertex_index>> all;
  for (const audit_finding& f : report.findings)
    if (!f.vertices.empty()) all.insert(f.vertices);
  return all;
}

}  // namespace

TEST_CASE("an audit of what was changed finds what a whole audit finds") {
  splitmix64 random{7};
  patch p = make_patch(12);
  audit_options asked;
  asked.findings_kept = std::numeric_limits<std::size_t>::max();
  audit_report before = audit(p.m, asked);
  REQUIRE(before.certified);
  std::size_t findings = 0;
  for (int round = 0; round < 20; ++round) {
    std::set<asterism::vertex_index> changed;
    for (const audit_finding& f : before.findings)
      changed.insert(f.vertices.begin(), f.vertices.end());
    const std::vector<metric_tensor> choices = {{1, 0, 1}, {4, 1, 2}, {30, 0, 1}, {2, -1, 2}};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto v = static_cast<asterism::vertex_index>(
          random.real(0, static_cast<double>(p.m.sites.size())));
      p.m.sites[v].metric = choices[static_cast<std::size_t>(random.real(0, 4))];
      changed.insert(v);
    }
    const audit_report again = audit_again(p.m, asked, before, {changed.begin(), changed.end()});
    const audit_report whole = audit(p.m, asked);
    CHECK(again.certified == whole.certified);
    CHECK(again.found == whole.found);
    CHECK(stars_found(again) == stars_found(whole));
    CHECK(again.star_pairs >= before.star_pairs);
    findings += whole.total_found();
    before = again;
  }
  CHECK(findings > 100);
}
