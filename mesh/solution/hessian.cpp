// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/hessian.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "asterism/mesh/numerics/nodal_sums.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/solution/element_gradients.hpp"
#include "asterism/mesh/solution/quadratic_fit.hpp"

namespace asterism {
using namespace internal;
namespace {

class recovery {
 public:
  recovery(const mesh& m, const std::vector<double>& values)
      : mesh_(m), values_(values), links_(m), known_(m.sites.size(), 1) {}

  recovered_hessian run(hessian_method method) {
    if (method == hessian_method::least_squares) {
      fit_everywhere();
    } else if (method == hessian_method::green) {
      made_.at = weak_second_derivatives(mesh_, links_, triangle_gradients(mesh_, values_));
      forget_boundary();
      fit_boundary();
    } else {
      made_.at = second_means(mesh_, links_, gradients());
      forget_boundary();
    }
    fill_unknown();
    silence();
    return std::move(made_);
  }

 private:
  // Averages gradients inside; fits quadratics at the boundary, where possible.
  std::vector<point> gradients() const {
    auto found = mean_gradients(mesh_, links_, triangle_gradients(mesh_, values_));
    for_each_node(found.size(), [&](std::size_t i) {
      const auto v = static_cast<vertex_index>(i);
      if (!links_.on_boundary(v)) return;
      if (const auto fitted = fit_quadratic(mesh_, links_, values_, v)) found[v] = fitted->gradient;
    });
    return found;
  }

  void fit_everywhere() {
    made_.at.resize(values_.size());
    for_each_node(values_.size(), [&](std::size_t i) {
      const auto fitted = fit_quadratic(mesh_, links_, values_, static_cast<vertex_index>(i));
      known_[i] = fitted ? 1 : 0;
      if (fitted) made_.at[i] = fitted->second;
    });
  }

  // Fits quadratics at the boundary: half of a patch determines no derivatives across it by
  // averages.
  void fit_boundary() {
    for_each_node(values_.size(), [&](std::size_t i) {
      const auto v = static_cast<vertex_index>(i);
      if (!links_.on_boundary(v)) return;
      const auto fitted = fit_quadratic(mesh_, links_, values_, v);
      if (!fitted) return;
      made_.at[i] = fitted->second;
      known_[i] = 1;
    });
  }

  // Drops the values at the boundary if there are vertices inside.
  void forget_boundary() {
    bool any_inside = false;
    for (std::size_t v = 0; v < known_.size(); ++v) {
      known_[v] = links_.on_boundary(static_cast<vertex_index>(v)) ? 0 : 1;
      any_inside = any_inside || known_[v] != 0;
    }
    if (!any_inside) std::fill(known_.begin(), known_.end(), char{1});
  }

  // Fills in means of known neighbours, ring by ring. A part of the mesh without any keeps its
  // values.
  void fill_unknown() {
    std::vector<vertex_index> waiting;
    for (vertex_index v = 0; v < known_.size(); ++v)
      if (known_[v] == 0) waiting.push_back(v);
    made_.at_boundary = waiting.size();
    made_.means = waiting;
    while (!waiting.empty()) {
      std::vector<vertex_index> later, done;
      for (const vertex_index v : waiting) (take_mean(v) ? done : later).push_back(v);
      if (done.empty()) return;
      for (const vertex_index v : done) known_[v] = 1;
      waiting = std::move(later);
    }
  }

  bool take_mean(vertex_index v) {
    double count = 0;
    metric_tensor sum{0, 0, 0};
    for (const vertex_index w : links_.neighbours(v)) {
      if (known_[w] == 0) continue;
      const metric_tensor& h = made_.at[w];
      sum = {sum.m11 + h.m11, sum.m12 + h.m12, sum.m22 + h.m22};
      ++count;
    }
    if (count == 0) return false;
    made_.at[v] = {sum.m11 / count, sum.m12 / count, sum.m22 / count};
    return true;
  }

  // Sets to zero values that rounding may have made. A second difference L^T H L, with L L^T the
  // covariance of the displacements to the neighbours, is a combination of values with factors of
  // about one; each value is off by half a unit in the last place of the greatest.
  void silence() {
    double greatest = 0;
    for (const double u : values_) greatest = std::max(greatest, std::abs(u));
    const double noise = 0x1p-47 * greatest;  // 64 such halves
    std::vector<char> silent(values_.size(), 0);
    for_each_node(values_.size(), [&](std::size_t v) {
      const metric_tensor c = neighbour_covariance(mesh_, links_, static_cast<vertex_index>(v));
      metric_tensor& h = made_.at[v];
      // Computes the trace of (H C)^2, which is the sum of the squares of the entries of L^T H L.
      const double xx = h.m11 * c.m11 + h.m12 * c.m12, xy = h.m11 * c.m12 + h.m12 * c.m22,
                   yx = h.m12 * c.m11 + h.m22 * c.m12, yy = h.m12 * c.m12 + h.m22 * c.m22;
      if (!(std::sqrt(std::abs(xx * xx + 2 * xy * yx + yy * yy)) <= noise)) return;
      h = {0, 0, 0};
      silent[v] = 1;
    });
    for (const char s : silent) made_.noise += s != 0 ? 1 : 0;
  }

  const mesh& mesh_;
  const std::vector<double>& values_;
  mesh_links links_;
  std::vector<char> known_;
  recovered_hessian made_;
};

}  // namespace

result<recovered_hessian> recover_hessian(const mesh& m, const std::vector<double>& values,
                                          hessian_method method) {
  if (values.size() != m.sites.size())
    return error{std::to_string(values.size()) + " values for " + std::to_string(m.sites.size()) +
                 " vertices"};
  auto made = recovery(m, values).run(method);
  // The metric has their determinants: squares, which must be neither infinite nor zero.
  constexpr double most = 1e150, least = 1e-150;
  double greatest = 0;
  for (std::size_t v = 0; v < made.at.size(); ++v) {
    const metric_tensor& h = made.at[v];
    for (const double entry : {h.m11, h.m12, h.m22}) {
      greatest = std::max(greatest, std::abs(entry));
      if (std::abs(entry) < most) continue;
      return error{"the second derivatives at vertex " + std::to_string(v + 1) +
                   " are beyond what can be computed with: give coordinates in another unit"};
    }
  }
  if (greatest > 0 && greatest < least)
    return error{
        "all second derivatives are below 1e-150, and so below what can be computed with: give "
        "coordinates or values in another unit"};
  return made;
}

}  // namespace asterism
