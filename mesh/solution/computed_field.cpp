// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/computed_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/numerics/nodal_sums.hpp"
#include "asterism/mesh/numerics/symmetric_eigen.hpp"
#include "asterism/mesh/solution/element_gradients.hpp"
#include "asterism/mesh/solution/quadratic_fit.hpp"
#include "asterism/mesh/solution/solution_metric_options.hpp"

namespace asterism::internal {
namespace {

double strength(const metric_tensor& h) {
  const symmetric_eigen e = eigen_of(h);
  return std::max(std::abs(e.first), std::abs(e.second));
}

double part_of_sorted(std::vector<double> all, double part) {
  const auto at = all.begin() + static_cast<std::ptrdiff_t>(part * double(all.size() - 1));
  std::nth_element(all.begin(), at, all.end());
  return *at;
}

// Returns the difference of `own` from the value at v of the linear function that fits its
// neighbours' best; none where they do not determine one.
template <class Value>
std::optional<double> off_linear(const mesh& m, const mesh_links& links, vertex_index v, double own,
                                 const Value& value) {
  const auto around = links.neighbours(v);
  const point& p = m.sites[v].position;
  const auto n = static_cast<double>(around.size());
  double x = 0, y = 0, t = 0;
  for (const vertex_index w : around) {
    x += (m.sites[w].position.x - p.x) / n;
    y += (m.sites[w].position.y - p.y) / n;
    t += value(w) / n;
  }
  double xx = 0, xy = 0, yy = 0, xt = 0, yt = 0;
  for (const vertex_index w : around) {
    const double dx = m.sites[w].position.x - p.x - x, dy = m.sites[w].position.y - p.y - y,
                 dt = value(w) - t;
    xx += dx * dx, xy += dx * dy, yy += dy * dy, xt += dx * dt, yt += dy * dt;
  }
  constexpr double least_pivot = 1e-12;  // of products that are off by a few 1e-16
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > least_pivot * (xx * yy))) return std::nullopt;
  const double a = (xt * yy - yt * xy) / determinant, b = (yt * xx - xt * xy) / determinant;
  return own - (t - a * x - b * y);
}

// Vertices whose neighbours all lie inside, as the weak form means nothing at the boundary.
std::vector<vertex_index> inner_vertices(const mesh_links& links) {
  constexpr std::size_t enough = 4;  // neighbours, for three unknowns
  std::vector<vertex_index> found;
  for (vertex_index v = 0; v < links.vertices(); ++v) {
    const auto around = links.neighbours(v);
    if (links.on_boundary(v) || around.size() < enough) continue;
    if (std::none_of(around.begin(), around.end(),
                     [&](vertex_index w) { return links.on_boundary(w); }))
      found.push_back(v);
  }
  return found;
}

// Inner vertices at which second derivatives are at least a tenth of their 95 % quantile; a subset
// at even steps if there are more than wanted.
std::vector<vertex_index> strong_vertices(const mesh_links& links,
                                          const std::vector<metric_tensor>& weak) {
  constexpr double high = 0.95, strong = 0.1;
  constexpr std::size_t wanted = 1000;
  std::vector<vertex_index> inner = inner_vertices(links);
  if (inner.empty()) return inner;
  std::vector<double> strengths(inner.size());
  for (std::size_t i = 0; i < inner.size(); ++i) strengths[i] = strength(weak[inner[i]]);
  const double least = strong * part_of_sorted(strengths, high);
  std::erase_if(inner, [&](vertex_index v) { return !(strength(weak[v]) > least); });
  const std::size_t step = 1 + inner.size() / wanted;
  std::vector<vertex_index> taken;
  for (std::size_t i = 0; i < inner.size(); i += step) taken.push_back(inner[i]);
  return taken;
}

// Measures at one vertex.
struct vertex_measures {
  double weak, fitted;       // distances from linear functions, with their signs
  double along_over_across;  // second derivatives of the fit: across layers is along the gradient
};

// Divides the second derivative of a fit along a layer by that across it, which is in the direction
// of the gradient. Returns 1 where the gradient or the second derivative across is 0.
double along_over_across(const fitted_quadratic& fit) {
  const double greater = std::max(std::abs(fit.gradient.x), std::abs(fit.gradient.y));
  if (!(greater > 0)) return 1;
  const double x = fit.gradient.x / greater, y = fit.gradient.y / greater;
  const metric_tensor& h = fit.second;
  const double across = std::abs(h.m11 * x * x + 2 * h.m12 * x * y + h.m22 * y * y);
  const double along = std::abs(h.m11 * y * y - 2 * h.m12 * x * y + h.m22 * x * x);
  const double ratio = along / across;
  return std::isfinite(ratio) ? ratio : 1;
}

