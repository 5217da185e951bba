// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/mean_moduli.hpp"

#include <cmath>
#include <cstddef>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/nodal_sums.hpp"
#include "asterism/mesh/numerics/simultaneous_reduction.hpp"
#include "asterism/mesh/numerics/symmetric_eigen.hpp"

namespace asterism::internal {
namespace {

// Returns the tensor whose eigenvalues are the moduli of h's, raised to `power`.
metric_tensor power_of_moduli(const metric_tensor& h, double power) {
  const symmetric_eigen e = eigen_of(h);
  return with_eigenvalues(e, elementary::pow(std::abs(e.first), power),
                          elementary::pow(std::abs(e.second), power));
}

// Returns the mean of the corners' tensors over the triangles at v, by area.
metric_tensor mean_around(const mesh& m, const mesh_links& links, vertex_index v,
                          const std::vector<metric_tensor>& tensors) {
  double whole = 0;
  metric_tensor sum{0, 0, 0};
  for (const incidence& at : links.around(v)) {
    const triangle& t = m.triangles[at.triangle];
    const double area = doubled_area(m, t);
    const metric_tensor &a = tensors[t[0]], &b = tensors[t[1]], &c = tensors[t[2]];
    sum = {sum.m11 + area * (a.m11 + b.m11 + c.m11), sum.m12 + area * (a.m12 + b.m12 + c.m12),
           sum.m22 + area * (a.m22 + b.m22 + c.m22)};
    whole += 3 * area;
  }
  return whole > 0 ? metric_tensor{sum.m11 / whole, sum.m12 / whole, sum.m22 / whole} : tensors[v];
}

// Returns the least tensor that is at least `mean` and at least `own` in their common directions.
// Either may be singular, as of a field that is bent in one direction alone. So `mean` is thickened
// by 2^-46 of the sum of both traces: 64 times the relative error of a determinant. That changes no
// metric of an aspect up to 1e6, whose moduli have a ratio up to 2^40.
metric_tensor at_least_both(const metric_tensor& mean, const metric_tensor& own) {
  constexpr double part = 0x1p-46;
  const double thick = part * (mean.m11 + mean.m22 + own.m11 + own.m22);
  if (!(thick > 0)) return mean;
  return simultaneous_intersection({mean.m11 + thick, mean.m12, mean.m22 + thick}, own);
}

// Returns, for each vertex inside, the mean of the moduli's powers, taken to the power 1/power, and
// for each at the boundary its own moduli.
std::vector<metric_tensor> power_means(const mesh& m, const mesh_links& links,
                                       const std::vector<metric_tensor>& hessian, double power) {
  std::vector<metric_tensor> powers(hessian.size()), means(hessian.size());
  for_each_node(powers.size(),
                [&](std::size_t v) { powers[v] = power_of_moduli(hessian[v], power); });
  for_each_node(means.size(), [&](std::size_t i) {
    const auto v = static_cast<vertex_index>(i);
    means[v] = links.on_boundary(v) ? power_of_moduli(hessian[v], 1)
                                    : power_of_moduli(mean_around(m, links, v, powers), 1 / power);
  });
  return means;
}

}  // namespace

double power_averaged(std::optional<double> norm) { return norm ? *norm / (2 * *norm + 1) : 0.5; }

std::vector<metric_tensor> mean_moduli(const mesh& m, const mesh_links& links,
                                       const std::vector<metric_tensor>& hessian) {
  return power_means(m, links, hessian, 1);
}

std::vector<metric_tensor> mean_moduli_with_peaks(const mesh& m, const mesh_links& links,
                                                  const std::vector<metric_tensor>& hessian,
                                                  double power) {
  std::vector<metric_tensor> made = power_means(m, links, hessian, power);
  for_each_node(made.size(), [&](std::size_t v) {
    if (!links.on_boundary(static_cast<vertex_index>(v)))
      made[v] = at_least_both(made[v], power_of_moduli(hessian[v], 1));
  });
  return made;
}

}  // namespace asterism::internal
