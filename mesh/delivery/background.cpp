// SPDX-License-Identifier: MIT
#include "asterism/mesh/delivery/background.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/adapt/sampled_background.hpp"
#include "asterism/mesh/gradation/nodal_gradation.hpp"
#include "asterism/mesh/metric/background_metric.hpp"
#include "asterism/mesh/metric/constant_field.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"

namespace asterism::internal {
namespace {

// Share of the work limit that the background may use.
constexpr double work_share = 0.1;

std::optional<mesh> coarse_mesh_in(const metric_tensor& m, const domain& d,
                                   const mesh_options& options) {
  constexpr std::size_t times_as_many = 3, at_least = 500;
  mesh_options coarse;
  coarse.angle_bound = 0;
  coarse.strategy = refinement_strategy::voronoi_arcs;
  coarse.max_sites = std::min(options.max_sites, times_as_many * d.vertices.size() + at_least);
  coarse.stop = options.stop;
  tier_counters decided;
  const star_predicates_on<filtered_kernel> stars_on(decided);
  const auto everywhere = same_everywhere(m);
  auto made = mesh_domain({stars_on, d, *everywhere, coarse, {}, work_share});
  if (!made || !made.value().complete) return std::nullopt;
  return std::move(made.value().result);
}

std::optional<metric_tensor> mean_at_vertices(const domain& d, const metric_field& field) {
  std::vector<metric_tensor> tensors;
  for (const point& q : d.vertices) {
    const auto there = field.at(q);
    if (!there) return std::nullopt;
    tensors.push_back(there.value());
  }
  return mean_of(tensors);
}

}  // namespace

std::optional<mesh> coarse_mesh(const domain& d, const metric_field& field,
                                const mesh_options& options) {
  if (auto made = coarse_mesh_in({1, 0, 1}, d, options)) return made;
  const auto mean = mean_at_vertices(d, field);
  if (!mean || !filtered_kernel().is_positive_definite(*mean)) return std::nullopt;
  return coarse_mesh_in(*mean, d, options);
}

std::optional<adapting::sampled_background> sample_field(const domain& d, const mesh& start,
                                                         const metric_field& field, double longest,
                                                         const cancellation& stop) {
  auto built = adapting::editable_mesh::build(d, start);
  if (!built) return std::nullopt;
  adapting::sampling_limits limits;
  limits.longest = longest;
  limits.stop = stop;
  return adapting::sample_background(std::move(built).value(), field, limits);
}

double sampled_variation(const mesh& nodes, std::size_t one_in) {
  const background_metric graph(nodes);
  std::vector<double> found;
  for (const graph_edge& e : graph.edges())
    found.push_back(adapting::log_variation({graph.places()[e.a], graph.tensors()[e.a]},
                                            {graph.places()[e.b], graph.tensors()[e.b]}));
  const auto place =
      found.begin() + static_cast<std::ptrdiff_t>(found.size() - 1 - found.size() / one_in);
  std::nth_element(found.begin(), place, found.end());
  return *place;
}

}  // namespace asterism::internal
