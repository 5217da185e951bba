// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/implied_metric.hpp"

#include <cmath>
#include <string>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/numerics/nodal_sums.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/solution/quadratic_fit.hpp"

namespace asterism {
using namespace internal;

result<std::vector<metric_tensor>> implied_metric(const mesh& m) {
  const mesh_links links(m);
  std::vector<metric_tensor> found(m.sites.size());
  std::vector<char> bad(found.size(), 0);
  for_each_node(found.size(), [&](std::size_t v) {
    const metric_tensor c = neighbour_covariance(m, links, static_cast<vertex_index>(v));
    const double determinant = std::fma(c.m11, c.m22, -c.m12 * c.m12) * 2;
    found[v] = {c.m22 / determinant, -c.m12 / determinant, c.m11 / determinant};
    bad[v] = std::isfinite(found[v].m11) && std::isfinite(found[v].m22) &&
                     filtered_kernel().is_positive_definite(found[v])
                 ? 0
                 : 1;
  });
  for (std::size_t v = 0; v < bad.size(); ++v)
    if (bad[v] != 0)
      return error{"the edges at vertex " + std::to_string(v + 1) +
                       " are along one line, or too short or long: they imply no metric",
                   error_code::invalid_mesh};
  return found;
}

}  // namespace asterism
