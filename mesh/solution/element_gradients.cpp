// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/element_gradients.hpp"

#include <cstddef>

#include "asterism/mesh/numerics/nodal_sums.hpp"

namespace asterism::internal {
namespace {

point minus(const point& a, const point& b) { return {a.x - b.x, a.y - b.y}; }

}  // namespace

std::vector<point> triangle_gradients(const mesh& m, const std::vector<double>& values) {
  std::vector<point> gradients(m.triangles.size());
  for_each_node(gradients.size(), [&](std::size_t i) {
    const triangle& t = m.triangles[i];
    const point p = minus(m.sites[t[1]].position, m.sites[t[0]].position),
                q = minus(m.sites[t[2]].position, m.sites[t[0]].position);
    const double area = p.x * q.y - p.y * q.x;
    if (!(area > 0)) return;
    const double up = values[t[1]] - values[t[0]], uq = values[t[2]] - values[t[0]];
    gradients[i] = {(up * q.y - uq * p.y) / area, (uq * p.x - up * q.x) / area};
  });
  return gradients;
}

std::vector<point> mean_gradients(const mesh& m, const mesh_links& links,
                                  const std::vector<point>& of_triangles) {
  std::vector<point> means(m.sites.size());
  for_each_node(means.size(), [&](std::size_t v) {
    double whole = 0;
    point sum;
    for (const incidence& at : links.around(static_cast<vertex_index>(v))) {
      const double area = doubled_area(m, m.triangles[at.triangle]);
      const point& g = of_triangles[at.triangle];
      sum = {sum.x + area * g.x, sum.y + area * g.y};
      whole += area;
    }
    if (whole > 0) means[v] = {sum.x / whole, sum.y / whole};
  });
  return means;
}

std::vector<metric_tensor> second_means(const mesh& m, const mesh_links& links,
                                        const std::vector<point>& gradients) {
  std::vector<double> x(gradients.size()), y(gradients.size());
  for (std::size_t v = 0; v < gradients.size(); ++v) {
    x[v] = gradients[v].x;
    y[v] = gradients[v].y;
  }
  const auto of_x = mean_gradients(m, links, triangle_gradients(m, x)),
             of_y = mean_gradients(m, links, triangle_gradients(m, y));
  std::vector<metric_tensor> second(gradients.size());
  for (std::size_t v = 0; v < gradients.size(); ++v)
    second[v] = {of_x[v].x, (of_x[v].y + of_y[v].x) / 2, of_y[v].y};
  return second;
}

std::vector<metric_tensor> weak_second_derivatives(const mesh& m, const mesh_links& links,
                                                   const std::vector<point>& of_triangles) {
  std::vector<metric_tensor> second(m.sites.size());
  for_each_node(second.size(), [&](std::size_t v) {
    double whole = 0;
    metric_tensor sum{0, 0, 0};
    for (const incidence& at : links.around(static_cast<vertex_index>(v))) {
      const triangle& t = m.triangles[at.triangle];
      const point& g = of_triangles[at.triangle];
      const point d =
          minus(m.sites[t[(at.corner + 2) % 3]].position, m.sites[t[(at.corner + 1) % 3]].position);
      // Uses that the gradient of the hat function is (-d.y, d.x) over twice the area.
      const double fx = -d.y / 2, fy = d.x / 2;
      sum = {sum.m11 - g.x * fx, sum.m12 - (g.x * fy + g.y * fx) / 2, sum.m22 - g.y * fy};
      whole += doubled_area(m, t) / 6;
    }
    if (whole > 0) second[v] = {sum.m11 / whole, sum.m12 / whole, sum.m22 / whole};
  });
  return second;
}

}  // namespace asterism::internal
