// SPDX-License-Identifier: MIT
//
// Runs the mesher and the auditor with four threads, mainly for the thread sanitizer (scripts/abuse
// threads); and makes two independent meshes at the same time.
#include <array>
#include <catch2/catch.hpp>
#include <thread>
#include <vector>

#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/mesher.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/thread_arena.hpp"

namespace asterism::testing {
namespace {

struct made_mesh {
  mesh_outcome outcome;
  bool certified = false;
};

// A field that all threads read at once.
made_mesh make(const domain& d, const metric_field& field, refinement_strategy strategy) {
  mesh_options options;
  options.strategy = strategy;
  options.angle_bound = strategy == refinement_strategy::poisson_darts ? 5 : 15;
  options.limit_size = true;
  auto made = make_mesh(d, field, options);
  if (!made) return {};
  audit_options judged;
  judged.angle_bound = options.angle_bound;
  judged.original = &d;
  const audit_report report = audit(made.value().result, judged);
  return {std::move(made).value(), report.certified};
}

// swirl:3 with edges of length `size`.
formula_field fine_swirl(double size) {
  return formula_field([size, swirl = swirl_field(3)](const point& q) {
    const metric_tensor m = swirl.at(q).value();
    const double s = 1 / (size * size);
    return metric_tensor{s * m.m11, s * m.m12, s * m.m22};
  });
}

}  // namespace

TEST_CASE("four threads make and audit the mesh of one", "[threads]") {
  const domain d = with_dangling_segments();
  const formula_field field = fine_swirl(0.1);
  std::array<made_mesh, 2> made;
  with_threads(1, [&] { made[0] = make(d, field, refinement_strategy::fill); });
  with_threads(4, [&] { made[1] = make(d, field, refinement_strategy::fill); });
  CHECK(made[0].outcome.sites > 300);
  CHECK(made[0].certified);
  CHECK(made[1].certified);
  CHECK(same(made[0].outcome.result, made[1].outcome.result));
}

TEST_CASE("meshes made at the same time do not know of each other", "[threads]") {
  const domain d = accepted(square());
  const formula_field field = fine_swirl(0.5);
  constexpr std::array strategies = {refinement_strategy::fill, refinement_strategy::voronoi_arcs,
                                     refinement_strategy::fill, refinement_strategy::poisson_darts};
  std::array<made_mesh, 4> alone, together;
  for (std::size_t k = 0; k < strategies.size(); ++k) alone[k] = make(d, field, strategies[k]);
  std::vector<std::thread> running;
  for (std::size_t k = 0; k < strategies.size(); ++k)
    running.emplace_back([&, k] { together[k] = make(d, field, strategies[k]); });
  for (std::thread& t : running) t.join();
  for (std::size_t k = 0; k < strategies.size(); ++k) {
    INFO("mesh " << k);
    CHECK(alone[k].outcome.sites > 10);
    CHECK(same(alone[k].outcome.result, together[k].outcome.result));
    CHECK(ending_text(alone[k].outcome) == ending_text(together[k].outcome));
  }
}

}  // namespace asterism::testing
