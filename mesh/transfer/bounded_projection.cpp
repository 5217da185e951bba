// SPDX-License-Identifier: MIT
#include "asterism/mesh/transfer/bounded_projection.hpp"

#include <algorithm>
#include <cstddef>

#include "asterism/mesh/numerics/nodal_sums.hpp"

namespace asterism::internal {
namespace {

class limiter {
 public:
  limiter(const mesh& m, const mesh_links& links, const mass_matrix& mass,
          const std::vector<double>& x)
      : mesh_(m), links_(links), mass_(mass), x_(x) {}

  std::vector<double> run(const std::vector<local_load>& load, const std::vector<double>& b) {
    const std::size_t n = x_.size();
    low_ = high_ = lumped_ = x_;
    up_.assign(n, 1.0);
    down_.assign(n, 1.0);
    for_each_node(n, [&](std::size_t v) { prepare(static_cast<vertex_index>(v), load, b); });
    std::vector<double> made = lumped_;
    for_each_node(n, [&](std::size_t v) {
      double sum = 0;
      for_each_flux(static_cast<vertex_index>(v), [&](vertex_index w, double flux) {
        sum += (flux > 0 ? std::min(up_[v], down_[w]) : std::min(down_[v], up_[w])) * flux;
      });
      const double own = mass_.row_sums()[v];
      // Clamps the value: after limited fluxes only rounding can put it outside of the bounds.
      if (own > 0) made[v] = std::clamp(lumped_[v] + sum / own, low_[v], high_[v]);
    });
    return made;
  }

 private:
  // Calls visit(w, flux) for the neighbours w of v, triangle by triangle, with the flux m (x_v -
  // x_w) from w to v.
  template <class Visit>
  void for_each_flux(vertex_index v, const Visit& visit) const {
    for (const incidence& at : links_.around(v))
      for (std::size_t k = 1; k < 3; ++k) {
        const std::size_t j = (at.corner + k) % 3;
        const vertex_index w = mesh_.triangles[at.triangle][j];
        visit(w, mass_.entry(at.triangle, at.corner, j) * (x_[v] - x_[w]));
      }
  }

  // Finds the bounds and the lumped value of v, and the share of inflow and of outflow that it can
  // accept.
  void prepare(vertex_index v, const std::vector<local_load>& load, const std::vector<double>& b) {
    const double own = mass_.row_sums()[v];
    const auto around = links_.around(v);
    if (around.empty() || !(own > 0)) return;
    low_[v] = load[around.front().triangle].least;
    high_[v] = load[around.front().triangle].greatest;
    for (const incidence& at : around) {
      low_[v] = std::min(low_[v], load[at.triangle].least);
      high_[v] = std::max(high_[v], load[at.triangle].greatest);
    }
    lumped_[v] = std::clamp(b[v] / own, low_[v], high_[v]);
    double in = 0, out = 0;
    for_each_flux(v, [&](vertex_index, double flux) { (flux > 0 ? in : out) += flux; });
    if (in > 0) up_[v] = std::min(1.0, own * (high_[v] - lumped_[v]) / in);
    if (out < 0) down_[v] = std::min(1.0, own * (low_[v] - lumped_[v]) / out);
  }

  const mesh& mesh_;
  const mesh_links& links_;
  const mass_matrix& mass_;
  const std::vector<double>& x_;
  std::vector<double> low_, high_, lumped_, up_, down_;
};

}  // namespace

std::vector<double> bounded_projection(const mesh& m, const mesh_links& links,
                                       const mass_matrix& mass, const std::vector<local_load>& load,
                                       const std::vector<double>& b, const std::vector<double>& x) {
  return limiter(m, links, mass, x).run(load, b);
}

}  // namespace asterism::internal
