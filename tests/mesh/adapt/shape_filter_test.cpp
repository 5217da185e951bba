// SPDX-License-Identifier: MIT
//
// Replaces the shapes of single nodes that are noise by shapes of their neighbours. Densities stay.
#include "asterism/mesh/adapt/shape_filter.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/metric/background_metric.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::adapting;

namespace {

constexpr vertex_index row = 7, middle = 3 * row + 3;

// A grid with nodes numbered row by row. Its metric has aspect 4 along x, and is ten times denser
// at the right end.
mesh grid() {
  mesh m;
  for (vertex_index j = 0; j < row; ++j)
    for (vertex_index i = 0; i < row; ++i) {
      const double size = std::pow(10, static_cast<double>(i) / row);
      m.sites.push_back({{static_cast<double>(i), static_cast<double>(j)}, {size, 0, 16 * size}});
    }
  for (vertex_index j = 0; j + 1 < row; ++j)
    for (vertex_index i = 0; i + 1 < row; ++i) {
      const vertex_index a = j * row + i;
      m.triangles.push_back({a, a + 1, a + row + 1});
      m.triangles.push_back({a, a + row + 1, a + row});
    }
  return m;
}

double determinant(const metric_tensor& t) { return t.m11 * t.m22 - t.m12 * t.m12; }

bool all_but_one_are_as_before(const mesh& m, const std::vector<metric_tensor>& made,
                               vertex_index but) {
  bool same = true;
  for (vertex_index v = 0; v < made.size(); ++v)
    same = same && (v == but || identical(made[v], m.sites[v].metric));
  return same;
}

}  // namespace

TEST_CASE("a metric without noise keeps its tensors to the last bit") {
  const mesh m = grid();
  CHECK(all_but_one_are_as_before(m, without_noise(background_metric(m)), row * row));
}

TEST_CASE("a small tensor that is turned gets the shape around, and keeps its density") {
  mesh m = grid();
  metric_tensor& turned = m.sites[middle].metric;
  turned = {turned.m22 / 2, 0, turned.m11 / 2};
  const double density = determinant(turned);
  const std::vector<metric_tensor> made = without_noise(background_metric(m));
  CHECK(made[middle].m22 == Approx(16 * made[middle].m11));
  CHECK(determinant(made[middle]) == Approx(density));
  CHECK(all_but_one_are_as_before(m, made, middle));
}

TEST_CASE("a peak of the density keeps its shape, as a feature at a single node is one") {
  mesh m = grid();
  metric_tensor& turned = m.sites[middle].metric;
  turned = {turned.m22 * 2, 0, turned.m11 * 2};
  CHECK(all_but_one_are_as_before(m, without_noise(background_metric(m)), row * row));
}
