// SPDX-License-Identifier: MIT
#include "asterism/mesh/transfer/mass_matrix.hpp"

#include <cstddef>

#include "asterism/mesh/numerics/nodal_sums.hpp"

namespace asterism::internal {

mass_matrix::mass_matrix(const mesh& m, const mesh_links& links,
                         const std::vector<local_mass>& local)
    : mesh_(m),
      links_(links),
      local_(local),
      diagonal_(m.sites.size(), 0.0),
      row_sums_(m.sites.size(), 0.0) {
  for_each_node(m.sites.size(), [&](std::size_t v) {
    for (const incidence& at : links_.around(static_cast<vertex_index>(v)))
      for (std::size_t j = 0; j < 3; ++j) {
        const double value = entry(at.triangle, at.corner, j);
        row_sums_[v] += value;
        if (j == at.corner) diagonal_[v] += value;
      }
  });
}

std::vector<double> mass_matrix::times(const std::vector<double>& x) const {
  std::vector<double> y(x.size(), 0.0);
  for_each_node(x.size(), [&](std::size_t v) {
    for (const incidence& at : links_.around(static_cast<vertex_index>(v)))
      for (std::size_t j = 0; j < 3; ++j)
        y[v] += entry(at.triangle, at.corner, j) * x[mesh_.triangles[at.triangle][j]];
  });
  return y;
}

std::vector<double> mass_matrix::solve(const std::vector<double>& b, std::vector<double> x) const {
  constexpr int most_steps = 50;
  const std::size_t n = x.size();
  std::vector<double> r = times(x);
  for (std::size_t v = 0; v < n; ++v) r[v] = b[v] - r[v];
  // Keeps the value of a vertex in no triangle, which has no equation.
  const auto over_diagonal = [&](std::size_t v) {
    return diagonal_[v] > 0 ? r[v] / diagonal_[v] : 0;
  };
  std::vector<double> direction(n);
  for (std::size_t v = 0; v < n; ++v) direction[v] = over_diagonal(v);
  const double size = ordered_sum(
      n, [&](std::size_t v) { return diagonal_[v] > 0 ? b[v] * b[v] / diagonal_[v] : 0; });
  double norm = ordered_sum(n, [&](std::size_t v) { return r[v] * over_diagonal(v); });
  // Ends when the residual, whose square is `norm`, is below a rounding of the right-hand side:
  // 1e-17 of it.
  constexpr double least = 1e-34;
  for (int step = 0; step < most_steps && norm > least * size; ++step) {
    const std::vector<double> image = times(direction);
    const double along = ordered_sum(n, [&](std::size_t v) { return direction[v] * image[v]; });
    if (!(along > 0)) break;
    const double length = norm / along;
    for_each_node(n, [&](std::size_t v) {
      x[v] += length * direction[v];
      r[v] -= length * image[v];
    });
    const double before = norm;
    norm = ordered_sum(n, [&](std::size_t v) { return r[v] * over_diagonal(v); });
    const double turn = norm / before;
    for_each_node(n, [&](std::size_t v) { direction[v] = over_diagonal(v) + turn * direction[v]; });
  }
  const double whole = ordered_sum(n, [&](std::size_t v) { return row_sums_[v]; }),
               missing = ordered_sum(n, [&](std::size_t v) { return b[v] - row_sums_[v] * x[v]; });
  if (whole > 0)
    for (std::size_t v = 0; v < n; ++v) x[v] += missing / whole;
  return x;
}

}  // namespace asterism::internal
