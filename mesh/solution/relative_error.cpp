// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/relative_error.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/mesh/numerics/nodal_sums.hpp"
#include "asterism/mesh/numerics/symmetric_eigen.hpp"

namespace asterism::internal {

std::vector<double> scales_of_error(const std::vector<double>& values,
                                    std::optional<double> cutoff) {
  constexpr double alike = 1e-10;
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  if (least == values.end()) return {};
  const double span = *greatest - *least, modulus = std::max(std::abs(*least), std::abs(*greatest));
  if (!(span > alike * modulus)) return {};
  std::vector<double> scales(values.size(), span);
  if (!cutoff) return scales;
  for (std::size_t v = 0; v < values.size(); ++v)
    scales[v] = std::max(std::abs(values[v]), *cutoff * modulus);
  return scales;
}

std::vector<metric_tensor> relative_metric(const std::vector<metric_tensor>& moduli,
                                           const std::vector<double>& scales, double error,
                                           double extent, bool round) {
  const double least = 1 / (extent * extent);
  std::vector<metric_tensor> made(moduli.size());
  for_each_node(made.size(), [&](std::size_t v) {
    const symmetric_eigen e = eigen_of(moduli[v]);
    const double times = scales.empty() ? 0 : unit_share / (error * scales[v]);
    double first = std::max(times * std::abs(e.first), least),
           second = std::max(times * std::abs(e.second), least);
    if (round) first = second = std::max(first, second);
    made[v] = with_eigenvalues(e, first, second);
  });
  return made;
}

}  // namespace asterism::internal
