// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/mean_moduli.hpp"

#include <cmath>
#include <cstddef>

#include "asterism/mesh/numerics/symmetric_eigen.hpp"
#include "asterism/mesh/solution/nodal_sums.hpp"

namespace asterism::internal {

std::vector<metric_tensor> mean_moduli(const mesh& m, const mesh_links& links,
                                       const std::vector<metric_tensor>& hessian) {
  std::vector<metric_tensor> moduli(hessian.size()), means(hessian.size());
  for_each_node(moduli.size(), [&](std::size_t v) {
    const symmetric_eigen e = eigen_of(hessian[v]);
    moduli[v] = with_eigenvalues(e, std::abs(e.first), std::abs(e.second));
  });
  for_each_node(means.size(), [&](std::size_t v) {
    means[v] = moduli[v];
    if (links.on_boundary(static_cast<vertex_index>(v))) return;
    double whole = 0;
    metric_tensor sum{0, 0, 0};
    for (const incidence& at : links.around(static_cast<vertex_index>(v))) {
      const triangle& t = m.triangles[at.triangle];
      const double area = doubled_area(m, t);
      const metric_tensor &a = moduli[t[0]], &b = moduli[t[1]], &c = moduli[t[2]];
      sum = {sum.m11 + area * (a.m11 + b.m11 + c.m11), sum.m12 + area * (a.m12 + b.m12 + c.m12),
             sum.m22 + area * (a.m22 + b.m22 + c.m22)};
      whole += 3 * area;
    }
    if (whole > 0) means[v] = {sum.m11 / whole, sum.m12 / whole, sum.m22 / whole};
  });
  return means;
}

}  // namespace asterism::internal
