// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/quadratic_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace asterism::internal {
namespace {

constexpr std::size_t unknowns = 5;  // two of the gradient, three of the Hessian
constexpr std::size_t most_points = 96;
using row = std::array<double, unknowns + 1>;  // the last is the right-hand side

// Lists the vertices within this number of edges of v, without v itself.
std::vector<vertex_index> rings(const mesh_links& links, vertex_index v, int count) {
  std::vector<vertex_index> found, last{v};
  for (int ring = 0; ring < count && found.size() < most_points; ++ring) {
    std::vector<vertex_index> next;
    for (const vertex_index w : last)
      for (const vertex_index x : links.neighbours(w)) next.push_back(x);
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    std::erase_if(next, [&](vertex_index x) {
      return x == v || std::binary_search(found.begin(), found.end(), x);
    });
    last = next;
    found.insert(found.end(), next.begin(), next.end());
    std::sort(found.begin(), found.end());
  }
  if (found.size() > most_points) found.resize(most_points);
  return found;
}

metric_tensor covariance(const mesh& m, vertex_index v, const auto& around) {
  metric_tensor sum{0, 0, 0};
  const point& p = m.sites[v].position;
  for (const vertex_index w : around) {
    const point d{m.sites[w].position.x - p.x, m.sites[w].position.y - p.y};
    sum = {sum.m11 + d.x * d.x, sum.m12 + d.x * d.y, sum.m22 + d.y * d.y};
  }
  const auto n = static_cast<double>(std::max<std::size_t>(around.size(), 1));
  return {sum.m11 / n, sum.m12 / n, sum.m22 / n};
}

// Computes the lower triangular L with L L^T the covariance.
struct whitening {
  double l11, l21, l22;

  explicit whitening(const metric_tensor& c)
      : l11(std::sqrt(c.m11)),
        l21(l11 > 0 ? c.m12 / l11 : 0),
        l22(std::sqrt(std::max(0.0, c.m22 - l21 * l21))) {}
  bool is_regular() const { return l11 > 0 && l22 > 0; }
  point white(const point& d) const {
    const double x = d.x / l11;
    return {x, (d.y - l21 * x) / l22};
  }
};

// Solves a least squares problem by Householder's reflections; none if a pivot is tiny relative to
// the greatest.
std::optional<std::array<double, unknowns>> solve(std::vector<row>& rows) {
  constexpr double least_pivot = 1e-7;
  if (rows.size() < unknowns) return std::nullopt;
  double greatest = 0;
  for (std::size_t k = 0; k < unknowns; ++k) {
    double norm = 0;
    for (std::size_t i = k; i < rows.size(); ++i) norm += rows[i][k] * rows[i][k];
    norm = std::sqrt(norm);
    greatest = std::max(greatest, norm);
    if (!(norm > least_pivot * greatest)) return std::nullopt;
    const double alpha = rows[k][k] > 0 ? -norm : norm;
    const double head = rows[k][k] - alpha;
    double square = head * head;
    for (std::size_t i = k + 1; i < rows.size(); ++i) square += rows[i][k] * rows[i][k];
    for (std::size_t j = k + 1; j <= unknowns; ++j) {
      double dot = head * rows[k][j];
      for (std::size_t i = k + 1; i < rows.size(); ++i) dot += rows[i][k] * rows[i][j];
      const double f = 2 * dot / square;
      rows[k][j] -= f * head;
      for (std::size_t i = k + 1; i < rows.size(); ++i) rows[i][j] -= f * rows[i][k];
    }
    rows[k][k] = alpha;
  }
  std::array<double, unknowns> x{};
  for (std::size_t k = unknowns; k-- > 0;) {
    double rest = rows[k][unknowns];
    for (std::size_t j = k + 1; j < unknowns; ++j) rest -= rows[k][j] * x[j];
    x[k] = rest / rows[k][k];
  }
  return x;
}

// Divides each equation by the square of its distance, so that the error in second differences is
// minimised, not that in values. Near vertices then count most. With equal weights two rings
// average waves of three edges away (docs/results/adaptation.md has both).
std::optional<fitted_quadratic> fit_to(const mesh& m, const std::vector<double>& values,
                                       vertex_index v, const std::vector<vertex_index>& around) {
  const whitening w(covariance(m, v, around));
  if (!w.is_regular()) return std::nullopt;
  const point& p = m.sites[v].position;
  std::vector<row> rows;
  rows.reserve(around.size());
  for (const vertex_index q : around) {
    const point d = w.white({m.sites[q].position.x - p.x, m.sites[q].position.y - p.y});
    const double square = d.x * d.x + d.y * d.y;
    if (!(square > 0)) return std::nullopt;
    row each = {d.x, d.y, d.x * d.x / 2, d.x * d.y, d.y * d.y / 2, values[q] - values[v]};
    for (double& entry : each) entry /= square;
    rows.push_back(each);
  }
  const auto x = solve(rows);
  if (!x) return std::nullopt;
  // Transforms back: gradient L^-T g, Hessian L^-T K L^-1, with L^-1 = [a 0; b c].
  const double a = 1 / w.l11, c = 1 / w.l22, b = -w.l21 / (w.l11 * w.l22);
  const auto [g1, g2, k11, k12, k22] = *x;
  return fitted_quadratic{
      {a * g1 + b * g2, c * g2},
      {a * a * k11 + 2 * a * b * k12 + b * b * k22, c * (a * k12 + b * k22), c * c * k22}};
}

}  // namespace

metric_tensor neighbour_covariance(const mesh& m, const mesh_links& links, vertex_index v) {
  return covariance(m, v, links.neighbours(v));
}

std::optional<fitted_quadratic> fit_quadratic(const mesh& m, const mesh_links& links,
                                              const std::vector<double>& values, vertex_index v) {
  constexpr std::size_t enough = 8;  // points for five unknowns
  for (const int count : {2, 3, 4}) {
    const std::vector<vertex_index> around = rings(links, v, count);
    if (around.size() < enough && count < 4) continue;
    if (auto fitted = fit_to(m, values, v, around)) return fitted;
  }
  return std::nullopt;
}

}  // namespace asterism::internal