std::optional<vertex_measures> measures_at(const mesh& m, const mesh_links& links,
                                           const std::vector<double>& values,
                                           const std::vector<metric_tensor>& weak, vertex_index v) {
  const auto own = fit_quadratic(m, links, values, v);
  if (!own) return std::nullopt;
  const auto trace = [](const metric_tensor& h) { return h.m11 + h.m22; };
  const auto around = links.neighbours(v);
  std::vector<double> of_neighbours;
  for (const vertex_index w : around) {
    const auto fit = fit_quadratic(m, links, values, w);
    if (!fit) return std::nullopt;
    of_neighbours.push_back(trace(fit->second));
  }
  const auto fitted = [&](vertex_index w) {
    return of_neighbours[static_cast<std::size_t>(
        std::lower_bound(around.begin(), around.end(), w) - around.begin())];
  };
  const auto of_weak = off_linear(m, links, v, trace(weak[v]),
                                  [&](vertex_index w) { return trace(weak[w]); }),
             of_fit = off_linear(m, links, v, trace(own->second), fitted);
  if (!of_weak || !of_fit) return std::nullopt;
  const double unit = strength(weak[v]);
  return vertex_measures{*of_weak / unit, *of_fit / unit, along_over_across(*own)};
}

// Returns 1 up to `all`, 0 from `none` on, and between them a share that falls linearly in ln x.
double part_below(double x, double all, double none) {
  if (x <= all) return 1;
  return x < none ? elementary::log(none / x) / elementary::log(none / all) : 0;
}

}  // namespace

std::optional<layer_measures> measures_of_layers(const mesh& m, const mesh_links& links,
                                                 const std::vector<double>& values) {
  constexpr std::size_t enough = 16;
  const auto weak = weak_second_derivatives(m, links, triangle_gradients(m, values));
  const std::vector<vertex_index> strong = strong_vertices(links, weak);
  std::vector<std::optional<vertex_measures>> found(strong.size());
  for_each_node(strong.size(),
                [&](std::size_t i) { found[i] = measures_at(m, links, values, weak, strong[i]); });
  std::erase_if(found, [](const auto& one) { return !one; });
  if (found.size() < enough) return std::nullopt;
  const auto median = [&found](const auto& of) {
    constexpr double middle = 0.5;
    std::vector<double> all;
    all.reserve(found.size());
    for (const auto& one : found) all.push_back(of(*one));
    return part_of_sorted(std::move(all), middle);
  };
  using measures = const vertex_measures&;
  return layer_measures{median([](measures at) { return std::abs(at.weak); }),
                        median([](measures at) { return std::abs(at.fitted); }),
                        median([](measures at) { return std::abs(at.weak - at.fitted); }),
                        1 / std::sqrt(median([](measures at) { return at.along_over_across; }))};
}

double steepness(const mesh& m, const std::vector<double>& values) {
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  if (least == values.end() || !(*greatest > *least)) return 0;
  const std::vector<point> gradients = triangle_gradients(m, values);
  const auto slope = [&](std::size_t t) {
    return std::sqrt(gradients[t].x * gradients[t].x + gradients[t].y * gradients[t].y);
  };
  double steepest = 0;
  for (std::size_t t = 0; t < gradients.size(); ++t) steepest = std::max(steepest, slope(t));
  if (!(steepest > 0)) return 0;
  const auto moment = [&](bool is_third) {  // of slopes over the greatest
    return ordered_sum(gradients.size(), [&](std::size_t t) {
      const double part = slope(t) / steepest;
      return doubled_area(m, m.triangles[t]) * part * part * (is_third ? part : 1);
    });
  };
  const bounding_box box = box_of_sites(m.sites);
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
  return std::sqrt(width * width + height * height) * (moment(true) / moment(false)) *
         (steepest / (*greatest - *least));
}

double share_of_computed(const layer_measures& field) {
  return part_below(field.ratio(), ratio_of_computed, ratio_of_function) *
         part_below(field.fitted, roughness_of_resolved, roughness_of_unresolved) *
         (1 - part_below(field.apart(), apart_on_grids, apart_of_computed));
}

std::optional<double> aspect_bound(const mesh& m, const mesh_links& links,
                                   const std::vector<double>& values) {
  const auto field = measures_of_layers(m, links, values);
  if (!field) return std::nullopt;
  const double share = share_of_computed(*field);
  if (!(share > 0)) return std::nullopt;
  const double bound = std::max(
      least_aspect_bound, std::min(bound_of_wanted_aspect * field->aspect, steepness(m, values)));
  const double grown = elementary::log(bound) / share;
  if (!(grown < elementary::log(no_aspect_named))) return std::nullopt;
  return share < 1 ? elementary::exp(grown) : bound;
}

void bound_aspects(double aspect, std::vector<metric_tensor>& tensors) {
  for_each_node(tensors.size(), [&](std::size_t v) {
    const symmetric_eigen e = eigen_of(tensors[v]);
    const double least = e.first / aspect / aspect;
    if (e.second < least) tensors[v] = with_eigenvalues(e, e.first, least);
  });
}

}  // namespace asterism::internal
