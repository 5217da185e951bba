// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/metric_bounds.hpp"

#include <algorithm>

#include "asterism/mesh/numerics/simultaneous_reduction.hpp"
#include "asterism/mesh/numerics/symmetric_eigen.hpp"

namespace asterism::internal {

metric_tensor bounded(const metric_tensor& m, const size_bounds& bounds, std::uint8_t& what) {
  const symmetric_eigen e = eigen_of(m);
  const double low = 1 / (bounds.greatest * bounds.greatest),
               high = 1 / (bounds.least * bounds.least);
  double first = e.first, second = std::max(e.second, 0.0);
  std::uint8_t marks = 0;
  if (first > high || second > high) marks |= clipped_by_least;
  if (first < low || second < low) marks |= clipped_by_greatest;
  first = std::clamp(first, low, high);
  second = std::clamp(second, low, high);
  const double least_second = first / (bounds.aspect * bounds.aspect);
  if (second < least_second) {
    second = least_second;
    marks |= clipped_by_aspect;
  }
  what |= marks;
  return marks == 0 ? m : with_eigenvalues(e, first, second);
}

metric_tensor step_limited(const metric_tensor& m, const metric_tensor& now, double factor,
                           std::uint8_t& what) {
  const simultaneous_reduction r = reduce(now, m);
  const double high = factor * factor, low = 1 / high;
  if (r.high <= high && r.low >= low) return m;
  what |= clipped_by_step;
  return restore(r, std::clamp(r.high, low, high), std::clamp(r.low, low, high));
}

}  // namespace asterism::internal
