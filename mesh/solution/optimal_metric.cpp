// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/optimal_metric.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/symmetric_eigen.hpp"
#include "asterism/mesh/solution/nodal_sums.hpp"

namespace asterism::internal {
namespace {

double power(double x, double exponent) {
  return x > 0 ? elementary::exp(exponent * elementary::log(x)) : 0;
}

double root_of(const metric_tensor& m) {
  const double product = m.m12 * m.m12;
  const double determinant = std::fma(m.m11, m.m22, -product) + std::fma(-m.m12, m.m12, product);
  return std::sqrt(std::max(0.0, determinant));
}

double greatest_modulus(const std::vector<metric_tensor>& hessian) {
  double greatest = 0;
  for (const metric_tensor& h : hessian) {
    const symmetric_eigen e = eigen_of(h);
    greatest = std::max({greatest, std::abs(e.first), std::abs(e.second)});
  }
  return greatest;
}

// Returns the L^p mean, over an equilateral triangle of side 1, of the error of interpolating
// (x^2 + y^2) / 2: half of 1/3 less the squared distance from the middle. By midpoints of 4096
// parts.
double unit_error(double p) {
  constexpr int n = 64;
  const double height = std::sqrt(3.0) / 2;
  double sum = 0;
  const auto add = [&](double a, double b) {  // barycentric, of the corners (1,0) and (1/2, height)
    const double x = a + b / 2 - 0.5, y = height * b - height / 3;
    sum += power(std::max(0.0, 1.0 / 3 - x * x - y * y) / 2, p);
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      add((i + 1.0 / 3) / n, (j + 1.0 / 3) / n);
      if (i + j + 1 < n) add((i + 2.0 / 3) / n, (j + 2.0 / 3) / n);
    }
  return power(sum / (n * n), 1 / p);
}

double error_constant(std::optional<double> norm) {
  if (!norm) return 1.0 / 6;
  if (*norm == 1) return 1.0 / 8;
  if (*norm == 2) return 1 / (2 * std::sqrt(15.0));
  return unit_error(*norm);
}

}  // namespace

double complexity_of(const std::vector<metric_tensor>& tensors, const std::vector<double>& areas) {
  return ordered_sum(tensors.size(), [&](std::size_t v) { return areas[v] * root_of(tensors[v]); });
}

optimal_metric make_optimal_metric(const std::vector<metric_tensor>& hessian,
                                   const std::vector<double>& areas, std::optional<double> norm,
                                   bool round) {
  constexpr double floor_part = 1e-8;
  optimal_metric made;
  const double greatest = greatest_modulus(hessian), floor = floor_part * greatest;
  made.is_flat = !(greatest > 0);
  made.tensors.resize(hessian.size());
  made.absolute.resize(hessian.size());
  std::vector<char> raised(hessian.size(), 0);
  const double exponent = norm ? -1 / (2 * *norm + 2) : 0;
  for_each_node(hessian.size(), [&](std::size_t v) {
    const symmetric_eigen e = eigen_of(hessian[v]);
    double first = std::abs(e.first), second = std::abs(e.second);
    if (round) first = second = std::max(first, second);
    raised[v] = first < floor || second < floor ? 1 : 0;
    // Divided by the greatest, so that no power overflows; the factor belongs to the complexity.
    first = made.is_flat ? 1 : std::max(first / greatest, floor_part);
    second = made.is_flat ? 1 : std::max(second / greatest, floor_part);
    const double scale = exponent == 0 ? 1 : power(first * second, exponent);
    made.tensors[v] = with_eigenvalues(e, scale * first, scale * second);
    made.absolute[v] = made.is_flat ? metric_tensor{0, 0, 0}
                                    : with_eigenvalues(e, greatest * first, greatest * second);
  });
  const double complexity = complexity_of(made.tensors, areas);
  for (metric_tensor& m : made.tensors)
    m = {m.m11 / complexity, m.m12 / complexity, m.m22 / complexity};
  made.floored = static_cast<std::size_t>(std::count(raised.begin(), raised.end(), char{1}));
  return made;
}

double predicted_error(const std::vector<metric_tensor>& tensors,
                       const std::vector<metric_tensor>& absolute, const std::vector<double>& areas,
                       std::optional<double> norm) {
  const auto local = [&](std::size_t v) {
    const metric_tensor &m = tensors[v], &h = absolute[v];
    const double root = root_of(m);
    return root > 0 ? (m.m22 * h.m11 - 2 * m.m12 * h.m12 + m.m11 * h.m22) / (root * root) / 2 : 0;
  };
  double error = 0;
  if (norm) {
    error = power(
        ordered_sum(tensors.size(),
                    [&](std::size_t v) {
                      const double e = local(v);
                      return areas[v] * (*norm == 1 ? e : *norm == 2 ? e * e : power(e, *norm));
                    }),
        1 / *norm);
  } else {
    for (std::size_t v = 0; v < tensors.size(); ++v) error = std::max(error, local(v));
  }
  return error_constant(norm) * error;
}

}  // namespace asterism::internal
