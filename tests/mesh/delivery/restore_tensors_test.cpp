// SPDX-License-Identifier: MIT
//
// Bounds the reach of stars' gaps before tensors are restored.
#include "asterism/mesh/delivery/restore_tensors.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "asterism/core/random.hpp"
#include "asterism/kernels/star_gap.hpp"
#include "asterism/mesh/adapt/consistency_repair.hpp"
#include "asterism/mesh/audit/gap_reach.hpp"
#include "asterism/mesh/mesher.hpp"
#include "fixtures/mesh_disorder.hpp"
#include "fixtures/mesh_to_change.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::adapting;

namespace {

metric_tensor random_tensor(splitmix64& random) {
  const double angle = random.real(0, 3.2), p = std::exp(random.real(3, 6)),
               q = std::exp(random.real(3, 6)), c = std::cos(angle), s = std::sin(angle);
  return {p * c * c + q * s * s, (p - q) * c * s, p * s * s + q * c * c};
}

// Numbers of gaps without a known reach: to the kernel's prepared gap, and both to it and to the
// auditor's bound of few operations.
struct unknown_gaps {
  std::size_t to_kernel = 0, to_both = 0;
};

unknown_gaps count_unknown(const editable_mesh& m) {
  unknown_gaps found;
  const auto at = [&m](vertex_index v) { return site{m.at(v).position, m.at(v).metric}; };
  for (const face& f : m.faces())
    for (std::size_t i = 0; f.exists() && i < 3; ++i) {
      if (f.segment[i] != none) continue;
      const site v = at(f.v[i]), x = at(f.v[after(i)]), y = at(f.v[before(i)]);
      if (std::isfinite(star_gap(v, x, y).reach())) continue;
      ++found.to_kernel;
      if (!std::isfinite(audit_detail::quick_reach(v, x, y))) ++found.to_both;
    }
  return found;
}

// Changes the tensors of one inner face until it has a gap whose reach the auditor's bound knows
// and the kernel does not. Returns whether one was found.
bool spoil_for_kernel(editable_mesh& m, splitmix64& random) {
  constexpr int most_tries = 4000;
  const std::vector<node> before = m.nodes();
  for (int i = 0; i < most_tries; ++i) {
    const face f = m.faces()[random.bits() % m.faces().size()];
    if (!f.exists()) continue;
    for (const vertex_index v : f.v) m.set_metric(v, random_tensor(random));
    const unknown_gaps found = count_unknown(m);
    if (found.to_kernel > 0 && found.to_both == 0) return true;
    for (const vertex_index v : f.v) m.set_metric(v, before[v].metric);
  }
  return false;
}

}  // namespace

TEST_CASE("a gap whose reach the auditor knows by few operations keeps its tensors") {
  const std::uint64_t seed = 4141;
  CAPTURE(seed);
  splitmix64 random(seed);
  const domain d = square();
  editable_mesh m = even_mesh(d, 0.15);
  REQUIRE(count_unknown(m).to_kernel == 0);
  REQUIRE(spoil_for_kernel(m, random));
  const std::vector<node> before = m.nodes();
  repair_options options;
  options.angle_bound = 0;
  options.most_rounds = 0;
  consistency_repair repair(m, options);
  bound_gaps(m, repair, {});
  for (vertex_index v = 0; v < before.size(); ++v)
    CHECK(identical(m.at(v).metric, before[v].metric));
}
