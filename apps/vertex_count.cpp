// SPDX-License-Identifier: MIT
#include "asterism/apps/vertex_count.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "asterism/mesh/pipeline/count_search.hpp"
#include "asterism/mesh/stars/work_limit.hpp"

namespace asterism::apps {
namespace {

// Part of those wanted by which there may be more or fewer.
constexpr double tolerable = 0.05;

bool is_near(std::size_t wanted, std::size_t delivered) {
  const auto n = static_cast<double>(wanted);
  return std::abs(static_cast<double>(delivered) - n) <= tolerable * n;
}

}  // namespace

std::size_t vertices_aimed_at(const mesh_job& job) {
  constexpr double fewest = 3;
  const double aim = job.vertices_factor * static_cast<double>(*job.refinement.vertices);
  return static_cast<std::size_t>(
      std::clamp(std::round(aim), fewest, static_cast<double>(job.refinement.max_sites)));
}

// A domain, its sharp corners and a metric that varies may each take more vertices than the area,
// or its chords fewer: then it helps to aim at others.
void meet_vertex_count(const mesh_job& job, const cancellation& stop, const make_mesh_of_job& make,
                       prepared_input& input, certified_mesh& made) {
  constexpr int most_times = 10;
  const auto wanted = job.refinement.vertices;
  if (!wanted || !made.certified() || is_near(*wanted, made.outcome.sites)) return;
  constexpr double part_of_run = 0.3;
  const cancellation bounded = stop.with_work(part_of_run * internal::units_for_run,
                                              part_of_run * internal::run_units_for_site);
  constexpr double slowest_growth = 0.25;  // a boundary with narrow parts takes what it takes
  internal::count_search search(static_cast<double>(*wanted), slowest_growth);
  search.take(static_cast<double>(made.outcome.sites));
  mesh_job other = job;
  for (int times = 0; times < most_times && !bounded.is_requested(); ++times) {
    other.vertices_factor = search.factor();
    mesh_job once_more = other;
    once_more.quiet = true;  // what there is to say of the domain was said
    auto prepared = prepare(once_more);
    if (!prepared) return;
    auto tried = make(other, prepared.value(), bounded);
    if (!tried || !tried.value().certified()) return;
    const std::size_t sites = tried.value().outcome.sites;
    if (!search.take(static_cast<double>(sites))) continue;
    input = std::move(prepared).value();
    made = std::move(tried).value();
    if (is_near(*wanted, sites)) return;
  }
}

std::string vertex_count_text(std::size_t wanted, std::size_t delivered) {
  const double more = 100 * (static_cast<double>(delivered) / static_cast<double>(wanted) - 1);
  return fmt::format("vertices: {} wanted, {} delivered ({:+.1f} %{})", wanted, delivered, more,
                     is_near(wanted, delivered) ? "" : ": none nearer to that were found");
}

}  // namespace asterism::apps
