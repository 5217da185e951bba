// SPDX-License-Identifier: MIT
#include "asterism/mesh/gradation/graph_gradation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"
#include "asterism/mesh/numerics/nodal_sums.hpp"
#include "asterism/mesh/numerics/symmetric_eigen.hpp"

namespace asterism::internal {
namespace {

constexpr std::size_t most_rounds = 200;
// Relative difference of squared lengths below which a neighbour's demand is ignored: without it
// the rounds would continue with tiny changes.
constexpr double slack = 1e-3;

double eighth_root(double x) { return std::sqrt(std::sqrt(std::sqrt(x))); }

// Returns the tensor of p as it acts at the distance d.
metric_tensor grown(const metric_tensor& m, const point& d, double log_beta,
                    gradation_space space) {
  const double along = 1 + log_beta * plain_length(m, d);
  if (space == gradation_space::metric) {
    const double f = 1 / (along * along);
    return {f * m.m11, f * m.m12, f * m.m22};
  }
  const symmetric_eigen e = eigen_of(m);
  const double plain = std::sqrt(d.x * d.x + d.y * d.y), mostly = along / eighth_root(along);
  const auto reach = [&](double eigenvalue) {
    const double own = 1 + std::sqrt(std::max(eigenvalue, 0.0)) * plain * log_beta;
    const double factor = eighth_root(own) * mostly;
    return eigenvalue / (factor * factor);
  };
  return with_eigenvalues(e, reach(e.first), reach(e.second));
}

}  // namespace

graph_gradation grade_on_graph(const mesh& m, const mesh_links& links, double beta,
                               gradation_space space, std::vector<metric_tensor>& tensors) {
  const double log_beta = elementary::log(beta);
  graph_gradation done;
  std::vector<metric_tensor> next = tensors;
  std::vector<char> spoke(tensors.size(), 1), speaks(tensors.size(), 0), ever(tensors.size(), 0);
  while (done.rounds < most_rounds && !done.ended) {
    ++done.rounds;
    for_each_node(tensors.size(), [&](std::size_t q) {
      metric_tensor own = tensors[q];
      speaks[q] = 0;
      const point& at = m.sites[q].position;
      for (const vertex_index p : links.neighbours(static_cast<vertex_index>(q))) {
        // Skips a neighbour whose own tensor is no stronger: its limit at q never is either.
        if (spoke[p] == 0 || !exceeds(tensors[p], own, slack)) continue;
        const point d{at.x - m.sites[p].position.x, at.y - m.sites[p].position.y};
        const metric_tensor reached = grown(tensors[p], d, log_beta, space);
        if (!exceeds(reached, own, slack)) continue;
        own = intersection(own, reached);
        speaks[q] = ever[q] = 1;
      }
      next[q] = own;
    });
    std::swap(tensors, next);
    std::swap(spoke, speaks);
    done.ended = std::find(spoke.begin(), spoke.end(), char{1}) == spoke.end();
  }
  done.changed = static_cast<std::size_t>(std::count(ever.begin(), ever.end(), char{1}));
  return done;
}

}  // namespace asterism::internal
