// SPDX-License-Identifier: MIT
//
// Changes tensors of copies of a background: lists are shared until they differ.
#include "asterism/mesh/metric/background_metric.hpp"

#include <catch2/catch.hpp>
#include <utility>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

mesh two_triangles() {
  mesh m;
  m.sites = {{{0, 0}, {1, 0, 1}}, {{1, 0}, {2, 0, 1}}, {{1, 1}, {3, 1, 2}}, {{0, 1}, {1, 0, 4}}};
  m.triangles = {{0, 1, 2}, {0, 2, 3}};
  return m;
}

}  // namespace

TEST_CASE("copies of a background share its tensors until they get others") {
  const mesh m = two_triangles();
  const background_metric original(m);
  background_metric copy = original;
  CHECK(copy.tensors().data() == original.tensors().data());
  const std::vector<metric_tensor> same = original.tensors();
  copy.set_tensors(same);
  CHECK(copy.tensors().data() == original.tensors().data());
  std::vector<metric_tensor> other = same;
  other[2] = {5, 0, 5};
  copy.set_tensors(std::move(other));
  CHECK(identical(original.tensors()[2], m.sites[2].metric));
  CHECK(identical(original.at(m.sites[2].position), m.sites[2].metric));
  CHECK(identical(copy.at(m.sites[2].position), {5, 0, 5}));
  mesh changed = m;
  changed.sites[2].metric = {5, 0, 5};
  const background_metric anew(changed);
  for (const point q : {point{0.5, 0.25}, point{0.25, 0.5}, point{0.9, 0.6}})
    CHECK(identical(copy.at(q), anew.at(q)));
}
