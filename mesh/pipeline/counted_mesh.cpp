// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/counted_mesh.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "asterism/mesh/delivery/count_search.hpp"
#include "asterism/mesh/stars/work_limit.hpp"

namespace asterism {
namespace {

result<counted_mesh> make_at(double density, const mesh_source& source, const mesh_options& options,
                             const mesh_maker& make) {
  auto input = prepare_mesh_input(source, options, density);
  if (!input) return input.failure();
  mesh_options aiming = options;
  if (options.vertices)
    aiming.vertices = internal::count_aimed_at(*options.vertices, density, options.max_sites);
  auto made = make(input.value(), aiming);
  if (!made) return made.failure();
  return counted_mesh{std::move(input).value(), std::move(made).value()};
}

}  // namespace

result<counted_mesh> make_counted_mesh(const mesh_source& source, const mesh_options& options,
                                       const mesh_maker& make) {
  auto first = make_at(1, source, options, make);
  if (!first) return first;
  return meet_vertices(std::move(first).value(), source, options, make);
}

// Searches by making meshes, since the number of vertices does not follow from the area alone:
// sharp corners, narrow parts and a metric that varies may add vertices, and long chords leave some
// out.
counted_mesh meet_vertices(counted_mesh nearest, const mesh_source& source,
                           const mesh_options& options, const mesh_maker& make) {
  if (!options.vertices || !nearest.made.certified()) return nearest;
  constexpr int most_times = 10;
  constexpr double part_of_run = 0.3;
  constexpr double slowest_growth = 0.25;  // for boundaries with narrow parts
  mesh_options bounded = options;
  bounded.stop = options.stop.with_work(part_of_run * internal::units_for_run,
                                        part_of_run * internal::run_units_for_site);
  internal::count_search search(static_cast<double>(*options.vertices), slowest_growth);
  std::size_t sites = nearest.made.outcome.sites;
  search.take(static_cast<double>(sites));
  for (int times = 0; times < most_times && !bounded.stop.is_requested(); ++times) {
    if (is_count_near(*options.vertices, sites)) break;
    auto other = make_at(search.factor(), source, bounded, make);
    if (!other || !other.value().made.certified()) break;
    sites = other.value().made.outcome.sites;
    if (search.take(static_cast<double>(sites))) nearest = std::move(other).value();
  }
  return nearest;
}

bool is_count_near(std::size_t wanted, std::size_t delivered) {
  constexpr double tolerable = 0.05;
  const auto n = static_cast<double>(wanted);
  return std::abs(static_cast<double>(delivered) - n) <= tolerable * n;
}

}  // namespace asterism
